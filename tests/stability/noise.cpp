#include "tests/stability/noise.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

}  // namespace burl
