#include "tests/stability/truth.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "procedural/field/octave_streams.h"
#include "procedural/model/texture.h"
#include "procedural/noise/noise.h"
#include "procedural/noise/perlin_noise.h"
#include "procedural/noise/simplex_noise.h"
#include "procedural/noise/value_noise.h"

namespace burl {

namespace {

using Real = long double;
using Cell = std::array<std::int64_t, 3>;

/// The weight of a cell's upper side at x in [0,1), and its derivative.
struct Weight {
    Real value, slope;
};

Weight weight_at(Fade fade, Real x) {
    if (fade == Fade::linear) return {x, 1.0L};
    if (fade == Fade::smooth) return {x * x * (3.0L - 2.0L * x), 6.0L * x * (1.0L - x)};
    const Real rest = 1.0L - x;
    return {x * x * x * (10.0L + x * (6.0L * x - 15.0L)), 30.0L * x * x * rest * rest};
}

/// Returns a lattice point's unweighted contribution at the offset `away` from it.
LongNoise corner(const NoiseSpec& noise, const Cell& cell, const LongPoint& away) {
    std::array<std::uint32_t, 3> index;
    for (std::size_t axis = 0; axis < 3; ++axis) index[axis] = std::uint32_t(cell[axis]);
    if (noise.kind == NoiseKind::value) return {Real(lattice_value(index, noise.seed)), {}};
    const auto g = perlin_gradient<double, 3>(lattice_gradient(index, noise.seed));
    LongNoise result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        result.gradient[axis] = Real(g[axis]);
        result.value += Real(g[axis]) * away[axis];
    }
    return result;
}

/// Returns the weighted sum over the eight corners of p's cell.
LongNoise interpolated(const NoiseSpec& noise, const LongPoint& p) {
    const Fade fade = noise.kind == NoiseKind::value ? noise.fade : Fade::quintic;
    LongNoise sum;
    for (std::size_t upper = 0; upper < 8; ++upper) {
        Cell cell;
        LongPoint away;
        std::array<Weight, 3> w;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Real below = std::floor(p[axis]);
            const bool up = upper >> axis & 1;
            w[axis] = weight_at(fade, p[axis] - below);
            if (!up) w[axis] = {1.0L - w[axis].value, -w[axis].slope};
            cell[axis] = std::int64_t(below) + up;
            away[axis] = p[axis] - below - Real(up);
        }
        const LongNoise n = corner(noise, cell, away);
        const Real all = w[0].value * w[1].value * w[2].value;
        sum.value += all * n.value;
        for (std::size_t axis = 0; axis < 3; ++axis)
            sum.gradient[axis] += all * n.gradient[axis] + w[axis].slope * w[(axis + 1) % 3].value *
                                                               w[(axis + 2) % 3].value * n.value;
    }
    return sum;
}

/// Simplex noise after Perlin's appendix B: the lattice is skewed along its diagonal, and the
/// simplex of p is walked from its lowest corner to its highest, along the axis of the largest
/// offset first.
LongNoise simplex(const NoiseSpec& noise, const LongPoint& p) {
    using Shape = SimplexShape<3>;
    const Real skew = (p[0] + p[1] + p[2]) / 3.0L;
    Cell cell;
    for (std::size_t axis = 0; axis < 3; ++axis)
        cell[axis] = std::int64_t(std::floor(p[axis] + skew));
    const Real back = Real(cell[0] + cell[1] + cell[2]) / 6.0L;
    LongPoint first;
    for (std::size_t axis = 0; axis < 3; ++axis) first[axis] = p[axis] - Real(cell[axis]) + back;
    std::array<std::size_t, 3> order{0, 1, 2};
    std::ranges::stable_sort(order, [&](auto a, auto b) { return first[a] > first[b]; });
    LongNoise sum;
    Cell steps{};
    for (std::size_t i = 0; i < 4; ++i) {
        const Real taken = Real(i) / 6.0L;
        LongPoint d;
        std::array<std::uint32_t, 3> index;
        Real t = Real(noise.radius2), slope = 0.0L;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            d[axis] = first[axis] - Real(steps[axis]) + taken;
            index[axis] = std::uint32_t(cell[axis] + steps[axis]);
            t -= d[axis] * d[axis];
        }
        const auto g = Shape::gradient<double>(Shape::hash(index, noise.seed));
        for (std::size_t axis = 0; axis < 3; ++axis) slope += Real(g[axis]) * d[axis];
        if (t > 0.0L) {
            sum.value += 8.0L * t * t * t * t * slope;
            for (std::size_t axis = 0; axis < 3; ++axis)
                sum.gradient[axis] +=
                    8.0L * t * t * t * (t * Real(g[axis]) - 8.0L * slope * d[axis]);
        }
        if (i < 3) ++steps[order[i]];
    }
    return sum;
}

