#pragma once
// Random numbers that depend on a counter alone, so that samples are the same in any order of
// threads: Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", 2014 (SplitMix64).
#include <cstdint>

namespace burl {

/// The output function of SplitMix64, a bijection of 64-bit integers.
inline std::uint64_t mix_bits(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// A random number in [0, 1) with 53 bits, a function of `seed` and `counter` alone.
inline double random_unit(std::uint64_t seed, std::uint64_t counter) {
    const std::uint64_t z = mix_bits(mix_bits(seed) + (counter + 1) * 0x9e3779b97f4a7c15u);
    return 0x1p-53 * double(z >> 11);
}

}  // namespace burl
