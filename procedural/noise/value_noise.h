#pragma once
// Value noise: random numbers at the lattice points, interpolated (the noise of Hart et al. 1999
// and of "Bresenham Noise"), in one to four dimensions. A whole last coordinate gives the noise of
// one dimension less, shifted: n(x,y,z,0) = n(x,y,z).
// The numbers without interpolation: `cell` noise has one per lattice cell, and `white` noise one
// per cell of a lattice 2^16 times as fine, so in effect a new number for every point that is asked
// for. The gradient of both is 0 wherever it exists, and float32 gives float64's numbers.
#include "procedural/noise/interpolated_noise.h"
#include "procedural/numbers/lattice_hash.h"

namespace burl {

/// The random number of a lattice point: the hash's upper 24 bits as a two's complement integer
/// over 2^23, so one of 2^24 equally spaced numbers in [-1, 1), exact in float32.
template <class Real = double, std::size_t N>
Real lattice_value(const std::array<std::uint32_t, N>& index, std::uint32_t seed) {
    return Real(0x1p-23) * Real(std::int32_t(LatticeHash::bits(index, seed)) >> 8);
}

inline double lattice_value(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t seed) {
    return lattice_value(std::array{i, j, k}, seed);
}

/// Value noise in [-1, 1). In float32 the value errs by at most 2.5e-7 and a gradient's component
/// by 1e-6.
template <template <class, std::size_t> class Sample, class Real, std::size_t N>
Sample<Real, N> value_noise(const Point<N>& p, Fade fade, std::uint32_t seed,
                            const Period<N>& period = {}) {
    return interpolate_corners(
        lattice_site<Real>(p, period), fade,
        [seed](const std::array<std::uint32_t, N>& index, const std::array<Real, N>&) {
            Sample<Real, N> sample;
            sample.value = lattice_value<Real>(index, seed);
            return sample;
        });
}

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
