#include "app/materialx/write/xml.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

namespace burl::materialx {

namespace {

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else if (c == '\t' || c == '\n' || c == '\r')
            out += fmt::format("&#{};", int(c));
        else
            out += std::uint8_t(c) < 0x20 || c == 0x7f ? '?' : c;
    }
    return out;
}

/// The text of a comment, which ends at two hyphens.
std::string in_comment(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '-' && out.ends_with('-')) out += ' ';
        out += std::uint8_t(c) < 0x20 || c == 0x7f ? ' ' : c;
    }
    return out;
}

void print(const XmlElement& element, std::size_t depth, std::string& out) {
    const std::string margin(2 * depth, ' ');
    if (!element.comment.empty())
        out += fmt::format("{}<!-- {} -->\n", margin, in_comment(element.comment));
    out += fmt::format("{}<{}", margin, element.tag);
    for (const auto& [name, value] : element.attributes)
        out += fmt::format(" {}=\"{}\"", name, escaped(value));
    if (element.children.empty()) {
        out += " />\n";
        return;
    }
    out += ">\n";
    for (const XmlElement& child : element.children) print(child, depth + 1, out);
    out += fmt::format("{}</{}>\n", margin, element.tag);
}

bool is_letter_or_digit(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

}  // namespace

std::string xml_text(const XmlElement& root) {
    std::string out = "<?xml version=\"1.0\"?>\n";
    print(root, 0, out);
    return out;
}

std::string element_name(const std::string& text) {
    std::string name = text;
    std::ranges::replace_if(
        name, [](char c) { return !is_letter_or_digit(c); }, '_');
    if (name.empty() || (name[0] >= '0' && name[0] <= '9')) name.insert(0, "_");
    return name;
}

XmlElement value_input(const std::string& name, const std::string& type, const std::string& value) {
    return {"input", {{"name", name}, {"type", type}, {"value", value}}};
}

XmlElement number_input(const std::string& name, double value) {
    return value_input(name, "float", value_text(value));
}

XmlElement node_input(const std::string& name, const std::string& type, const std::string& node) {
    return {"input", {{"name", name}, {"type", type}, {"nodename", node}}};
}

std::string value_text(double number) {
    return fmt::format("{}", float(number));
}

}  // namespace burl::materialx
