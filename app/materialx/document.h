#pragma once
// A MaterialX file as a tree of elements with the lines they stand in.
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "atlas/base/error.h"

namespace burl::materialx {

/// An element of the file: a node, an input, a graph.
struct Element {
    std::string tag;
    std::vector<std::pair<std::string, std::string>> attributes{};
    std::vector<Element> children{};
    std::size_t line = 0;

    /// The value of an attribute; null where it is left out.
    const std::string* find(std::string_view attribute) const;
    /// The value of an attribute; empty where it is left out.
    std::string text(std::string_view attribute) const;
    /// The attribute `name`.
    std::string name() const { return text("name"); }
    /// The child with the tag and the name; null where there is none.
    const Element* child(std::string_view child_tag, std::string_view child_name) const;
};

/// A document; elements stay where they are while it lives.
struct Document {
    std::string path;  ///< the file's name, for messages
    Element root;      ///< the element `materialx`

    /// "path:line: message" as an Error(invalid_file).
    Error error(const Element& at, const std::string& message) const;
};

/// Parses the text of a file called `path`. Throws Error(invalid_file) with path and line for what
/// is no XML, for a root other than `materialx`, for versions other than 1.38 and 1.39, and for
/// elements more than 64 deep.
Document parse_document(const std::string& text, const std::string& path);

}  // namespace burl::materialx
