#pragma once
// Blender's regular textures, as its manual describes them: waves, bricks, checks, gradients, and
// Magic. Their constants are measured (tests/peers/blender_points.py).
#include <algorithm>
#include <cstdint>

#include "procedural/blender/perlin.h"

namespace burl::blender {

/// A point that lies on a cell's border moved into the cell.
template <class T>
Triple<T> off_border(const Triple<T>& p) {
    const Triple<T> little{T(1e-6), T(1e-6), T(1e-6)};
    return times(T(0.999999), p + little);
}

template <class T>
struct WaveShape {
    bool rings = false;
    int direction = 0;  ///< 0 to 2: an axis; 3: the diagonal of bands, or spheres
    int profile = 0;    ///< 0: sine, 1: saw, 2: triangle
    T distortion, detail, detail_scale, detail_roughness, phase;
};

template <class T>
T wave_way(const Triple<T>& p, const WaveShape<T>& wave) {
    const std::array axes{p.x, p.y, p.z};
    if (!wave.rings)
        return wave.direction < 3 ? T(20.0) * axes[std::size_t(wave.direction)]
                                  : T(10.0) * (p.x + p.y + p.z);
    Triple<T> away = p;
    if (wave.direction == 0) away.x = T(0.0);
    if (wave.direction == 1) away.y = T(0.0);
    if (wave.direction == 2) away.z = T(0.0);
    return T(20.0) * length(away);
}

template <class T>
T wave(Triple<T> p, const WaveShape<T>& shape) {
    p = off_border(p);
    T n = wave_way(p, shape) + shape.phase;
    if (value_of(shape.distortion) != 0.0) {
        const T f = fractal(times(shape.detail_scale, p), shape.detail, shape.detail_roughness);
        n = n + shape.distortion * (T(2.0) * f - T(1.0));
    }
    if (shape.profile == 0) return T(0.5) + T(0.5) * sine_of(n - T(0.5 * std::numbers::pi));
    const T turns = T(0.5 / std::numbers::pi) * n;
    if (shape.profile == 1) return turns - T(floor_of(turns));
    return T(2.0) * absolute(turns - T(floor_of(turns + T(0.5))));
}

/// A change of one coordinate of Magic: sign f(x, y or z of the state, each with its sign).
struct MagicTurn {
    int axis, sign;
    bool is_sine;
    std::array<int, 3> signs;
};

/// The ten changes, found one by one by a search over all signs, sines and cosines
/// (tests/peers/blender_magic.py).
inline constexpr std::array<MagicTurn, 10> magic_turns{{{1, -1, false, {1, -1, 1}},
                                                        {0, 1, false, {1, -1, -1}},
                                                        {2, -1, true, {1, 1, 1}},
                                                        {0, -1, false, {1, -1, 1}},
                                                        {1, 1, true, {1, -1, -1}},
                                                        {1, -1, false, {1, -1, -1}},
                                                        {0, 1, false, {1, 1, 1}},
                                                        {2, 1, true, {1, 1, -1}},
                                                        {0, -1, false, {1, 1, -1}},
                                                        {1, -1, true, {1, -1, 1}}}};

/// Blender's Magic texture: `turbulence` of the turns above, 0 to 10.
template <class T>
Triple<T> magic(const Triple<T>& p, int turbulence, const T& distortion) {
    std::array<T, 3> at{sine_of(T(5.0) * (p.x + p.y + p.z)), cosine_of(T(5.0) * (p.x - p.y + p.z)),
                        T(0.0) - cosine_of(T(5.0) * (p.x + p.y - p.z))};
    if (turbulence > 0)
        for (T& x : at) x = x * distortion;
    for (int k = 0; k < std::min(turbulence, 10); ++k) {
        const MagicTurn& turn = magic_turns[std::size_t(k)];
        T sum = T(0.0);
        for (std::size_t i = 0; i < 3; ++i) sum = sum + T(double(turn.signs[i])) * at[i];
        at[std::size_t(turn.axis)] =
            T(double(turn.sign)) * distortion * (turn.is_sine ? sine_of(sum) : cosine_of(sum));
    }
    if (value_of(distortion) != 0.0)
        for (T& x : at) x = quotient(x, T(2.0) * distortion);
    return {T(0.5) - at[0], T(0.5) - at[1], T(0.5) - at[2]};
}

enum class GradientKind {
    linear,
    quadratic,
    easing,
    diagonal,
    spherical,
    quadratic_sphere,
    radial
};

template <class T>
T gradient_of(GradientKind kind, const Triple<T>& p) {
    const auto inside = [&] { return larger(T(0.999999) - length(p), T(0.0)); };
    switch (kind) {
        case GradientKind::linear:
            return p.x;
        case GradientKind::quadratic: {
            const T r = larger(p.x, T(0.0));
            return r * r;
        }
        case GradientKind::easing:
            return smooth(clamped(p.x));
        case GradientKind::diagonal:
            return T(0.5) * (p.x + p.y);
        case GradientKind::spherical:
            return inside();
        case GradientKind::quadratic_sphere:
            return inside() * inside();
        case GradientKind::radial:
            break;
    }
    return T(0.5 / std::numbers::pi) * angle_to(p.y, p.x) + T(0.5);
}

/// Blender's Gradient texture, clamped to [0, 1].
template <class T>
T gradient(GradientKind kind, const Triple<T>& p) {
    return clamped(gradient_of(kind, p));
}

/// Blender's Checker texture: 1 where the first colour shows.
template <class T>
T checker(const Triple<T>& p) {
    const Triple<double> at = floors(values_of(off_border(p)));
    return T(std::fmod(std::abs(at.x + at.y + at.z), 2.0) == 0.0 ? 0.0 : 1.0);
}

template <class T>
struct BrickShape {
    T mortar, smooth, bias, width, height;
    double offset = 0.5, squash = 1.0;
    int offset_frequency = 2, squash_frequency = 2;
};

/// The random number in [0, 1] of a brick: integer noise after Hugo Elias.
inline double brick_number(std::uint32_t n) {
    n = (n + 1013u) & 0x7fffffffu;
    n = (n >> 13) ^ n;
    const std::uint32_t mixed = (n * (n * n * 60493u + 19990303u) + 1376312589u) & 0x7fffffffu;
    return 0.5 * double(mixed) / 1073741824.0;
}

/// Blender's Brick texture: the share of the second colour in a brick's, and the mortar's share.
template <class T>
std::array<T, 2> brick(const Triple<T>& p, const BrickShape<T>& shape) {
    const double row = floor_of(quotient(p.y, shape.height));
    const auto every = [row](int frequency) {
        return frequency > 0 && std::fmod(row, double(frequency)) == 0.0;
    };
    T width = shape.width, offset = T(0.0);
    if (shape.offset_frequency != 0 && shape.squash_frequency != 0) {
        if (every(shape.squash_frequency)) width = T(shape.squash) * width;
        if (every(shape.offset_frequency)) offset = T(shape.offset) * width;
    }
    const T along = p.x + offset;
    const double number = floor_of(quotient(along, width));
    const T x = along - T(number) * width, y = p.y - T(row) * shape.height;
    const double random = brick_number((low_word(row) << 16) + (low_word(number) & 0xffffu));
    const T tint = clamped(T(random) + shape.bias);
    const T nearest = smaller(smaller(x, y), smaller(width - x, shape.height - y));
    if (!(value_of(nearest) < value_of(shape.mortar))) return {tint, T(0.0)};
    if (value_of(shape.smooth) == 0.0) return {tint, T(1.0)};
    const T deep = T(1.0) - quotient(nearest, shape.mortar);
    return {tint, value_of(deep) < value_of(shape.smooth)
                      ? numeric::smooth(clamped(quotient(deep, shape.smooth)))
                      : T(1.0)};
}

}  // namespace burl::blender
