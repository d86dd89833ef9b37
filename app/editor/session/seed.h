#pragma once
// Another seed at the press of a button, the same one in every run, so that scripts repeat.
#include <cstdint>

namespace burl {

/// The next of all numbers below 2^16, each of which comes once before the first comes again. Far
/// apart, because octave k of a noise uses seed + k: with the next number most octaves would stay.
inline std::uint32_t next_seed(std::uint64_t seed) {
    return std::uint32_t((seed % 65536U) * 25173U + 13849U) % 65536U;
}

}  // namespace burl
