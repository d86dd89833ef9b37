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

/// Reads a recipe's "texture", which must have been checked: nodes, keys, types, ranges, depth.
/// `read_image` must be given if the texture has images; its exceptions pass through.
TextureGraph graph_from_json(const nlohmann::ordered_json& texture,
                             const ImageReader& read_image = {});

/// JSON that graph_from_json reads back to an equal graph.
nlohmann::ordered_json graph_to_json(const TextureGraph& graph);

}  // namespace burl
