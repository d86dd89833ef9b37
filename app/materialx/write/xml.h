#pragma once
// XML as text, of the form that MaterialX's own documents have.
#include <string>
#include <utility>
#include <vector>

namespace burl::materialx {

/// An element to be written. Texts are UTF-8.
struct XmlElement {
    std::string tag;
    std::vector<std::pair<std::string, std::string>> attributes{};
    std::vector<XmlElement> children{};
    std::string comment{};  ///< a line before the element; may be empty

    /// Adds a child and returns it; it stays where it is until the next one is added.
    XmlElement& add(XmlElement child) { return children.emplace_back(std::move(child)); }
};

/// A document of that root, two spaces a level, ending in a line break. Control characters, which
/// XML has no way to hold, become question marks, but for tabs and line breaks of attributes.
std::string xml_text(const XmlElement& root);

/// The text as the name of an element: letters, digits and underscores of ASCII, no digit first;
/// empty texts and all other characters become underscores.
std::string element_name(const std::string& text);

/// An input of a node or surface, `<input name= type= value= />`.
XmlElement value_input(const std::string& name, const std::string& type, const std::string& value);
XmlElement number_input(const std::string& name, double value);
/// An input that is fed by a node beside it.
XmlElement node_input(const std::string& name, const std::string& type, const std::string& node);

/// The number as shaders in float32 hold it, in the fewest digits that give it back: "0.1".
std::string value_text(double number);

}  // namespace burl::materialx
