#include "procedural/fixed/noise.h"

#include <algorithm>
#include <cmath>

#include "procedural/noise/lattice_site.h"
#include "procedural/noise/perlin_noise.h"

namespace burl {

namespace {

using Integer = FixedInteger;

/// i modulo 2^I, in [-2^(I-1), 2^(I-1)): within that range the lattice index of float64.
Integer wrapped_cell(Integer i, const FixedFormat& format) {
    const Integer period = Integer(1) << format.integer_bits, half = period / 2;
    return positive_remainder(i + half, period) - half;
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

/// A corner's random number, or the height of its slope at the offset, in units of 2^-bits.
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

FixedInteger fixed_coordinate(double x, const FixedFormat& format) {
    if (!(std::abs(x) < lattice_limit)) return 0;
    // Only the fraction is scaled, so large coordinates cannot overflow.
    const double cell = std::floor(x), fraction = std::ldexp(x - cell, int(format.fraction_bits));
    const Integer one = Integer(1) << format.fraction_bits;
    return wrapped_cell(Integer(cell), format) * one + std::min(Integer(fraction), one - 1);
}

FixedInteger wrapped_units(double units, const FixedFormat& format) {
    const double range = std::ldexp(1.0, int(format.integer_bits + format.fraction_bits));
    const double rest = std::fmod(std::floor(units), range);
    // A number that is not finite counts as 0.
    if (!(std::abs(rest) < range)) return 0;
    if (rest >= 0.5 * range) return Integer(rest - range);
    return Integer(rest < -0.5 * range ? rest + range : rest);
}

FixedInteger fixed_noise_units(const NoiseSpec& noise, const FixedFormat& format,
                               const std::array<FixedInteger, 3>& p) {
    const unsigned bits = format.fraction_bits;
    const Fade fade = noise.kind == NoiseKind::value ? noise.fade : Fade::quintic;
    std::array<Integer, 3> fraction;
    std::array<std::array<std::uint32_t, 2>, 3> cells;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Integer cell = p[axis] >> bits;
        fraction[axis] = p[axis] - (cell << bits);
        cells[axis] = {std::uint32_t(cell), std::uint32_t(wrapped_cell(cell + 1, format))};
    }
    std::array<Integer, 8> heights;
    for (std::size_t c = 0; c < 8; ++c) {
        std::array<std::uint32_t, 3> index;
        std::array<Integer, 3> offset;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t upper = c >> axis & 1;
            index[axis] = cells[axis][upper];
            offset[axis] = fraction[axis] - (Integer(upper) << bits);
        }
        heights[c] = corner_height(noise, bits, index, offset);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Integer weight = fixed_fade(fade, fraction[axis], bits);
        for (std::size_t c = 0; c < std::size_t(4) >> axis; ++c)
            heights[c] = heights[2 * c] + (weight * (heights[2 * c + 1] - heights[2 * c]) >> bits);
    }
    return heights[0];
}

double fixed_noise(const NoiseSpec& noise, const FixedFormat& format, const Vec3d& p) {
    const std::array<FixedInteger, 3> units{fixed_coordinate(p.x, format),
                                            fixed_coordinate(p.y, format),
                                            fixed_coordinate(p.z, format)};
    return std::ldexp(double(fixed_noise_units(noise, format, units)), -int(format.fraction_bits));
}

}  // namespace burl
