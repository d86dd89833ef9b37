#pragma once
// Value noise: random numbers at the lattice points, interpolated (the noise of Hart et al. 1999
// and of "Bresenham Noise"), in one to four dimensions. A whole last coordinate gives the noise of
// one dimension less, shifted: n(x,y,z,0) = n(x,y,z).
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

}  // namespace burl
