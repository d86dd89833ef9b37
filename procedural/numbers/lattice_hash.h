#pragma once
// Random numbers at lattice points, from arithmetic instead of Perlin's tables: a sum of prime
// multiples of the coordinates (a sum, because exclusive-or makes more than half the points of a
// block about the origin share their value with another), then Wellons' two-multiply mixer
// "lowbias32" without its last xorshift, which reaches only bits that are not used. All arithmetic
// is in 32-bit unsigned integers, so a shader computes the same bits.
#include <array>
#include <cstddef>
#include <cstdint>

namespace burl {

struct LatticeHash {
    static constexpr std::uint32_t prime_x = 0x8da6b343u, prime_y = 0xd8163841u,
                                   prime_z = 0xcb1ab31fu, prime_w = 0xc2b2ae3du,
                                   prime_seed = 0x9e3779b1u;
    static constexpr std::uint32_t multiplier_1 = 0x7feb352du, multiplier_2 = 0x846ca68bu;

    /// Wellons' mixer: 32 bits to 32 bits, of which the high ones are the better mixed.
    static constexpr std::uint32_t mix(std::uint32_t h) {
        h ^= h >> 16;
        h *= multiplier_1;
        h ^= h >> 15;
        return h * multiplier_2;
    }

    /// Random bits of a lattice point of up to four coordinates, missing ones being 0; the high
    /// bits are the better mixed.
    template <std::size_t N>
    static constexpr std::uint32_t bits(const std::array<std::uint32_t, N>& index,
                                        std::uint32_t seed) {
        static_assert(N <= 4);
        constexpr std::array primes{prime_x, prime_y, prime_z, prime_w};
        std::uint32_t h = seed * prime_seed;
        for (std::size_t axis = 0; axis < N; ++axis) h += index[axis] * primes[axis];
        return mix(h);
    }

    static constexpr std::uint32_t bits(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                                        std::uint32_t seed) {
        return bits(std::array{i, j, k}, seed);
    }

    /// The shift in cells, 0..255 and 0 for seed 0, by which a seed moves a noise whose random
    /// numbers are a fixed table of period 256.
    static constexpr std::uint32_t shift(std::uint32_t seed, std::size_t axis) {
        return seed == 0 ? 0 : mix(seed * prime_seed + std::uint32_t(axis) * prime_x) >> 24;
    }
};

}  // namespace burl
