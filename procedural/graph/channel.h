#pragma once
// The arrays that a texture graph with gradients is evaluated in: 256 points at a time, every
// number of the graph as an array of values and three of slopes.
#include <array>
#include <cstddef>

#include "procedural/numbers/dual.h"

namespace burl {

/// The largest number of points in a batch.
inline constexpr std::size_t graph_batch_size = 256;

/// The values and slopes of one number at the points of a batch.
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

}  // namespace burl
