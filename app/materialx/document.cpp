#include "app/materialx/document.h"

#include <algorithm>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "atlas/base/utf8.h"

namespace burl::materialx {

namespace {

constexpr std::size_t deepest_element = 64;

/// Finds the lines of places in a text, which are asked for in any order.
class Lines {
  public:
    explicit Lines(const std::string& text) {
        for (std::size_t at = text.find('\n'); at != std::string::npos;
             at = text.find('\n', at + 1))
            ends_.push_back(at);
    }
    std::size_t line_of(std::ptrdiff_t offset) const {
        const auto place = std::size_t(std::max<std::ptrdiff_t>(offset, 0));
        return std::size_t(std::ranges::lower_bound(ends_, place) - ends_.begin()) + 1;
    }

  private:
    std::vector<std::size_t> ends_;
};

/// The element's tag; of the long form <node nodetype="add"> the node's category.
std::string tag_of(const pugi::xml_node& from) {
    const pugi::xml_attribute category = from.attribute("nodetype");
    return from.name() == std::string_view("node") && category ? category.value() : from.name();
}

/// Copies an element with all below it.
class ElementCopier {
  public:
    ElementCopier(const Lines& lines, const std::string& path) : lines_(lines), path_(path) {}

    Element copy(const pugi::xml_node& from, std::size_t depth) const {
        Element element{tag_of(from), {}, {}, lines_.line_of(from.offset_debug())};
        if (depth > deepest_element)
            throw invalid_file(path_, element.line,
                               fmt::format("elements are more than {} deep", deepest_element));
        check_text(element.tag, element.line);
        for (const pugi::xml_attribute& one : from.attributes()) {
            check_text(one.name(), element.line);
            check_text(one.value(), element.line);
            if (element.find(one.name()))
                throw invalid_file(path_, element.line,
                                   fmt::format("<{}> has \"{}\" twice", element.tag, one.name()));
            element.attributes.emplace_back(one.name(), one.value());
        }
        for (const pugi::xml_node& one : from.children())
            if (one.type() == pugi::node_element) element.children.push_back(copy(one, depth + 1));
        return element;
    }

  private:
    void check_text(const std::string& text, std::size_t line) const {
        if (!is_utf8(text))
            throw invalid_file(path_, line, "the text is not UTF-8; save the file as UTF-8");
    }

    const Lines& lines_;
    const std::string& path_;
};

void check_root(const Document& document) {
    if (document.root.tag != "materialx")
        throw document.error(
            document.root, fmt::format("the root is <{}>, must be <materialx>", document.root.tag));
    const std::string version = document.root.text("version");
    if (version != "1.38" && version != "1.39" && !version.starts_with("1.38.") &&
        !version.starts_with("1.39."))
        throw document.error(document.root,
                             fmt::format("the version is \"{}\", must be 1.38 or 1.39", version));
}

}  // namespace

const std::string* Element::find(std::string_view attribute) const {
    for (const auto& [key, value] : attributes)
        if (key == attribute) return &value;
    return nullptr;
}

std::string Element::text(std::string_view attribute) const {
    const std::string* value = find(attribute);
    return value ? *value : std::string();
}

const Element* Element::child(std::string_view child_tag, std::string_view child_name) const {
    for (const Element& one : children)
        if (one.tag == child_tag && one.name() == child_name) return &one;
    return nullptr;
}

Error Document::error(const Element& at, const std::string& message) const {
    return invalid_file(path, at.line, message);
}

Document parse_document(const std::string& text, const std::string& path) {
    const Lines lines(text);
    pugi::xml_document xml;
    const pugi::xml_parse_result result =
        xml.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result)
        throw invalid_file(path, lines.line_of(result.offset),
                           fmt::format("no XML: {}", result.description()));
    Document document{path, ElementCopier(lines, path).copy(xml.document_element(), 0)};
    check_root(document);
    return document;
}

}  // namespace burl::materialx
