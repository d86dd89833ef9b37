#pragma once
// A texture as a graph of nodes (docs/reference/nodes.md): what the JSON tree of a recipe says when
// it is more than a colour map over a field. A plain comparable value: nodes in an order in which
// every node comes after those it reads, so that evaluating them one after the other needs no
// recursion.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "procedural/graph/mip_image.h"
#include "procedural/model/texture.h"

namespace burl {

/// What a node gives, as its number of channels: a number, the point at which other nodes are
/// evaluated, or a colour (linear light, multiplied by its alpha, and alpha).
enum class Wire : std::uint8_t { number = 1, point = 3, color = 4 };

inline constexpr std::uint32_t no_texture = 0xffffffffu;

struct GraphNode {
    std::uint32_t type = 0;              ///< index into graph_table()
    Wire wire = Wire::number;            ///< what it gives
    std::uint32_t place = 0;             ///< the node whose point it is evaluated at
    std::vector<std::uint32_t> inputs;   ///< nodes, in the table's order
    std::vector<double> parameters;      ///< in the table's order; a choice is its index
    std::uint32_t texture = no_texture;  ///< into TextureGraph::textures: of color_map and field
    std::uint32_t image = no_texture;    ///< into TextureGraph::images: of image
    bool operator==(const GraphNode&) const = default;
};

/// A file and what was read from it.
struct GraphImage {
    std::string file;  ///< as the recipe names it
    std::shared_ptr<const MipImage> pixels;
    bool operator==(const GraphImage& other) const {
        return file == other.file && *pixels == *other.pixels;
    }
};

struct TextureGraph {
    /// nodes[0] is the solid point, the last one the result; empty: no graph.
    std::vector<GraphNode> nodes;
    std::vector<Texture> textures;
    std::vector<GraphImage> images;

    bool empty() const { return nodes.empty(); }
    bool operator==(const TextureGraph&) const = default;
};

/// More than anyone draws by hand, and little enough that no recipe takes an hour.
inline constexpr std::size_t max_graph_depth = 64, max_graph_nodes = 1000;

}  // namespace burl
