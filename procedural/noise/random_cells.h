#pragma once
// The two noises without interpolation: `cell`, one random number per lattice cell, and `white`,
// one per cell of a lattice 2^16 times as fine, so in effect a new number for every point that is
// asked for. The gradient of both is 0 wherever it exists, and float32 gives float64's numbers.
#include "procedural/noise/value_noise.h"

namespace burl {

/// Cell noise: the lattice value of the cell's lowest corner, in [-1, 1).
template <class Real, std::size_t N>
NoiseSample<Real, N> cell_noise(const Point<N>& p, std::uint32_t seed,
                                const Period<N>& period = {}) {
    const LatticeSite<Real, N> site = lattice_site<Real>(p, period);
    std::array<std::uint32_t, N> index;
    for (std::size_t axis = 0; axis < N; ++axis) index[axis] = site.index(axis, 0);
    return {lattice_value<Real>(index, seed), {}};
}

/// The cells of white noise per lattice cell along an axis.
inline constexpr std::uint32_t white_cells = 65536;

/// White noise in [-1, 1), of mean 0 and variance 1/3, uncorrelated between points 2^-16 cells
/// apart. It repeats after 65536 lattice cells.
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
