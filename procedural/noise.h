#pragma once
// Lattice noise in float64, the reference of every faster path: value noise (Perlin 1985 as the
// 1999 paper uses it) and Perlin's improved gradient noise ("Improving Noise", 2002). The random
// number of a lattice corner is a parameter, so that a test can put Perlin's published permutation
// in the place of our hash.
#include <array>
#include <cmath>
#include <cstdint>

#include "atlas/vec.h"
#include "procedural/lattice_hash.h"
#include "procedural/texture.h"

namespace burl {

/// From here on a double holds no useful fraction: a coordinate of this size or more (or NaN)
/// counts as 0 in every path.
inline constexpr double lattice_limit = 0x1p51;

/// Lattice cell (floor, wrapped to 32 bits) and place within it, [0,1) per axis.
struct LatticePoint {
    std::array<std::uint32_t, 3> cell{};
    Vec3d fraction{0.0};
};

inline LatticePoint lattice_point(const Vec3d& p) {
    LatticePoint result;
    for (int axis = 0; axis < 3; ++axis) {
        const double x = std::abs(p[axis]) < lattice_limit ? p[axis] : 0.0;
        const double cell = std::floor(x);
        result.cell[std::size_t(axis)] = std::uint32_t(std::int64_t(cell));
        result.fraction[axis] = x - cell;
    }
    return result;
}

/// Weight of the upper corner at fraction x in [0,1].
inline double fade_weight(Fade fade, double x) {
    switch (fade) {
        case Fade::linear:
            return x;
        case Fade::smooth:
            return x * x * (3.0 - 2.0 * x);
        case Fade::quintic:
            return x * x * x * (10.0 + x * (6.0 * x - 15.0));
    }
    return x;
}

/// Trilinear interpolation of corner(i,j,k), the cell's lattice points being cell + {0,1}^3, after
/// fading; `corner` is called with (i, j, k, offset of p from that corner).
template <class Corner>
double interpolate_corners(const LatticePoint& p, Fade fade, Corner&& corner) {
    const auto lerp = [](double w, double a, double b) { return a + w * (b - a); };
    const auto at = [&](unsigned x, unsigned y, unsigned z) -> double {
        return corner(p.cell[0] + x, p.cell[1] + y, p.cell[2] + z, p.fraction - Vec3d(x, y, z));
    };
    const double u = fade_weight(fade, p.fraction.x), v = fade_weight(fade, p.fraction.y),
                 w = fade_weight(fade, p.fraction.z);
    return lerp(w, lerp(v, lerp(u, at(0, 0, 0), at(1, 0, 0)), lerp(u, at(0, 1, 0), at(1, 1, 0))),
                lerp(v, lerp(u, at(0, 0, 1), at(1, 0, 1)), lerp(u, at(0, 1, 1), at(1, 1, 1))));
}

/// Value noise: `value(i,j,k)` is the number at a lattice point.
template <class Value>
double value_noise(const Vec3d& p, Fade fade, Value&& value) {
    return interpolate_corners(lattice_point(p), fade,
                               [&](std::uint32_t i, std::uint32_t j, std::uint32_t k,
                                   const Vec3d&) -> double { return value(i, j, k); });
}

/// Dot product of offset d with the gradient of number 0..15: the 12 edge midpoints of a cube, four
/// of them twice, numbered as in the 2002 paper.
inline double gradient_dot(std::uint32_t gradient, const Vec3d& d) {
    const double a = gradient < 8 ? d.x : d.y;
    const double b = gradient < 4 ? d.y : (gradient == 12 || gradient == 14 ? d.x : d.z);
    return (gradient & 1 ? -a : a) + (gradient & 2 ? -b : b);
}

/// Improved Perlin noise: `gradient(i,j,k)` is the gradient's number 0..15 at a lattice point.
template <class Gradient>
double perlin_noise(const Vec3d& p, Gradient&& gradient) {
    return interpolate_corners(
        lattice_point(p), Fade::quintic,
        [&](std::uint32_t i, std::uint32_t j, std::uint32_t k, const Vec3d& d) -> double {
            return gradient_dot(gradient(i, j, k), d);
        });
}

/// The number of value noise at a lattice point: the hash's upper 24 bits as a two's complement
/// integer over 2^23, so one of 2^24 equally spaced numbers in [-1, 1).
inline double lattice_value(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t seed) {
    return 0x1p-23 * (std::int32_t(LatticeHash::bits(i, j, k, seed)) >> 8);
}

/// The gradient number at a lattice point: the hash's upper 4 bits.
inline std::uint32_t lattice_gradient(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                                      std::uint32_t seed) {
    return LatticeHash::bits(i, j, k, seed) >> 28;
}

/// n_seed(p) with our hash and range `bipolar`: within [-1, 1]. (Range `unit` is (n + 1) / 2.)
double evaluate_noise(NoiseKind kind, Fade fade, std::uint32_t seed, const Vec3d& p);

}  // namespace burl
