#include "app/stability_truth.h"

#include <algorithm>
#include <cmath>

#include "procedural/perlin_noise.h"
#include "procedural/value_noise.h"

namespace burl {

namespace {

using Real = long double;
using Point3 = StabilityTruth::Point;

Point3 mapped(const Affine3& map, const Point3& p) {
    Point3 result;
    for (int row = 0; row < 3; ++row) {
        Real sum = Real(map.offset[row]);
        for (int column = 0; column < 3; ++column)
            sum += Real(map.linear[column][row]) * p[std::size_t(column)];
        result[std::size_t(row)] = sum;
    }
    return result;
}

/// Sizes of the terms whose sum mapped() is.
Vec3d term_sizes(const Affine3& map, const Vec3d& sizes) {
    Vec3d result(0.0);
    for (int row = 0; row < 3; ++row) {
        result[row] = std::abs(map.offset[row]);
        for (int column = 0; column < 3; ++column)
            result[row] += std::abs(map.linear[column][row]) * sizes[column];
    }
    return result;
}

Real fade(Fade fade, Real x) {
    if (fade == Fade::linear) return x;
    if (fade == Fade::smooth) return x * x * (3.0L - 2.0L * x);
    return x * x * x * (10.0L + x * (6.0L * x - 15.0L));
}

bool is_plain(const NoiseSpec& noise) {
    return (noise.kind == NoiseKind::value || noise.kind == NoiseKind::perlin) &&
           noise.period == Period<4>{} && !noise.time;
}

/// The eight corners' numbers times their weights.
Real corner_sum(const NoiseSpec& noise, const Point3& p) {
    const Fade kind = noise.kind == NoiseKind::value ? noise.fade : Fade::quintic;
    std::array<std::int64_t, 3> cell;
    Point3 place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Real below = std::floor(p[axis]);
        cell[axis] = std::int64_t(below), place[axis] = p[axis] - below;
    }
    Real sum = 0.0L;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        std::array<std::uint32_t, 3> index;
        Real weight = 1.0L;
        Point3 away;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool upper = corner >> axis & 1;
            const Real w = fade(kind, place[axis]);
            weight *= upper ? w : 1.0L - w;
            index[axis] = std::uint32_t(cell[axis] + upper);
            away[axis] = place[axis] - Real(upper);
        }
        if (noise.kind == NoiseKind::value) {
            sum += weight * Real(lattice_value(index, noise.seed));
            continue;
        }
        const auto g = perlin_gradient<double, 3>(lattice_gradient(index, noise.seed));
        for (std::size_t axis = 0; axis < 3; ++axis) sum += weight * Real(g[axis]) * away[axis];
    }
    return sum;
}

Real noise_at(const NoiseSpec& noise, const Point3& p) {
    if (is_plain(noise)) return corner_sum(noise, p);
    return evaluate_noise(noise, Vec3d(double(p[0]), double(p[1]), double(p[2])));
}

Real quadric_at(const Quadric& q, const Point3& p) {
    const auto& [s, t, r] = p;
    return Real(q.a) * s * s + 2.0L * Real(q.b) * s * t + 2.0L * Real(q.c) * s * r +
           2.0L * Real(q.d) * s + Real(q.e) * t * t + 2.0L * Real(q.f) * t * r +
           2.0L * Real(q.g) * t + Real(q.h) * r * r + 2.0L * Real(q.i) * r + Real(q.j);
}

double quadric_sizes(const Quadric& q, const Vec3d& s) {
    const Quadric sizes{std::abs(q.a), std::abs(q.b), std::abs(q.c), std::abs(q.d), std::abs(q.e),
                        std::abs(q.f), std::abs(q.g), std::abs(q.h), std::abs(q.i), std::abs(q.j)};
    return double(quadric_at(sizes, {s.x, s.y, s.z}));
}

}  // namespace

StabilityTruth::StabilityTruth(const Texture& texture, const Affine3& texture_from_atlas)
    : texture_(texture), map_(texture_from_atlas), octaves_(expand_octaves(texture)) {
    for (const Octave& octave : octaves_) {
        amplitudes_ += std::abs(octave.scale) + std::abs(octave.offset);
        const double slope = octave.shape == OctaveShape::ridged ? 2.0 : 1.0;
        if (octave.shape != OctaveShape::plain || !is_plain(octave.noise))
            other_errors_ += 5e-7 * slope * std::abs(octave.scale);
    }
}

StabilityTruth::Point StabilityTruth::point(const TexelMap& map, std::int64_t x,
                                            std::int64_t y) const {
    Point3 p;
    for (int axis = 0; axis < 3; ++axis)
        p[std::size_t(axis)] = Real(map.origin[axis]) +
                               Real(x - map.anchor_x) * Real(map.step_x[axis]) +
                               Real(y - map.anchor_y) * Real(map.step_y[axis]);
    return mapped(map_, p);
}

long double StabilityTruth::field(const Point& s) const {
    Real f = quadric_at(texture_.quadric, s);
    for (const Octave& octave : octaves_) {
        const Real n = noise_at(octave.noise, mapped(octave.lattice_from_solid, s));
        f += Real(octave.offset) + Real(octave.scale) * shaped(octave.shape, n);
    }
    return f;
}

Vec3d StabilityTruth::color(long double f) const {
    const Real index = texture_.colors.wrap == Wrap::repeat ? f - std::floor(f) : f;
    return evaluate_color(texture_.colors, double(index));
}

double StabilityTruth::rounding(const Span& span, const TexelMap& map, std::int64_t y) const {
    const double right = double(std::int64_t(span.x) + span.count - 1 - map.anchor_x),
                 columns = std::max(std::abs(double(span.x) - map.anchor_x), std::abs(right)),
                 rows = std::abs(double(y - map.anchor_y));
    const auto sizes = [](const Vec3d& v) {
        return Vec3d(std::abs(v.x), std::abs(v.y), std::abs(v.z));
    };
    const Vec3d s = term_sizes(
        map_, sizes(map.origin) + columns * sizes(map.step_x) + rows * sizes(map.step_y));
    double farthest = 0.0;
    for (const Octave& octave : octaves_) {
        const Vec3d p = term_sizes(octave.lattice_from_solid, s);
        farthest = std::max({farthest, p.x, p.y, p.z});
    }
    return 4.0 * 0x1p-52 * (farthest * amplitudes_ + quadric_sizes(texture_.quadric, s));
}

double StabilityTruth::bound(const Span& span, const TexelMap& map, std::int64_t y,
                             double f) const {
    return 2.5e-7 * (std::abs(f) + amplitudes_) + other_errors_ + rounding(span, map, y);
}

}  // namespace burl
