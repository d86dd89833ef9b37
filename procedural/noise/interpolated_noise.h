#pragma once
// Interpolation on the cubic lattice, which value noise and all of Perlin's lattice noises share:
// every corner of the cell gives a number, a constant or the height of a slope through the corner,
// and faded weights blend the numbers (Perlin 1985, "An Image Synthesizer"). The gradient comes by
// the product rule. The weights are linear, Perlin's s-curve 3x^2 - 2x^3 (1985) or his quintic
// 6x^5 - 15x^4 + 10x^3 (2002), written about the cell's middle, as t plus a correction that
// vanishes towards the ends: so they lose less in float32 than as powers of x.
#include <utility>

#include "procedural/noise/lattice_site.h"

namespace burl {

/// The weight w of the upper corner as v = 2 w - 1 in [-1, 1], and the slope dv/du.
template <class Real>
struct FadeWeight {
    Real v = 0, slope = 0;
};

/// The weight at u = x - 1/2 in [-1/2, 1/2], x being the place in the cell.
template <class Real>
FadeWeight<Real> fade_weight(Fade fade, Real u) {
    const Real t = u + u, square = t * t;
    switch (fade) {
        case Fade::linear:
            return {t, Real(2)};
        case Fade::smooth:
            return {t + t * (Real(0.5) - Real(0.5) * square), Real(3) - Real(3) * square};
        case Fade::quintic: {
            const Real rest = Real(1) - square;
            return {t + t * (rest * (Real(0.875) - Real(0.375) * square)),
                    Real(3.75) * (rest * rest)};
        }
    }
    return {t, Real(2)};
}

/// ((a + b) + v (b - a)) / 2: the blend of a and b for v = 2 w - 1, w being the weight of b.
template <class Real>
Real half_lerp(Real v, Real a, Real b) {
    return Real(0.5) * ((a + b) + v * (b - a));
}

/// The blend of a and b by a weight that varies along `axis`, with its gradient if they have one.
template <class Real, std::size_t N>
NoiseValue<Real, N> blend(const NoiseValue<Real, N>& a, const NoiseValue<Real, N>& b, std::size_t,
                          const FadeWeight<Real>& weight) {
    return {half_lerp(weight.v, a.value, b.value)};
}

template <class Real, std::size_t N>
NoiseSample<Real, N> blend(const NoiseSample<Real, N>& a, const NoiseSample<Real, N>& b,
                           std::size_t axis, const FadeWeight<Real>& weight) {
    NoiseSample<Real, N> sum{half_lerp(weight.v, a.value, b.value), {}};
    for (std::size_t i = 0; i < N; ++i)
        sum.gradient[i] = half_lerp(weight.v, a.gradient[i], b.gradient[i]);
    sum.gradient[axis] += Real(0.5) * weight.slope * (b.value - a.value);
    return sum;
}

/// The noise at a site, blended from its cell's 2^N corners. `corner(index, offset)` gives the
/// sample (NoiseSample or NoiseValue) that the lattice point `index` has at `offset` from it; index
/// and offset are arrays of N.
template <class Real, std::size_t N, class Corner>
auto interpolate_corners(const LatticeSite<Real, N>& site, Fade fade, Corner&& corner) {
    using Sample = decltype(corner(std::array<std::uint32_t, N>{}, site.place));
    std::array<Sample, (1u << N)> samples;
    std::array<std::array<std::uint32_t, 2>, N> indices;
    for (std::size_t axis = 0; axis < N; ++axis)
        indices[axis] = {site.index(axis, 0), site.index(axis, 1)};
    const auto set_corner = [&](std::size_t c) {
        std::array<std::uint32_t, N> index;
        std::array<Real, N> offset;
        for (std::size_t axis = 0; axis < N; ++axis) {
            const std::size_t upper = c >> axis & 1;
            index[axis] = indices[axis][upper];
            offset[axis] = site.place[axis] + (upper ? Real(-0.5) : Real(0.5));
        }
        samples[c] = corner(index, offset);
    };
    // Unrolled, so that corners share the work that depends on some of their coordinates only.
    [&]<std::size_t... c>(std::index_sequence<c...>) {
        (set_corner(c), ...);
    }
    (std::make_index_sequence<(1u << N)>());
    for (std::size_t axis = 0; axis < N; ++axis) {
        const FadeWeight<Real> weight = fade_weight(fade, site.place[axis]);
        for (std::size_t c = 0; c < samples.size() >> (axis + 1); ++c)
            samples[c] = blend(samples[2 * c], samples[2 * c + 1], axis, weight);
    }
    return samples[0];
}

/// The slope g . d through a lattice point, at offset d from it, and its gradient g.
template <class Real, std::size_t N>
void set_slope(const std::array<Real, N>& g, const std::array<Real, N>& d,
               NoiseValue<Real, N>& sample) {
    sample.value = g[0] * d[0];
    for (std::size_t axis = 1; axis < N; ++axis) sample.value += g[axis] * d[axis];
}

template <class Real, std::size_t N>
void set_slope(const std::array<Real, N>& g, const std::array<Real, N>& d,
               NoiseSample<Real, N>& sample) {
    NoiseValue<Real, N> value;
    set_slope(g, d, value);
    sample = {value.value, g};
}

}  // namespace burl
