#pragma once
// A point as every noise takes it: lattice cell and place within the cell, split in float64 before
// anything is rounded to float32, so that an error does not grow with the distance from the origin.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "procedural/batch/texel_batch.h"
#include "procedural/noise/spec.h"

namespace burl {

/// A point in lattice coordinates, in units of cells.
template <std::size_t N>
using Point = std::array<double, N>;

/// A noise's value and its gradient with respect to the lattice coordinates.
template <class Real, std::size_t N>
struct NoiseSample {
    Real value = 0;
    std::array<Real, N> gradient{};
};

/// A noise's value without its gradient, by the arithmetic of NoiseSample's value.
template <class Real, std::size_t N>
struct NoiseValue {
    Real value = 0;
};

/// The size from which a double has no useful fraction: a coordinate of this size or more (or NaN)
/// counts as 0 in every path.
inline constexpr double lattice_limit = 0x1p51;

/// The remainder of i modulo n, in [0, n).
constexpr std::int64_t positive_remainder(std::int64_t i, std::int64_t n) {
    const std::int64_t rest = i % n;
    return rest < 0 ? rest + n : rest;
}

/// A point split into lattice cell and place within the cell.
template <class Real, std::size_t N>
struct LatticeSite {
    std::array<std::int64_t, N> cell{};  ///< floor of the coordinate, modulo the period
    std::array<Real, N> place{};         ///< offset from the cell's middle, in [-1/2, 1/2]
    Period<N> period{};

    /// Coordinate of the lattice point `offset` cells up, modulo the period, or modulo 2^32 without
    /// one.
    std::uint32_t index(std::size_t axis, int offset) const {
        const std::int64_t i = cell[axis] + offset;
        return std::uint32_t(period[axis] == 0 ? i : positive_remainder(i, period[axis]));
    }
};

/// The site of a point. Points a whole number of periods apart have the same site, bit for bit,
/// where float64 holds both.
template <class Real, std::size_t N>
LatticeSite<Real, N> lattice_site(const Point<N>& p, const Period<N>& period = {}) {
    LatticeSite<Real, N> site;
    site.period = period;
    for (std::size_t axis = 0; axis < N; ++axis) {
        const double x = std::abs(p[axis]) < lattice_limit ? p[axis] : 0.0;
        const double cell = std::floor(x);
        const auto i = std::int64_t(cell);
        site.cell[axis] = period[axis] == 0 ? i : positive_remainder(i, period[axis]);
        site.place[axis] = Real((x - cell) - 0.5);
    }
    return site;
}

/// The line `solid` in lattice coordinates. A coordinate that leaves the lattice anywhere on the
/// whole span of `length` texels (or on `solid`, where that is longer) is 0 on all of it.
inline LatticeLine lattice_line(const Affine3& lattice_from_solid, const LatticeLine& solid,
                                double length = 0.0) {
    LatticeLine line{lattice_from_solid(solid.start), lattice_from_solid.linear * solid.step,
                     solid.first, solid.count};
    const double last = std::max(length, line.first + double(line.count));
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = std::abs(line.start[axis]) + last * std::abs(line.step[axis]);
        if (!(reach < lattice_limit)) line.start[axis] = line.step[axis] = 0.0;
    }
    return line;
}

/// The largest component of the line's step, in cells per texel.
inline double fastest_step(const LatticeLine& line) {
    return std::max({std::abs(line.step.x), std::abs(line.step.y), std::abs(line.step.z)});
}

}  // namespace burl
