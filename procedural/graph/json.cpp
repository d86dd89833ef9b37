#include "procedural/graph/json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "atlas/base/json.h"
#include "procedural/graph/table.h"
#include "procedural/model/texture_json.h"

namespace burl {

namespace {

using Json = nlohmann::ordered_json;

/// The type of a JSON node; the recipe's texture itself may leave its kind out, which is color_map.
const NodeType& node_type(const Json& json) {
    return *find_node(json.contains("node") ? json["node"].get<std::string>() : "color_map");
}

std::uint32_t index_of(const NodeType& type) {
    return std::uint32_t(&type - graph_table().data());
}

/// The index of `word` among the words of a choice.
double choice_index(std::string_view choices, std::string_view word) {
    const auto words = split_choices(choices);
    return double(std::ranges::find(words, word) - words.begin());
}

/// Appends a parameter's numbers to `all`: an infinity for null, nothing for text.
void append_parameter(const Parameter& parameter, const Json& value, std::vector<double>& all) {
    // A text parameter is stored with the node's image.
    if (parameter.type == ParameterType::text) return;
    if (value.is_null())
        all.push_back(std::numeric_limits<double>::infinity());
    else if (parameter.type == ParameterType::choice)
        all.push_back(choice_index(parameter.choices, value.get<std::string>()));
    else if (parameter.type == ParameterType::numbers)
        for (const Json& number : value) all.push_back(number.get<double>());
    else
        all.push_back(value.get<double>());
}

Json parameter_json(const Parameter& parameter, const double* values) {
    if (parameter.type == ParameterType::choice)
        return split_choices(parameter.choices)[std::size_t(values[0])];
    if (parameter.type == ParameterType::integer) return std::int64_t(values[0]);
    if (parameter.type == ParameterType::number) return values[0];
    return std::vector<double>(values, values + parameter.count);
}

/// Whether `json` is an object whose node is `name` or left out.
bool is_node(const Json& json, std::string_view name) {
    if (!json.is_object()) return false;
    return !json.contains("node") || json["node"] == name;
}

/// Builds a graph from JSON, with every node after its inputs.
class GraphReader {
  public:
    /// `define` has the nodes that names stand for; null: none.
    GraphReader(const ImageReader& read_image, const Json* define)
        : read_image_(read_image), define_(define) {
        graph_.nodes.push_back({0, Wire::point, 0, {}, {}, no_texture, no_texture});
        if (!define) return;
        for (const auto& item : define->items()) graph_.names.push_back({item.key(), {}});
    }

    void read_base(const Json& texture) {
        graph_.result = is_graph(texture) ? read_node(texture, 0) : read_plain(texture);
    }
    void read_channels(const Json& material) {
        for (std::size_t i = 0; i < enum_names<Channel>.size(); ++i) {
            const std::string key(enum_names<Channel>[i]);
            if (material.contains(key) && is_graph_channel(material[key]))
                graph_.channels.push_back({Channel(i), read_node(material[key], 0)});
        }
    }
    void read_scalar(const Json& input) { graph_.result = read_node(input, 0); }
    /// Reads the names that nobody uses, so that they are not lost.
    void read_unused_names() {
        for (std::size_t i = 0; i < graph_.names.size(); ++i)
            if (graph_.names[i].uses.empty()) read_name(graph_.names[i].name, 0);
    }
    TextureGraph finish() {
        std::erase_if(graph_.names, [](const GraphName& name) { return name.uses.empty(); });
        return std::move(graph_);
    }

  private:
    /// Reads a colour map over a field, the nodes of plain_graph.
    std::uint32_t read_plain(const Json& texture) {
        TextureGraph plain = plain_graph(texture_from_json(texture));
        graph_.textures = std::move(plain.textures);
        for (std::size_t n = 1; n < plain.nodes.size(); ++n) push(std::move(plain.nodes[n]));
        return plain.result;
    }

    /// The node of a name at a place, which is read where it is first used there.
    std::uint32_t read_name(const std::string& name, std::uint32_t place) {
        const auto known = std::size_t(std::ranges::find(graph_.names, name, &GraphName::name) -
                                       graph_.names.begin());
        const auto& uses = graph_.names[known].uses;
        const auto used = std::ranges::find(uses, place, &NamedNode::place);
        if (used != uses.end()) return used->node;
        const std::uint32_t node = read_node((*define_)[name], place);
        graph_.names[known].uses.push_back({node, place});
        return node;
    }

