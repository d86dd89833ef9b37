#pragma once
// Worley's cellular noise ("A Cellular Texture Basis Function", 1996) with one feature point in
// every cell, uniform within it: distances, in cells, to the nearest feature points. The search is
// exact: it visits all cells that could hold one of the two nearest, which are at most two cells
// away along each axis.
#include <algorithm>
#include <cstdlib>

#include "procedural/noise/lattice_site.h"
#include "procedural/numbers/lattice_hash.h"

namespace burl {

/// Squared distances of the two nearest feature points, and the vectors from them to the point.
template <class Real, std::size_t N>
struct NearestFeatures {
    Real square1 = Real(1e6), square2 = Real(1e6);
    std::array<Real, N> way1{}, way2{};
};

/// A feature point's place in its cell: [0, 1) in steps of 2^-24 along each axis.
template <class Real, std::size_t N>
std::array<Real, N> feature_place(const std::array<std::uint32_t, N>& index, std::uint32_t seed) {
    const std::uint32_t h = LatticeHash::bits(index, seed);
    std::array<Real, N> place;
    for (std::uint32_t axis = 0; axis < N; ++axis)
        place[axis] =
            Real(0x1p-24) * Real(LatticeHash::mix(h + axis * LatticeHash::prime_seed) >> 8);
    return place;
}

/// The squared distance from a place about the cell's middle to the cell that lies `steps` away.
template <class Real, std::size_t N>
Real square_to_cell(const std::array<Real, N>& place, const std::array<int, N>& steps) {
    Real square = 0;
    for (std::size_t axis = 0; axis < N; ++axis) {
        const Real gap = std::abs(Real(steps[axis]) - place[axis]) - Real(0.5);
        if (steps[axis] != 0) square += gap * gap;
    }
    return square;
}

/// Updates the two nearest features by that of the cell `steps` away, unless the cell is too far.
template <class Real, std::size_t N>
void visit_feature(const LatticeSite<Real, N>& site, const std::array<int, N>& steps,
                   std::uint32_t seed, NearestFeatures<Real, N>& nearest) {
    if (square_to_cell(site.place, steps) >= nearest.square2) return;
    std::array<std::uint32_t, N> index;
    for (std::size_t axis = 0; axis < N; ++axis) index[axis] = site.index(axis, steps[axis]);
    const std::array<Real, N> feature = feature_place<Real>(index, seed);
    std::array<Real, N> way;
    Real square = 0;
    for (std::size_t axis = 0; axis < N; ++axis) {
        way[axis] = site.place[axis] - ((feature[axis] - Real(0.5)) + Real(steps[axis]));
        square += way[axis] * way[axis];
    }
    if (square < nearest.square1) {
        nearest.square2 = nearest.square1, nearest.way2 = nearest.way1;
        nearest.square1 = square, nearest.way1 = way;
    } else if (square < nearest.square2) {
        nearest.square2 = square, nearest.way2 = way;
    }
}

/// Advances to the next of the (2 reach + 1)^N steps in [-reach, reach]^N; false after the last.
template <std::size_t N>
bool next_steps(std::array<int, N>& steps, int reach) {
    for (int& step : steps) {
        if (++step <= reach) return true;
        step = -reach;
    }
    return false;
}

/// The two feature points nearest to a site. Nearer cells come first, so that most of the farther
/// ones are left out by their distance.
template <class Real, std::size_t N>
NearestFeatures<Real, N> nearest_features(const LatticeSite<Real, N>& site, std::uint32_t seed) {
    NearestFeatures<Real, N> nearest;
    visit_feature(site, {}, seed, nearest);
    for (const int reach : {1, 2}) {
        if (reach == 2 && nearest.square2 <= Real(1)) break;  // cells two away are at least 1 off
        std::array<int, N> steps;
        steps.fill(-reach);
        do {
            const bool outermost = std::any_of(
                steps.begin(), steps.end(), [reach](int step) { return std::abs(step) == reach; });
            if (outermost) visit_feature(site, steps, seed, nearest);
        } while (next_steps(steps, reach));
    }
    return nearest;
}

/// Worley's noise: the distance F1 or F2, or F2 - F1; 0 <= F1 <= F2 <= sqrt(3) in three dimensions
/// (at most 2 in four). The gradient jumps where the nearest point changes, and is 0 at a feature
/// point. In float32 the value errs by at most 5e-7; a gradient's component, where no two points
/// are equally near, by 5e-7 / F.
template <class Real, std::size_t N>
NoiseSample<Real, N> worley_noise(const Point<N>& p, WorleyFeature feature, std::uint32_t seed,
                                  const Period<N>& period = {}) {
    const auto nearest = nearest_features(lattice_site<Real>(p, period), seed);
    const auto distance = [](Real square, const std::array<Real, N>& way) {
        NoiseSample<Real, N> sample{std::sqrt(square), {}};
        if (square > 0)
            for (std::size_t axis = 0; axis < N; ++axis)
                sample.gradient[axis] = way[axis] / sample.value;
        return sample;
    };
    const NoiseSample<Real, N> f1 = distance(nearest.square1, nearest.way1);
    if (feature == WorleyFeature::f1) return f1;
    NoiseSample<Real, N> f2 = distance(nearest.square2, nearest.way2);
    if (feature == WorleyFeature::f2) return f2;
    f2.value -= f1.value;
    for (std::size_t axis = 0; axis < N; ++axis) f2.gradient[axis] -= f1.gradient[axis];
    return f2;
}

}  // namespace burl