using Real = long double;

LongPoint mapped(const Affine3& map, const LongPoint& p) {
    LongPoint result;
    for (int row = 0; row < 3; ++row) {
        Real sum = Real(map.offset[row]);
        for (int column = 0; column < 3; ++column)
            sum += Real(map.linear[column][row]) * p[std::size_t(column)];
        result[std::size_t(row)] = sum;
    }
    return result;
}

/// Returns the sums of the magnitudes of the terms of mapped().
Vec3d term_sizes(const Affine3& map, const Vec3d& sizes) {
    Vec3d result(0.0);
    for (int row = 0; row < 3; ++row) {
        result[row] = std::abs(map.offset[row]);
        for (int column = 0; column < 3; ++column)
            result[row] += std::abs(map.linear[column][row]) * sizes[column];
    }
    return result;
}

Real quadric_at(const Quadric& q, const LongPoint& p) {
    const auto& [s, t, r] = p;
    return Real(q.a) * s * s + 2.0L * Real(q.b) * s * t + 2.0L * Real(q.c) * s * r +
           2.0L * Real(q.d) * s + Real(q.e) * t * t + 2.0L * Real(q.f) * t * r +
           2.0L * Real(q.g) * t + Real(q.h) * r * r + 2.0L * Real(q.i) * r + Real(q.j);
}

LongPoint quadric_gradient(const Quadric& q, const LongPoint& p) {
    const auto& [s, t, r] = p;
    return {2.0L * (Real(q.a) * s + Real(q.b) * t + Real(q.c) * r + Real(q.d)),
            2.0L * (Real(q.b) * s + Real(q.e) * t + Real(q.f) * r + Real(q.g)),
            2.0L * (Real(q.c) * s + Real(q.f) * t + Real(q.h) * r + Real(q.i))};
}

double quadric_sizes(const Quadric& q, const Vec3d& s) {
    const Quadric sizes{std::abs(q.a), std::abs(q.b), std::abs(q.c), std::abs(q.d), std::abs(q.e),
                        std::abs(q.f), std::abs(q.g), std::abs(q.h), std::abs(q.i), std::abs(q.j)};
    return double(quadric_at(sizes, {s.x, s.y, s.z}));
}

/// Returns n, |n| or (1 - |n|)^2 with its gradient.
LongNoise shaped_noise(OctaveShape shape, LongNoise n) {
    if (shape == OctaveShape::plain) return n;
    Real slope = Real(n.value > 0.0L) - Real(n.value < 0.0L);
    if (shape == OctaveShape::ridged) slope *= -2.0L * (1.0L - std::abs(n.value));
    n.value = shaped(shape, n.value);
    for (Real& x : n.gradient) x *= slope;
    return n;
}

}  // namespace

bool has_long_form(const NoiseSpec& noise) {
    return (noise.kind == NoiseKind::value || noise.kind == NoiseKind::perlin ||
            noise.kind == NoiseKind::simplex) &&
           noise.period == Period<4>{} && !noise.time;
}

LongNoise long_noise(const NoiseSpec& noise, const LongPoint& p) {
    if (has_long_form(noise))
        return noise.kind == NoiseKind::simplex ? simplex(noise, p) : interpolated(noise, p);
    const auto sample = sample_noise<double, 3>(noise, {double(p[0]), double(p[1]), double(p[2])});
    return {Real(sample.value),
            {Real(sample.gradient[0]), Real(sample.gradient[1]), Real(sample.gradient[2])}};
}

bool has_jumps(const NoiseSpec& noise) {
    if (noise.kind == NoiseKind::cell || noise.kind == NoiseKind::white) return true;
    return noise.kind == NoiseKind::simplex && !noise.time && noise.radius2 > 0.5;
}

StabilityTruth::StabilityTruth(const Texture& texture, const Affine3& texture_from_atlas)
    : texture_(texture), map_(texture_from_atlas), octaves_(expand_octaves(texture)) {
    for (const Octave& octave : octaves_) {
        amplitudes_ += std::abs(octave.scale) + std::abs(octave.offset);
        double special = octave.shape == OctaveShape::ridged ? 2.5e-7 : 0.0;
        if (octave.noise.kind == NoiseKind::simplex && !has_kernel(octave))
            special += octave.noise.time ? 7.5e-7 : 2.5e-7;
        special_errors_ += special * std::abs(octave.scale);
        jumps_ = jumps_ || has_jumps(octave.noise);
    }
}

