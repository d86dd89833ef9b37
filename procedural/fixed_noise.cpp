#include "procedural/fixed_noise.h"

#include <array>
#include <cmath>

#include "procedural/lattice_site.h"
#include "procedural/perlin_noise.h"

namespace burl {

namespace {

using Integer = std::int64_t;

/// A lattice coordinate cut to the format: its cell, the next one, and the fraction in units.
struct FixedCoordinate {
    std::array<std::uint32_t, 2> cells{};
    Integer fraction = 0;
};

FixedCoordinate cut(double x, const FixedFormat& format) {
    if (!(std::abs(x) < lattice_limit)) x = 0.0;
    const Integer period = Integer(1) << format.integer_bits;
    // Only the fraction is scaled, so large coordinates cannot overflow.
    const double cell = std::floor(x), fraction = std::ldexp(x - cell, int(format.fraction_bits));
    const Integer i = positive_remainder(Integer(cell), period);
    const Integer largest = (Integer(1) << format.fraction_bits) - 1;
    return {{std::uint32_t(i), std::uint32_t((i + 1) % period)},
            std::min(Integer(fraction), largest)};
}

/// The upper corner's weight at x, both in units of 2^-bits.
Integer fixed_fade(Fade fade, Integer x, unsigned bits) {
    const Integer one = Integer(1) << bits;
    const Integer square = x * x >> bits;
    switch (fade) {
        case Fade::linear:
            return x;
        case Fade::smooth:
            return square * (3 * one - 2 * x) >> bits;
        case Fade::quintic:
            return (square * x >> bits) * ((x * (6 * x - 15 * one) >> bits) + 10 * one) >> bits;
    }
    return x;
}

/// A corner's random number, or the height of its slope at the offset.
Integer corner_height(const NoiseSpec& noise, unsigned bits,
                      const std::array<std::uint32_t, 3>& index,
                      const std::array<Integer, 3>& offset) {
    if (noise.kind == NoiseKind::value)
        return std::int32_t(LatticeHash::bits(index, noise.seed)) >> (31 - bits);
    const auto g = perlin_gradient<float, 3>(lattice_gradient(index, noise.seed));
    Integer sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) sum += Integer(g[axis]) * offset[axis];
    return sum;
}

}  // namespace

bool has_fixed_point(const NoiseSpec& noise) {
    return (noise.kind == NoiseKind::value || noise.kind == NoiseKind::perlin) &&
           noise.period == Period<4>{} && !noise.time;
}

double fixed_noise(const NoiseSpec& noise, const FixedFormat& format, const Vec3d& p) {
    const unsigned bits = format.fraction_bits;
    const Fade fade = noise.kind == NoiseKind::value ? noise.fade : Fade::quintic;
    const std::array<FixedCoordinate, 3> x{cut(p.x, format), cut(p.y, format), cut(p.z, format)};
    std::array<Integer, 8> heights;
    for (std::size_t c = 0; c < 8; ++c) {
        std::array<std::uint32_t, 3> index;
        std::array<Integer, 3> offset;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t upper = c >> axis & 1;
            index[axis] = x[axis].cells[upper];
            offset[axis] = x[axis].fraction - (Integer(upper) << bits);
        }
        heights[c] = corner_height(noise, bits, index, offset);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Integer weight = fixed_fade(fade, x[axis].fraction, bits);
        for (std::size_t c = 0; c < std::size_t(4) >> axis; ++c)
            heights[c] = heights[2 * c] + (weight * (heights[2 * c + 1] - heights[2 * c]) >> bits);
    }
    return std::ldexp(double(heights[0]), -int(bits));
}

}  // namespace burl
