#pragma once
// Perlin's improved noise ("Improving Noise", 2002) over Jenkins's hash instead of a table of
// permutations, for plain numbers and for numbers with gradients: Blender's and MaterialX's noise.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "procedural/numbers/lookup3.h"
#include "procedural/numbers/numeric.h"

namespace burl::numeric {

/// The product of a corner's gradient, one of Perlin's twelve, with the way from the corner.
template <class T>
T corner_ramp(std::uint32_t hash, const T& x, const T& y, const T& z) {
    const std::uint32_t h = hash & 15u;
    const T& u = h < 8 ? x : y;
    const T& v = h < 4 ? y : h == 12 || h == 14 ? x : z;
    const T first = (h & 1u) != 0 ? T(0.0) - u : u, second = (h & 2u) != 0 ? T(0.0) - v : v;
    return first + second;
}

/// The product of a corner's gradient of two dimensions, one of the eight (+-1, +-2) and (+-2,
/// +-1), with the way from the corner.
template <class T>
T corner_ramp(std::uint32_t hash, const T& x, const T& y) {
    const std::uint32_t h = hash & 7u;
    const T& u = h < 4 ? x : y;
    const T v = T(2.0) * (h < 4 ? y : x);
    const T first = (h & 1u) != 0 ? T(0.0) - u : u, second = (h & 2u) != 0 ? T(0.0) - v : v;
    return first + second;
}

template <class T>
T quintic_fade(const T& t) {
    return t * t * t * (t * (t * T(6.0) - T(15.0)) + T(10.0));
}

template <class T, std::size_t N>
std::array<T, N> blended(const T& w, const std::array<T, N>& a, const std::array<T, N>& b) {
    std::array<T, N> mix;
    for (std::size_t i = 0; i < N; ++i) mix[i] = blended(w, a[i], b[i]);
    return mix;
}

/// The word of a cell's coordinate that lies `step` cells on.
inline std::uint32_t cell_word(double cell, int step) {
    return low_word(cell) + std::uint32_t(step);
}

/// Whether a cell's coordinates are finite and within 2^30 of 0; noise is 0 elsewhere.
inline bool has_words(const Triple<double>& cell) {
    return std::max({std::abs(cell.x), std::abs(cell.y), std::abs(cell.z)}) < 0x1p30;
}

/// N noises at p, about -1 to 1: gradients of the first are chosen by the lowest bits of corners'
/// hashes, those of the others each by the next eight bits. All 0 beyond 2^30 cells.
template <std::size_t N, class T>
std::array<T, N> hashed_noises(const Triple<T>& p) {
    const Triple<double> cell = floors(values_of(p));
    if (!has_words(cell)) return {};
    const Triple<T> f = p - constants<T>(cell);
    const T u = quintic_fade(f.x), v = quintic_fade(f.y), w = quintic_fade(f.z);
    const auto corner = [&](int i, int j, int k) {
        const std::uint32_t hash =
            hash_words({cell_word(cell.x, i), cell_word(cell.y, j), cell_word(cell.z, k)});
        std::array<T, N> ramps;
        for (std::size_t n = 0; n < N; ++n)
            ramps[n] = T(0.982) * corner_ramp(hash >> (8 * n), f.x - T(i), f.y - T(j), f.z - T(k));
        return ramps;
    };
    const auto row = [&](int j, int k) { return blended(u, corner(0, j, k), corner(1, j, k)); };
    const auto plane = [&](int k) { return blended(v, row(0, k), row(1, k)); };
    return blended(w, plane(0), plane(1));
}

/// N noises at the first two coordinates of p, as hashed_noises of three.
template <std::size_t N, class T>
std::array<T, N> hashed_noises_2d(const Triple<T>& p) {
    const Triple<double> cell{floor_of(p.x), floor_of(p.y), 0.0};
    if (!has_words(cell)) return {};
    const T x = p.x - T(cell.x), y = p.y - T(cell.y);
    const T u = quintic_fade(x), v = quintic_fade(y);
    const auto corner = [&](int i, int j) {
        const std::uint32_t hash = hash_words({cell_word(cell.x, i), cell_word(cell.y, j)});
        std::array<T, N> ramps;
        for (std::size_t n = 0; n < N; ++n)
            ramps[n] = T(0.6616) * corner_ramp(hash >> (8 * n), x - T(i), y - T(j));
        return ramps;
    };
    const auto row = [&](int j) { return blended(u, corner(0, j), corner(1, j)); };
    return blended(v, row(0), row(1));
}

}  // namespace burl::numeric
