#pragma once
// The arrays in which a texture graph is evaluated, 256 points at a time: every channel of every
// node is an array of values and three of slopes. Node functions get them in a NodeCall.
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "procedural/batch/precision.h"
#include "procedural/batch/texel_place.h"
#include "procedural/color/filtered_colors.h"
#include "procedural/field/lattice_sums.h"
#include "procedural/graph/graph.h"
#include "procedural/numbers/dual.h"

namespace burl {

/// The largest number of points in a batch of a graph.
inline constexpr std::size_t graph_batch_size = 256;

/// One channel of a node at the points of a batch: values and gradients.
struct alignas(64) Channel {
    std::array<double, graph_batch_size> value{};
    std::array<std::array<double, graph_batch_size>, 3> slope{};

    Dual get(std::size_t i) const {
        return {value[i], Vec3d(slope[0][i], slope[1][i], slope[2][i])};
    }
    void set(std::size_t i, const Dual& x) {
        value[i] = x.value;
        for (std::size_t axis = 0; axis < 3; ++axis) slope[axis][i] = x.slope[int(axis)];
    }
};

/// The data of one node that is prepared once per graph.
struct PreparedNode {
    std::vector<Octave> octaves;  ///< the octaves of a field
    /// The means of the octaves of a field, where octaves fade.
    std::vector<double> means;
    std::vector<LatticeSum> sums;        ///< the octaves of a field in sums, where none fades
    std::vector<MapPieces> pieces;       ///< the map of a color_map, one element
    std::vector<FilteredColors> colors;  ///< the filtered map of a color_map, one element
};

/// A point whose coordinates have gradients.
struct DualPoint {
    Dual x, y, z;
};

/// The arguments of a node's function for one batch.
struct NodeCall {
    const GraphNode* node = nullptr;
    const TextureGraph* graph = nullptr;
    const PreparedNode* prepared = nullptr;
    bool float32 = false;  ///< whether noise is evaluated in float32
    std::array<std::span<const Channel>, 4> inputs;
    /// The point at which the node is evaluated: three channels.
    std::span<const Channel> place;
    std::span<const Footprint> footprints;  ///< one per point
    std::span<Channel> out;

    std::size_t count() const { return footprints.size(); }
    /// A parameter by its key; `component` selects one of several numbers.
    double parameter(std::string_view key, std::size_t component = 0) const;
    Vec3d vector(std::string_view key) const;

    DualPoint point(std::size_t i) const {
        return {place[0].get(i), place[1].get(i), place[2].get(i)};
    }
    /// Channel c of input k at point i; a number where a colour is wanted is an opaque grey.
    Dual input(std::size_t k, std::size_t i, std::size_t c = 0) const {
        if (c < inputs[k].size()) return inputs[k][c].get(i);
        return c < 3 ? inputs[k][0].get(i) : Dual(1.0);
    }
    /// The change of x across the sample along the footprint's side u.
    double along_u(const Dual& x, std::size_t i) const {
        return glm::dot(x.slope, footprints[i].u);
    }
    /// The change of x across the sample along the footprint's side v.
    double along_v(const Dual& x, std::size_t i) const {
        return glm::dot(x.slope, footprints[i].v);
    }
    /// The width of the box that has the variance of x over the sample.
    double box_width(const Dual& x, std::size_t i) const {
        return length_of(along_u(x, i), along_v(x, i));
    }
};

/// Sets out[c][i] = function(i, c) for every point and channel.
template <class Function>
void for_each_channel(const NodeCall& call, Function&& function) {
    for (std::size_t c = 0; c < call.out.size(); ++c)
        for (std::size_t i = 0; i < call.count(); ++i) call.out[c].set(i, function(i, c));
}

/// Sets a number per point: out[i] = function(i).
template <class Function>
void for_each_point(const NodeCall& call, Function&& function) {
    for (std::size_t i = 0; i < call.count(); ++i) call.out[0].set(i, function(i));
}

/// Blends inputs 0 and 1: input 0 where weight(i) is 0, input 1 where it is 1.
template <class Weight>
void blend_inputs(const NodeCall& call, Weight&& weight) {
    for (std::size_t i = 0; i < call.count(); ++i) {
        const Dual w = weight(i);
        for (std::size_t c = 0; c < call.out.size(); ++c)
            call.out[c].set(i, dual_lerp(w, call.input(0, i, c), call.input(1, i, c)));
    }
}

/// Moves the points: out = function(i, point).
template <class Function>
void map_points(const NodeCall& call, Function&& function) {
    for (std::size_t i = 0; i < call.count(); ++i) {
        const DualPoint p = function(i, call.point(i));
        call.out[0].set(i, p.x);
        call.out[1].set(i, p.y);
        call.out[2].set(i, p.z);
    }
}

}  // namespace burl
