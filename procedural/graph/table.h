#pragma once
// The table of the nodes that a texture graph can have: names, inputs, parameters with their
// ranges, meaning, source and definition. Parsing, checking, `burl list nodes`, --set and
// docs/reference/nodes.md follow it. Its rows stand with the nodes' definitions (procedural/nodes).
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "atlas/base/enum_names.h"
#include "procedural/batch/parameter.h"
#include "procedural/graph/graph.h"
#include "procedural/graph/step_registers.h"

namespace burl {

class NodeOps;

/// An input of a node type.
struct NodeInput {
    std::string_view key;
    Wire wire = Wire::number;   ///< a number counts as an opaque grey for `color`
    bool sets_wire = false;     ///< whether a colour here makes the result a colour
    std::string_view fallback;  ///< the default as JSON; empty where the input is required
    std::string_view tip;
};

/// The result of a node: a number, a colour, a colour if any input that sets the type is one
/// (`inputs`), or the result of its input evaluated at the point that the node makes (`inner`).
enum class NodeResult { number, color, inputs, inner };

/// The kinds of masks, which the mesh's shape gives at a texel (docs/reference/masks.md).
enum class MaskKind : std::uint8_t {
    occlusion,      ///< numbers: rays, distance
    curvature,      ///< numbers: radius
    thickness,      ///< numbers: rays, distance
    facing,         ///< numbers: a direction
    height_in_box,  ///< numbers: axis, 0 to 2
    edge_distance,  ///< numbers: angle in degrees, farthest
    part,           ///< numbers: kind of piece (0: connected, 1: part of the file), seed
    vertex_color,   ///< components: red, green, blue, alpha
    mesh_uv,        ///< components: u, v
    /// numbers: rays, distance, up, the sun's direction, its angle and the normals' crease in
    /// degrees; components: light of the sky's upper half, of its lower half, of the sun
    lighting,
    paint  ///< numbers: the layer of strokes
};
template <>
inline constexpr auto enum_names<MaskKind> = enum_words("occlusion", "curvature", "thickness",
                                                        "facing", "height_in_box", "edge_distance",
                                                        "part", "vertex_color", "mesh_uv",
                                                        "lighting", "paint");

/// The mask that a type of node reads: its kind, how many components it has (none where the node is
/// no mask), and how many of the node's leading numbers decide about its values.
struct NodeMask {
    MaskKind kind = MaskKind::occlusion;
    std::size_t components = 0, numbers = 0;
};

/// A type of node: an entry of the table.
struct NodeType {
    std::string_view name;
    NodeResult result = NodeResult::number;
    /// Adds the node's steps to a program and returns the registers of the node's channels, or of
    /// the point that it makes.
    std::vector<Register> (*define)(NodeOps& node) = nullptr;
    std::string_view text, source;
    std::array<NodeInput, 7> input_list{};
    std::array<Parameter, 10> parameter_list{};
    NodeMask mask{};

    std::span<const NodeInput> inputs() const;
    /// The parameters; `path` is the key alone. A parameter whose default is null may be left out
    /// and is then stored as infinity.
    std::span<const Parameter> parameters() const;
    const NodeInput* input(std::string_view key) const;
};

/// The table of all types of nodes.
std::span<const NodeType> graph_table();

/// The type of that name; null if there is none.
const NodeType* find_node(std::string_view name);

inline const NodeType& type_of(const GraphNode& node) {
    return graph_table()[node.type];
}

/// The parameters of a node by their keys.
class NodeParameters {
  public:
    explicit NodeParameters(const GraphNode& node) : node_(node) {}

    const GraphNode& self() const { return node_; }
    /// Component `component` of a parameter; 0 where the node's type has none with that key.
    double parameter(std::string_view key, std::size_t component = 0) const;
    /// The first three components of a parameter.
    Vec3d vector(std::string_view key) const;

  private:
    const GraphNode& node_;
};

}  // namespace burl
