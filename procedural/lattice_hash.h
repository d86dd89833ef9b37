#pragma once
// The random numbers at lattice points, from arithmetic instead of Perlin's tables: a sum of prime
// multiples of the coordinates (a sum, because exclusive-or makes more than half the points of a
// block share their value with another), then Wellons' two-multiply mixer "lowbias32" without its
// last xorshift, which would only reach bits that are not used. All in 32-bit unsigned integers, so
// a shader computes the same bits.
#include <cstdint>

namespace burl {

struct LatticeHash {
    static constexpr std::uint32_t prime_x = 0x8da6b343u, prime_y = 0xd8163841u,
                                   prime_z = 0xcb1ab31fu, prime_seed = 0x9e3779b1u;
    static constexpr std::uint32_t multiplier_1 = 0x7feb352du, multiplier_2 = 0x846ca68bu;

    /// Random bits of lattice point (i,j,k); the high bits are the good ones.
    static constexpr std::uint32_t bits(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                                        std::uint32_t seed) {
        std::uint32_t h = i * prime_x + j * prime_y + k * prime_z + seed * prime_seed;
        h ^= h >> 16;
        h *= multiplier_1;
        h ^= h >> 15;
        return h * multiplier_2;
    }
};

}  // namespace burl
