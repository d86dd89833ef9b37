#pragma once
// The elements of an XML text of elements and attributes alone, in their order, read without any
// of the program's code.
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace burl {

/// An element with the tags of those around it.
struct FoundElement {
    std::string tag, inside;  ///< inside: the name attribute of the element around it, or its tag
    std::map<std::string, std::string> attributes{};

    std::string operator[](const std::string& name) const {
        const auto found = attributes.find(name);
        return found == attributes.end() ? "" : found->second;
    }
};

inline FoundElement element_of(std::string text) {
    FoundElement element;
    const std::size_t end = text.find_first_of(" />");
    element.tag = text.substr(0, end);
    for (std::size_t at = end; (at = text.find('=', at)) != std::string::npos;) {
        const std::size_t name = text.rfind(' ', at) + 1, close = text.find('"', at + 2);
        element.attributes[text.substr(name, at - name)] = text.substr(at + 2, close - at - 2);
        at = close;
    }
    return element;
}

inline std::vector<FoundElement> xml_elements(const std::string& text) {
    std::vector<FoundElement> found;
    std::vector<std::string> open;
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) {
        const bool comment = text.compare(at, 4, "<!--") == 0;
        const std::size_t end = comment ? text.find("-->", at) + 2 : text.find('>', at);
        const std::string inner = text.substr(at + 1, end - at - 1);
        at = end;
        if (comment || inner[0] == '?') continue;
        if (inner[0] == '/') {
            open.pop_back();
            continue;
        }
        FoundElement element = element_of(inner);
        if (!open.empty()) element.inside = open.back();
        if (!inner.ends_with('/'))
            open.push_back(element["name"].empty() ? element.tag : element["name"]);
        found.push_back(std::move(element));
    }
    EXPECT_TRUE(open.empty()) << text;
    return found;
}

/// Expects that whatever an input or an output refers to is there, and names are unique in their
/// graph.
inline void expect_whole_document(const std::string& text) {
    const std::vector<FoundElement> all = xml_elements(text);
    std::map<std::string, int> names;  // "graph/name"
    for (const FoundElement& one : all)
        if (one.tag != "input") ++names[one.inside + '/' + one["name"]];
    for (const auto& [name, count] : names) EXPECT_EQ(count, 1) << name;
    std::map<std::string, std::string> graphs;  // of nodes
    for (const FoundElement& one : all) graphs[one["name"]] = one.inside;
    for (const FoundElement& one : all) {
        const std::string graph = one.tag == "output" ? one.inside : graphs[one.inside];
        const std::string node = one["nodename"], other = one["nodegraph"];
        EXPECT_TRUE(node.empty() || names.contains(graph + '/' + node)) << node;
        EXPECT_TRUE(other.empty() || names.contains(other + '/' + one["output"])) << other;
    }
}

}  // namespace burl
