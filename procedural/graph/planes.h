#pragma once
// The planes of a material: the numbers that its graph gives at a point, one array per number. The
// base colour has three, red, green and blue in linear light, multiplied by its alpha, and alpha as
// a fourth if the graph gives a colour; of the other channels a number has one, a colour three.
#include <cstddef>
#include <optional>
#include <vector>

#include "procedural/graph/program.h"

namespace burl {

/// The result of a graph's evaluation: the base colour, or all planes of its material.
enum class GraphOutput { color, planes };

/// The registers of all planes.
std::vector<Register> plane_registers(const GraphProgram& program);

/// The number of planes, and the first plane of each channel.
class PlaneLayout {
  public:
    explicit PlaneLayout(const TextureGraph& graph);

    std::size_t count() const { return count_; }
    /// The plane of the base colour's alpha; none where the base colour is a number.
    std::optional<std::size_t> alpha() const { return alpha_; }
    /// The first plane of a channel; none where the graph does not give it.
    std::optional<std::size_t> of(Channel channel) const { return first_[std::size_t(channel)]; }

  private:
    std::optional<std::size_t> alpha_;
    std::array<std::optional<std::size_t>, enum_names<Channel>.size()> first_{};
    std::size_t count_ = 3;
};

/// Whether a node's colour is opaque everywhere, by the nodes that it is made of: false where it
/// may be transparent.
bool is_opaque(const TextureGraph& graph, std::uint32_t node);

}  // namespace burl