LongPoint StabilityTruth::point(const TexelMap& map, std::int64_t x, std::int64_t y) const {
    LongPoint p;
    for (int axis = 0; axis < 3; ++axis)
        p[std::size_t(axis)] = Real(map.origin[axis]) +
                               Real(x - map.anchor_x) * Real(map.step_x[axis]) +
                               Real(y - map.anchor_y) * Real(map.step_y[axis]);
    return mapped(map_, p);
}

long double StabilityTruth::field(const LongPoint& s) const {
    Real f = quadric_at(texture_.quadric, s);
    for (const Octave& octave : octaves_)
        f += Real(octave.offset) +
             Real(octave.scale) *
                 shaped(octave.shape,
                        long_noise(octave.noise, mapped(octave.lattice_from_solid, s)).value);
    return f;
}

/// Returns f at s with every octave extrapolated linearly from beside its lattice coordinates.
long double StabilityTruth::from_side(const LongPoint& s, const LongPoint& side) const {
    Real f = quadric_at(texture_.quadric, s);
    for (const Octave& octave : octaves_) {
        LongPoint p = mapped(octave.lattice_from_solid, s);
        for (std::size_t axis = 0; axis < 3; ++axis) p[axis] += side[axis];
        const LongNoise n = shaped_noise(octave.shape, long_noise(octave.noise, p));
        Real value = n.value;
        for (std::size_t axis = 0; axis < 3; ++axis) value -= side[axis] * n.gradient[axis];
        f += Real(octave.offset) + Real(octave.scale) * value;
    }
    return f;
}

LongNoise StabilityTruth::sample(const LongPoint& s) const {
    LongNoise f{quadric_at(texture_.quadric, s), quadric_gradient(texture_.quadric, s)};
    for (const Octave& octave : octaves_) {
        const Affine3& map = octave.lattice_from_solid;
        const LongNoise n = shaped_noise(octave.shape, long_noise(octave.noise, mapped(map, s)));
        f.value += Real(octave.offset) + Real(octave.scale) * n.value;
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                f.gradient[std::size_t(column)] += Real(octave.scale) *
                                                   Real(map.linear[column][row]) *
                                                   n.gradient[std::size_t(row)];
    }
    return f;
}

double StabilityTruth::error(const LongPoint& s, double got, const SpanSizes& sizes,
                             double place_error) const {
    auto least = double(std::abs(Real(got) - field(s)));
    if (!jumps_ || least <= 1e-15 * amplitudes_) return least;
    const Real reach = 4.0L * 0x1p-52L * Real(sizes.lattice) + Real(place_error);
    for (int i = 0; i < 27; ++i) {
        const LongPoint side{reach * (i % 3 - 1), reach * (i / 3 % 3 - 1), reach * (i / 9 - 1)};
        least = std::min(least, double(std::abs(Real(got) - from_side(s, side))));
    }
    return least;
}

SpanSizes StabilityTruth::sizes(const Span& span, const TexelMap& map, std::int64_t y) const {
    const double right = double(std::int64_t(span.x) + span.count - 1 - map.anchor_x),
                 columns = std::max(std::abs(double(span.x) - map.anchor_x), std::abs(right)),
                 rows = std::abs(double(y - map.anchor_y));
    const auto sizes = [](const Vec3d& v) {
        return Vec3d(std::abs(v.x), std::abs(v.y), std::abs(v.z));
    };
    const Vec3d s = term_sizes(
        map_, sizes(map.origin) + columns * sizes(map.step_x) + rows * sizes(map.step_y));
    SpanSizes result{0.0, quadric_sizes(texture_.quadric, s)};
    for (const Octave& octave : octaves_) {
        const Vec3d p = term_sizes(octave.lattice_from_solid, s);
        result.lattice = std::max({result.lattice, p.x, p.y, p.z});
    }
    return result;
}

double StabilityTruth::rounding(const SpanSizes& sizes) const {
    return 4.0 * 0x1p-52 * (sizes.lattice * amplitudes_ + sizes.quadric);
}

Vec3d long_color(const ColorMap& map, long double f) {
    const Real index = map.wrap == Wrap::repeat ? f - std::floor(f) : f;
    return evaluate_color(map, double(index));
}

}  // namespace burl