    std::uint32_t push(GraphNode node) {
        graph_.nodes.push_back(std::move(node));
        return std::uint32_t(graph_.nodes.size() - 1);
    }

    std::uint32_t read_constant(const Json& value, std::uint32_t place) {
        GraphNode node{
            index_of(*find_node("constant")), Wire::number, place, {}, {}, no_texture, no_texture};
        if (value.is_number()) {
            node.parameters = {value.get<double>()};
        } else {
            const std::string text = value.get<std::string>();
            const Rgb8 color = color_from_hex(text);
            node.wire = Wire::color;
            node.parameters = {double(color.r), double(color.g), double(color.b),
                               double(alpha_from_hex(text))};
        }
        return push(std::move(node));
    }

    /// Reads the texture of the nodes color_map and field; no_texture for other types.
    std::uint32_t read_texture(const NodeType& type, const Json& json) {
        if (type.name != "color_map" && type.name != "field") return no_texture;
        Json model = json;
        if (type.name == "color_map") model.erase("input");
        graph_.textures.push_back(
            texture_from_json(type.name == "field" ? Json{{"input", std::move(model)}} : model));
        if (type.name == "field") graph_.textures.back().colors = {};
        return std::uint32_t(graph_.textures.size() - 1);
    }

    /// Reads the image of the node image; no_texture for other types.
    std::uint32_t read_image(const NodeType& type, const Json& json) {
        if (type.name != "image") return no_texture;
        const std::string file = json["file"].get<std::string>();
        const std::string wrap = json.value("wrap", "repeat");
        const ImageWrap beyond = wrap == "black"   ? ImageWrap::black
                                 : wrap == "clamp" ? ImageWrap::clamp
                                                   : ImageWrap::repeat;
        graph_.images.push_back({file, read_image_(file, beyond)});
        return std::uint32_t(graph_.images.size() - 1);
    }

    /// The type of a node's result, given its inputs.
    Wire wire_of(const NodeType& type, const std::vector<std::uint32_t>& inputs) const {
        if (type.result == NodeResult::number) return Wire::number;
        if (type.result == NodeResult::color) return Wire::color;
        for (std::size_t k = 0; k < inputs.size(); ++k)
            if (type.inputs()[k].sets_wire && graph_.nodes[inputs[k]].wire == Wire::color)
                return Wire::color;
        return Wire::number;
    }

    std::uint32_t read_node(const Json& json, std::uint32_t place) {
        if (is_graph_name(json)) return read_name(json.get<std::string>(), place);
        if (!json.is_object()) return read_constant(json, place);
        const NodeType& type = node_type(json);
        if (type.name == "constant") return read_constant(json["value"], place);
        GraphNode node{index_of(type), Wire::point, place, {}, {}, no_texture, no_texture};
        for (const Parameter& parameter : type.parameters())
            append_parameter(parameter,
                             json.contains(parameter.path) ? json[std::string(parameter.path)]
                                                           : Json::parse(parameter.default_value),
                             node.parameters);
        if (type.result == NodeResult::inner) {
            const std::uint32_t moved = push(std::move(node));
            return read_node(json["input"], moved);
        }
        for (const NodeInput& input : type.inputs())
            node.inputs.push_back(read_node(json.contains(input.key) ? json[std::string(input.key)]
                                                                     : Json::parse(input.fallback),
                                            place));
        node.wire = wire_of(type, node.inputs);
        node.texture = read_texture(type, json);
        node.image = read_image(type, json);
        return push(std::move(node));
    }

    const ImageReader& read_image_;
    const Json* define_;
    TextureGraph graph_;
};

/// Writes a graph as JSON.
class GraphWriter {
  public:
    explicit GraphWriter(const TextureGraph& graph) : graph_(graph) {}

    /// The JSON of a node as an input of one that is evaluated at `place`: the nodes that make the
    /// points in between are wrapped around it, or around the last name that stands for it. The
    /// node that `defined` names is written out.
    Json write(std::uint32_t index, std::uint32_t place, const std::string& defined = "") const {
        const GraphNode& node = graph_.nodes[index];
        std::uint32_t at = node.place;
        Json json = named(index, at, defined);
        if (json.is_null()) json = write_inner(node);
        while (at != place) {
            Json outer = write_keys(graph_.nodes[at]);
            outer["input"] = std::move(json);
            at = graph_.nodes[at].place;
            Json name = named(index, at, defined);
            json = name.is_null() ? std::move(outer) : std::move(name);
        }
        return json;
    }

