#include "app/edit/node_graph.h"

#include <algorithm>
#include <map>
#include <utility>

#include "app/edit/node_kinds.h"
#include "app/edit/node_words.h"
#include "app/edit/tree.h"
#include "app/recipe/edit/leaves.h"
#include "app/recipe/schema_check.h"
#include "atlas/base/json.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

class GraphList {
  public:
    explicit GraphList(const Recipe& recipe)
        : tree_(recipe), json_(slider_json(recipe)), words_(node_words(json_)) {}

    NodeGraph list() {
        GraphNodeView material{"material", "material", "", "material", Wire::color};
        graph_.nodes.push_back(material);
        add_part("base_color", "texture", Wire::color, "what the surface looks like");
        for (std::size_t i = 0; i < enum_names<Channel>.size(); ++i)
            add_channel(std::string(enum_names<Channel>[i]),
                        is_color(Channel(i)) ? Wire::color : Wire::number);
        if (part_of(json_, "bump").contains("input"))
            add_part("height", "bump.input", Wire::number, "what rises from the surface");
        for (const auto& item : part_of(json_, "define").items())
            add_node(item.value(), "define." + item.key());
        connect();
        return std::move(graph_);
    }

  private:
    /// Adds a channel that is a node.
    void add_channel(const std::string& channel, Wire wire) {
        const Json& material = part_of(json_, "material");
        if (!material.contains(channel) || !is_graph_channel(material[channel])) return;
        const RecipeParameter* parameter = find_parameter("material." + channel);
        add_part(channel, "material." + channel, wire,
                 parameter ? std::string(parameter->tip) : std::string());
    }

    /// Adds an input of the material and the nodes behind it.
    void add_part(const std::string& key, const std::string& place, Wire wire, std::string tip) {
        GraphInput input{key, part_words(place), place, wire, std::move(tip)};
        const Json value = tree_.content(place);
        if (is_constant(value)) input.constant = value["value"];
        graph_.nodes[0].inputs.push_back(std::move(input));
        if (!is_constant(value)) add_node(json_at(place), place);
    }

    const Json& json_at(const std::string& place) const {
        const Json* at = &json_;
        for (const std::string_view part : split_path(place)) at = &(*at)[std::string(part)];
        return *at;
    }

    /// Adds the node of a part, if the value is one, and those below it.
    void add_node(const Json& value, const std::string& place) {
        const std::string name = defined_at(place);
        if (!is_node(value)) {
            if (name.empty()) return;
            graph_.nodes.push_back({place, "constant", name, name, wire_of(value), {}, value});
            return;
        }
        const NodeType& type = type_of(value);
        GraphNodeView node{place, std::string(type.name), name, words_[place], tree_.gives(value)};
        node.json = value;
        node.terms = value.contains("noise") ? value["noise"].size() : 0;
        for (const NodeInput& input : type.inputs())
            node.inputs.push_back(view(input, value, place));
        graph_.nodes.push_back(std::move(node));
        for (const NodeInput& input : type.inputs())
            if (value.contains(input.key))
                add_node(value[std::string(input.key)], join_path(place, input.key));
    }

    static Wire wire_of(const Json& constant) {
        return constant.is_string() ? Wire::color : Wire::number;
    }

    static GraphInput view(const NodeInput& input, const Json& node, const std::string& place) {
        GraphInput view{std::string(input.key), spoken(input.key), join_path(place, input.key),
                        input.wire, std::string(input.tip)};
        const bool there = node.contains(input.key);
        const Json value = there                    ? node[view.key]
                           : input.fallback.empty() ? Json()
                                                    : Json::parse(input.fallback);
        if (!is_node(value) && !is_graph_name(value)) view.constant = value;
        return view;
    }

    /// Finds the nodes at the other ends of wires.
    void connect() {
        for (GraphNodeView& node : graph_.nodes)
            for (GraphInput& input : node.inputs) {
                if (!input.constant.is_null()) continue;
                input.from = graph_.find(input.place);
                if (input.from) continue;
                const Json* value = tree_.find(input.place);
                if (!value || !is_graph_name(*value)) continue;
                input.from = graph_.find("define." + value->get<std::string>());
                input.by_name = true;
            }
    }

    RecipeTree tree_;
    Json json_;
    NodeWords words_;
    NodeGraph graph_;
};

}  // namespace

std::optional<std::size_t> NodeGraph::find(const std::string& place) const {
    const auto found = std::ranges::find(nodes, place, &GraphNodeView::place);
    if (found == nodes.end()) return {};
    return std::size_t(found - nodes.begin());
}

NodeGraph node_graph(const Recipe& recipe) {
    return GraphList(recipe).list();
}

std::vector<std::size_t> users_of(const NodeGraph& graph, std::size_t node) {
    std::vector<std::size_t> users;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i)
        if (std::ranges::any_of(graph.nodes[i].inputs,
                                [&](const GraphInput& input) { return input.from == node; }))
            users.push_back(i);
    return users;
}

}  // namespace burl
