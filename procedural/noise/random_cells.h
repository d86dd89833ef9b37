#pragma once
// The two noises without interpolation: `cell`, one random number for each lattice cell, and
// `white`, the same on a lattice 2^16 times as fine, so in effect a new number for every point that
// is asked for. Both have gradient 0 wherever they have one, and float32 gives float64's numbers.
#include "procedural/noise/value_noise.h"

namespace burl {

/// The lattice value of the cell's lowest corner, in [-1, 1).
template <class Real, std::size_t N>
NoiseSample<Real, N> cell_noise(const Point<N>& p, std::uint32_t seed,
                                const Period<N>& period = {}) {
    const LatticeSite<Real, N> site = lattice_site<Real>(p, period);
    std::array<std::uint32_t, N> index;
    for (std::size_t axis = 0; axis < N; ++axis) index[axis] = site.index(axis, 0);
    return {lattice_value<Real>(index, seed), {}};
}

/// Cells of white noise per lattice cell and axis.
inline constexpr std::uint32_t white_cells = 65536;

/// In [-1, 1), of mean 0 and variance 1/3, uncorrelated between points 2^-16 cells apart. Repeats
/// after 65536 cells.
template <class Real, std::size_t N>
NoiseSample<Real, N> white_noise(const Point<N>& p, std::uint32_t seed,
                                 const Period<N>& period = {}) {
    const LatticeSite<double, N> site = lattice_site<double>(p, period);
    std::array<std::uint32_t, N> index;
    for (std::size_t axis = 0; axis < N; ++axis)
        index[axis] = white_cells * std::uint32_t(site.cell[axis]) +
                      std::uint32_t((site.place[axis] + 0.5) * white_cells);
    return {lattice_value<Real>(index, seed), {}};
}

}  // namespace burl
