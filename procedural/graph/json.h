#pragma once
// A texture graph as JSON (docs/reference/nodes.md): a tree of nodes, each an object with its name
// under "node", its inputs and its parameters. A number, or a colour "#rrggbb" or "#rrggbbaa",
// stands for a constant node.
#include <functional>
#include <memory>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "procedural/graph/graph.h"

namespace burl {

/// Whether a recipe's "texture" is anything but a color_map over a field, of which graph_from_json
/// makes a plain graph.
bool is_graph(const nlohmann::ordered_json& texture);

/// Reads an image by the name that a recipe gives it; nodes of one image may share its MIP map.
using ImageReader =
    std::function<std::shared_ptr<const MipImage>(const std::string& file, ImageWrap wrap)>;

/// Whether the value, in the place of a node, is a name of the recipe's `define`: a string that is
/// no colour.
bool is_graph_name(const nlohmann::ordered_json& json);

/// Whether a channel's value in "material" is a node or a name, rather than a number or colour.
bool is_graph_channel(const nlohmann::ordered_json& json);

/// Reads a recipe's "texture", which must have been checked: nodes, keys, types, ranges, depth.
/// `read_image` must be given if the texture has images; its exceptions pass through.
TextureGraph graph_from_json(const nlohmann::ordered_json& texture,
                             const ImageReader& read_image = {});

/// Reads "texture" with the channels of "material" that are nodes, and the names of "define"; null
/// stands for an absent part. Nodes of a name are shared at each point of evaluation.
TextureGraph material_from_json(const nlohmann::ordered_json& texture,
                                const nlohmann::ordered_json& material,
                                const nlohmann::ordered_json& define,
                                const ImageReader& read_image = {});

/// Reads a node that gives a number, as "bump.input" has; of "define" only the names that it uses.
TextureGraph scalar_from_json(const nlohmann::ordered_json& input,
                              const nlohmann::ordered_json& define,
                              const ImageReader& read_image = {});

/// JSON of the base colour that graph_from_json reads back to an equal graph.
nlohmann::ordered_json graph_to_json(const TextureGraph& graph);

/// JSON of the other channels, and of the names.
nlohmann::ordered_json channels_to_json(const TextureGraph& graph);
nlohmann::ordered_json names_to_json(const TextureGraph& graph);

}  // namespace burl
