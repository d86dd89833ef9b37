#pragma once
// Perlin's improved gradient noise ("Improving Noise", 2002): quintic weights, and gradients to the
// edges' midpoints of a cube, in three dimensions and, by the same rule, four. The random number of
// a lattice point comes from LatticeHash (kind `perlin`) or from Perlin's published permutation
// (kind `perlin2002`, which repeats after 256 cells).
#include <array>
#include <cstdint>

#include "procedural/noise/interpolated_noise.h"
#include "procedural/numbers/lattice_hash.h"

namespace burl {

/// The permutation of 0..255 that Perlin published with his improved noise ("Improving Noise",
/// 2002), so that values can be compared with every other program that carries it.
inline constexpr std::array<std::uint8_t, 256> published_permutation{
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103,
    30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,
    197, 62,  94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174,
    20,  125, 136, 171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231,
    83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143,
    54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196,
    135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124,
    123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,
    182, 189, 28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101,
    155, 167, 43,  172, 9,   129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185,
    112, 104, 218, 246, 97,  228, 251, 34,  242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,
    51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,  181, 199, 106, 157, 184, 84,  204, 176,
    115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114, 67,  29,  24,  72,  243,
    141, 128, 195, 78,  66,  215, 61,  156, 180};

//// The permutation's element i modulo 256.
constexpr std::uint32_t permuted(std::uint32_t i) {
    return published_permutation[i & 255];
}

/// The bits of a gradient's number: 16 numbers for the 12 edges of a cube, 32 for the 32 edges of a
/// hypercube.
template <std::size_t N>
inline constexpr unsigned gradient_bits = N == 3 ? 4 : 5;

/// The gradient of a number below 16: the 12 edges, four of them twice, numbered as in the 2002
/// paper.
template <class Real>
constexpr std::array<Real, 3> perlin_gradient(std::uint32_t number, std::array<Real, 3>*) {
    const std::size_t first = number < 8 ? 0 : 1;
    const std::size_t second = number < 4 ? 1 : (number == 12 || number == 14 ? 0 : 2);
    std::array<Real, 3> g{};
    g[first] = number & 1 ? Real(-1) : Real(1);
    g[second] = number & 2 ? Real(-1) : Real(1);
    return g;
}

/// The gradient of a number below 32: the upper two bits name the axis whose component is 0, the
/// lower three are the signs of the others.
template <class Real>
constexpr std::array<Real, 4> perlin_gradient(std::uint32_t number, std::array<Real, 4>*) {
    std::array<Real, 4> g{};
    std::uint32_t signs = number;
    for (std::uint32_t axis = 0; axis < 4; ++axis) {
        if (axis == number >> 3) continue;
        g[axis] = signs & 1 ? Real(-1) : Real(1);
        signs >>= 1;
    }
    return g;
}

/// The gradient of a number below 2^gradient_bits<N>, in N dimensions.
template <class Real, std::size_t N>
constexpr std::array<Real, N> perlin_gradient(std::uint32_t number) {
    return perlin_gradient<Real>(number, static_cast<std::array<Real, N>*>(nullptr));
}

/// g . d for the gradient g of `number`, computed without building g: bakes take many such values.
template <class Real>
void set_perlin_slope(std::uint32_t number, const std::array<Real, 3>& d,
                      NoiseValue<Real, 3>& sample) {
    const Real a = number < 8 ? d[0] : d[1];
    const Real b = number < 4 ? d[1] : (number == 12 || number == 14 ? d[0] : d[2]);
    sample.value = (number & 1 ? -a : a) + (number & 2 ? -b : b);
}

/// g . d, and g itself where the sample has a gradient, for the gradient g of `number`.
template <class Real, std::size_t N, class Sample>
void set_perlin_slope(std::uint32_t number, const std::array<Real, N>& d, Sample& sample) {
    set_slope(perlin_gradient<Real, N>(number), d, sample);
}

/// Perlin's noise of 2002, where `number(index)` is the gradient's number at a lattice point. The
/// noise is 0 at lattice points; |n| <= 1.0364 in three dimensions, 1.5366 in four. In float32 the
/// value errs by at most 5e-7 and a gradient's component by 3e-6.
template <template <class, std::size_t> class Sample, class Real, std::size_t N, class Number>
Sample<Real, N> perlin_noise(const Point<N>& p, const Period<N>& period, Number&& number) {
    return interpolate_corners(
        lattice_site<Real>(p, period), Fade::quintic,
        [&number](const std::array<std::uint32_t, N>& index, const std::array<Real, N>& offset) {
            Sample<Real, N> sample;
            set_perlin_slope(number(index), offset, sample);
            return sample;
        });
}

/// The gradient number of kind `perlin`: the upper bits of LatticeHash.
template <std::size_t N>
std::uint32_t lattice_gradient(const std::array<std::uint32_t, N>& index, std::uint32_t seed) {
    return LatticeHash::bits(index, seed) >> (32 - gradient_bits<N>);
}

/// The gradient number of kind `perlin2002`: the lower bits of P[P[P[i] + j] + k], P being the
/// published permutation. A seed moves the lattice.
template <std::size_t N>
std::uint32_t published_gradient(const std::array<std::uint32_t, N>& index, std::uint32_t seed) {
    std::uint32_t h = 0;
    for (std::size_t axis = 0; axis < N; ++axis)
        h = permuted(h + index[axis] + LatticeHash::shift(seed, axis));
    return h & ((1u << gradient_bits<N>)-1);
}

}  // namespace burl
