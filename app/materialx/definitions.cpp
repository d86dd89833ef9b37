#include "app/materialx/definitions.h"

#include <algorithm>
#include <array>

namespace burl::materialx {

namespace {

/// The elements that are no nodes.
constexpr std::array<std::string_view, 22> other_tags{
    "input",          "output",     "token",       "nodegraph",     "nodedef",
    "implementation", "typedef",    "geompropdef", "look",          "lookgroup",
    "collection",     "geominfo",   "propertyset", "property",      "propertyassign",
    "materialassign", "variantset", "variant",     "variantassign", "unitdef",
    "unittypedef",    "targetdef"};

/// The graph that implements a definition.
const Element* graph_of(const Document& document, const std::string& definition) {
    for (const Element& one : document.root.children) {
        if (one.text("nodedef") != definition) continue;
        if (one.tag == "nodegraph") return &one;
        if (one.tag == "implementation" && one.find("nodegraph"))
            return document.root.child("nodegraph", one.text("nodegraph"));
    }
    return nullptr;
}

/// The type of a definition's result.
std::string type_of(const Element& definition) {
    const auto is_output = [](const Element& one) { return one.tag == "output"; };
    const auto outputs = std::ranges::count_if(definition.children, is_output);
    if (outputs == 0) return definition.text("type");
    if (outputs > 1) return "multioutput";
    return std::ranges::find_if(definition.children, is_output)->text("type");
}

/// Whether the node can be one of the definition: its type and its inputs' types are those.
bool fits(const Element& definition, const Element& node) {
    const std::string type = type_of(definition);
    if (type != node.text("type") && type != "multioutput") return false;
    return std::ranges::all_of(node.children, [&](const Element& one) {
        if (one.tag != "input") return true;
        const Element* input = definition.child("input", one.name());
        return input && input->text("type") == one.text("type");
    });
}

}  // namespace

bool is_node(const Element& element) {
    return std::ranges::find(other_tags, element.tag) == other_tags.end();
}

OwnDefinition own_definition(const Document& document, const Element& node) {
    const std::string named = node.text("nodedef");
    for (const Element& one : document.root.children) {
        if (one.tag != "nodedef" || one.text("node") != node.tag) continue;
        if (named.empty() ? !fits(one, node) : one.name() != named) continue;
        if (const Element* graph = graph_of(document, one.name())) return {&one, graph};
    }
    return {};
}

}  // namespace burl::materialx
