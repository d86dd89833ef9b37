#pragma once
// Perlin's original gradient noise (1985) in the form of appendix A of his 2001 course notes on
// noise hardware: the s-curve 3x^2 - 2x^3, gradients from a table of 256, in one to three
// dimensions. The tables are those that the appendix's init() fills by the C library's random() of
// GNU libc with its default seed, so that values can be compared with programs that run the
// original.
#include "procedural/noise/interpolated_noise.h"
#include "procedural/numbers/lattice_hash.h"

namespace burl {

/// The tables of appendix A: the permutation p, and per dimension 256 gradients, which are unit
/// vectors in two and three dimensions and numbers in [-1, 1) in one.
struct ClassicTables {
    std::array<std::uint32_t, 256> p{};
    std::array<std::array<float, 1>, 256> g1{};
    std::array<std::array<float, 2>, 256> g2{};
    std::array<std::array<float, 3>, 256> g3{};

    /// Fills the tables from random() seeded with `seed`.
    explicit ClassicTables(std::uint32_t seed);

    const auto& gradients(std::array<float, 1>*) const { return g1; }
    const auto& gradients(std::array<float, 2>*) const { return g2; }
    const auto& gradients(std::array<float, 3>*) const { return g3; }
};

/// The tables with the default seed, 1.
const ClassicTables& classic_tables();

/// Perlin's noise of 1985, which repeats after 256 cells and is 0 at lattice points. `seed` moves
/// the lattice; seed 0 is the appendix's noise for coordinates above -4096. |n| <= 0.5 in one
/// dimension, 0.7072 in two, 0.8661 in three. In float32 the value errs by at most 5e-7 and a
/// gradient's component by 3e-6.
template <template <class, std::size_t> class Sample, class Real, std::size_t N>
Sample<Real, N> perlin1985_noise(const Point<N>& p, std::uint32_t seed,
                                 const Period<N>& period = {}) {
    const ClassicTables& tables = classic_tables();
    const auto& gradients = tables.gradients(static_cast<std::array<float, N>*>(nullptr));
    return interpolate_corners(
        lattice_site<Real>(p, period), Fade::smooth,
        [&](const std::array<std::uint32_t, N>& index, const std::array<Real, N>& offset) {
            std::uint32_t h = 0;  // p[i], p[p[i] + j] and p[p[i] + j] + k in 1-D, 2-D and 3-D
            for (std::size_t axis = 0; axis < N; ++axis) {
                h = (h + index[axis] + LatticeHash::shift(seed, axis)) & 255;
                if (axis < 2) h = tables.p[h];
            }
            std::array<Real, N> gradient;
            for (std::size_t axis = 0; axis < N; ++axis) gradient[axis] = Real(gradients[h][axis]);
            Sample<Real, N> sample;
            set_slope(gradient, offset, sample);
            return sample;
        });
}

}  // namespace burl
