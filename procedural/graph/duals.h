#pragma once
// The steps of a graph's program with forward-mode derivatives: each becomes a function on the
// channels of a batch of points, which averages over their footprints. Arithmetic is float64, sums
// of noise are float64 or float32.
#include <array>
#include <cstddef>
#include <functional>
#include <span>

#include "procedural/batch/filter.h"
#include "procedural/batch/texel_batch.h"
#include "procedural/graph/masks.h"
#include "procedural/graph/program.h"
#include "procedural/numbers/dual.h"

namespace burl {

/// The largest number of points in a batch: every number of a graph is an array of values and three
/// of slopes, for so many points at a time.
inline constexpr std::size_t graph_batch_size = 256;

/// The values and slopes of one number at the points of a batch.
struct alignas(64) DualArray {
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

/// A point with the derivatives of its coordinates.
struct DualPoint {
    Dual x, y, z;
};

/// The channels of a step and the footprints of the batch's points.
struct DualCall {
    std::array<const DualArray*, most_step_inputs> inputs{};
    std::array<DualArray*, 3> outputs{};
    std::span<const Footprint> footprints;  ///< footprint of each point
    const MaskValues* masks = nullptr;      ///< values of the graph's masks
    std::size_t first = 0;                  ///< number of the batch's first point in `masks`

    std::size_t count() const { return footprints.size(); }
    Dual in(std::size_t k, std::size_t i) const { return inputs[k]->get(i); }
    /// The value of a mask at point i, with its gradient.
    Dual mask(std::size_t number, std::size_t i) const {
        if (!masks || number >= masks->size() || (*masks)[number].empty()) return 0.0;
        return (*masks)[number][first + i];
    }
    /// The point whose coordinates are the first three inputs.
    DualPoint point(std::size_t i) const { return {in(0, i), in(1, i), in(2, i)}; }

    /// The change of x across the footprint along its first step.
    double along_u(const Dual& x, std::size_t i) const {
        return glm::dot(x.slope, footprints[i].u);
    }
    /// The change of x across the footprint along its second step.
    double along_v(const Dual& x, std::size_t i) const {
        return glm::dot(x.slope, footprints[i].v);
    }
    /// The width of the box with the variance of x over the footprint.
    double box_width(const Dual& x, std::size_t i) const {
        return length_of(along_u(x, i), along_v(x, i));
    }
};

/// The function of a step on a batch.
using DualFunction = std::function<void(const DualCall&)>;

/// The function of a step whose result at point i is function(call, i).
template <class Function>
DualFunction for_each_point(const Function& function) {
    return [function](const DualCall& call) {
        for (std::size_t i = 0; i < call.count(); ++i) call.outputs[0]->set(i, function(call, i));
    };
}

/// The settings of an evaluator.
struct DualSettings {
    Filter filter;         ///< filter of colour maps; whether a field's octaves fade
    bool float32 = false;  ///< whether sums of noise are float32
};

// The functions of the kinds of work: arithmetic in duals.cpp, noise in dual_noise.cpp and
// dual_simplex.cpp, cells and shapes in dual_tiles.cpp, checkerboards and colours in
// dual_colors.cpp.
DualFunction dual_function(const ValueOperation& work, const DualSettings& settings);
DualFunction dual_function(const BoxMean& work, const DualSettings& settings);
DualFunction dual_function(const BoxPulse& work, const DualSettings& settings);
DualFunction dual_function(const BoxStep& work, const DualSettings& settings);
DualFunction dual_function(const PositiveTurn& work, const DualSettings& settings);
DualFunction dual_function(const SlopeAlong& work, const DualSettings& settings);
DualFunction dual_function(const Checkerboard& work, const DualSettings& settings);
DualFunction dual_function(const OctaveSum& work, const DualSettings& settings);
DualFunction dual_function(const SimplexOctaves& work, const DualSettings& settings);
DualFunction dual_function(const CurlOctaves& work, const DualSettings& settings);
DualFunction dual_function(const FieldAt& work, const DualSettings& settings);
DualFunction dual_function(const MapColors& work, const DualSettings& settings);
DualFunction dual_function(const MarbleColors& work, const DualSettings& settings);
DualFunction dual_function(const DotsWeight& work, const DualSettings& settings);
DualFunction dual_function(const CellNumber& work, const DualSettings& settings);
DualFunction dual_function(const CellFeature& work, const DualSettings& settings);
DualFunction dual_function(const ScatteredShapes& work, const DualSettings& settings);
DualFunction dual_function(const ImageColors& work, const DualSettings& settings);
DualFunction dual_function(const MaskRead& work, const DualSettings& settings);
DualFunction dual_function(const PointFunction& work, const DualSettings& settings);

}  // namespace burl