    Json write_names() const {
        Json json = Json::object();
        for (const auto& [name, uses] : graph_.names)
            json[name] = write(uses.front().node, uses.front().place, name);
        return json;
    }

  private:
    /// The name that stands for the node at a place, other than `defined`; null if there is none.
    Json named(std::uint32_t index, std::uint32_t place, const std::string& defined) const {
        for (const auto& [name, uses] : graph_.names)
            if (name != defined && std::ranges::count(uses, NamedNode{index, place})) return name;
        return {};
    }

    Json write_inner(const GraphNode& node) const {
        const NodeType& type = type_of(node);
        if (type.name == "constant") return write_constant(node);
        Json json = write_keys(node);
        for (std::size_t k = 0; k < node.inputs.size(); ++k)
            json[std::string(type.inputs()[k].key)] = write(node.inputs[k], node.place);
        return json;
    }

    Json write_constant(const GraphNode& node) const {
        const std::vector<double>& p = node.parameters;
        if (node.wire == Wire::number) return p[0];
        return color_to_hex({std::uint8_t(p[0]), std::uint8_t(p[1]), std::uint8_t(p[2])},
                            std::uint8_t(p[3]));
    }

    Json write_keys(const GraphNode& node) const {
        const NodeType& type = type_of(node);
        Json json{{"node", type.name}};
        if (node.texture != no_texture) {
            Json model = texture_to_json(graph_.textures[node.texture]);
            if (type.name == "field") return model["input"];
            model.erase("input");
            return model;
        }
        std::size_t at = 0;
        for (const Parameter& parameter : type.parameters()) {
            if (parameter.type == ParameterType::text) {
                json[std::string(parameter.path)] = graph_.images[node.image].file;
                continue;
            }
            if (std::isfinite(node.parameters[at]))
                json[std::string(parameter.path)] = parameter_json(parameter, &node.parameters[at]);
            at += parameter.count;
        }
        return json;
    }

    const TextureGraph& graph_;
};

}  // namespace

bool is_graph(const Json& texture) {
    if (is_graph_name(texture)) return true;
    if (!texture.is_object()) return false;
    if (!is_node(texture, "color_map")) return true;
    return texture.contains("input") && !is_node(texture["input"], "field");
}

bool is_graph_name(const Json& json) {
    return json.is_string() && !json.get_ref<const std::string&>().starts_with('#');
}

bool is_graph_channel(const Json& json) {
    return json.is_object() || is_graph_name(json);
}

TextureGraph graph_from_json(const Json& texture, const ImageReader& read_image) {
    return material_from_json(texture, {}, {}, read_image);
}

TextureGraph material_from_json(const Json& texture, const Json& material, const Json& define,
                                const ImageReader& read_image) {
    GraphReader reader(read_image, define.is_object() ? &define : nullptr);
    reader.read_base(texture);
    reader.read_channels(material);
    reader.read_unused_names();
    return reader.finish();
}

TextureGraph scalar_from_json(const Json& input, const Json& define,
                              const ImageReader& read_image) {
    GraphReader reader(read_image, define.is_object() ? &define : nullptr);
    reader.read_scalar(input);
    return reader.finish();
}

Json graph_to_json(const TextureGraph& graph) {
    Json json = GraphWriter(graph).write(graph.result, 0);
    if (json.is_object() || is_graph_name(json)) return json;
    return {{"node", "constant"}, {"value", std::move(json)}};
}

Json channels_to_json(const TextureGraph& graph) {
    Json json = Json::object();
    for (const auto& [channel, node] : graph.channels) {
        Json value = GraphWriter(graph).write(node, 0);
        if (!is_graph_channel(value)) value = {{"node", "constant"}, {"value", std::move(value)}};
        json[std::string(to_string(channel))] = std::move(value);
    }
    return json;
}

Json names_to_json(const TextureGraph& graph) {
    return GraphWriter(graph).write_names();
}

}  // namespace burl
