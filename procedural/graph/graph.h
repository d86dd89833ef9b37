#pragma once
// A texture as a graph of nodes (docs/reference/nodes.md), which the JSON tree of a recipe
// describes. A comparable value: every node comes after those it reads, so that evaluating them one
// after the other needs no recursion. A colour map over a field, the 1999 texture, is a graph of a
// form of its own, the plain graph, whose texture the fastest kernels fill.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "procedural/color/mip_image.h"
#include "procedural/graph/channel.h"
#include "procedural/model/texture.h"

namespace burl {

/// The type of a node's result, whose value is its number of channels: a number, the point at which
/// other nodes are evaluated, or a colour (linear light, multiplied by its alpha, and alpha).
enum class Wire : std::uint8_t { number = 1, point = 3, color = 4 };

/// The index of a node without a texture or image.
inline constexpr std::uint32_t no_texture = 0xffffffffu;

/// A node of a texture graph.
struct GraphNode {
    std::uint32_t type = 0;              ///< index into graph_table()
    Wire wire = Wire::number;            ///< type of the result
    std::uint32_t place = 0;             ///< number of the node that gives the point of evaluation
    std::vector<std::uint32_t> inputs;   ///< numbers of nodes, in the order of the table's inputs
    std::vector<double> parameters;      ///< numbers in the table's order; a choice is its index
    std::uint32_t texture = no_texture;  ///< index into `textures` for color_map and field
    std::uint32_t image = no_texture;    ///< index into `images` for image
    bool operator==(const GraphNode&) const = default;
};

/// An image file and the MIP map read from it.
struct GraphImage {
    std::string file;  ///< name in the recipe
    std::shared_ptr<const MipImage> pixels;
    bool operator==(const GraphImage& other) const {
        return file == other.file && *pixels == *other.pixels;
    }
};

/// A node that a name of the recipe's `define` stands for at one point of evaluation.
struct NamedNode {
    std::uint32_t node = 0;
    std::uint32_t place = 0;  ///< number of the node that gives the point where the name stands
    bool operator==(const NamedNode&) const = default;
};

/// A name of the recipe's `define`, whose nodes all that use it at one point share.
struct GraphName {
    std::string name;
    std::vector<NamedNode> uses;  ///< one per point of evaluation, never empty
    bool operator==(const GraphName&) const = default;
};

/// The node of a channel besides the base colour.
struct GraphChannel {
    Channel channel = Channel::opacity;
    std::uint32_t node = 0;
    bool operator==(const GraphChannel&) const = default;
};

/// A texture, or a whole material, as nodes, with the textures and images that they refer to.
struct TextureGraph {
    /// nodes[0] is the solid point; an empty list is no graph.
    std::vector<GraphNode> nodes;
    std::vector<Texture> textures;
    std::vector<GraphImage> images;
    std::uint32_t result = 0;            ///< number of the node of the base colour
    std::vector<GraphChannel> channels;  ///< the other channels, in the order of Channel
    std::vector<GraphName> names;        ///< names of shared nodes, in the recipe's order

    bool empty() const { return nodes.empty(); }
    bool operator==(const TextureGraph&) const = default;
};

/// The graph of a 1999 texture: the solid point, a field and a color_map over it, both of
/// `textures[0]`.
TextureGraph plain_graph(Texture texture);

/// The texture of a graph that plain_graph made, if its colours are opaque; null for any other
/// graph, since the kernels of plain graphs have no alpha.
const Texture* plain_texture(const TextureGraph& graph);
Texture* plain_texture(TextureGraph& graph);

/// Limits on graphs: more than anyone draws by hand, and few enough for fast evaluation.
inline constexpr std::size_t max_graph_depth = 64, max_graph_nodes = 1000;

}  // namespace burl
