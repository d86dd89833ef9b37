#pragma once
// A button's next random seed: the same sequence in every run, so that scripts repeat.
#include <cstdint>

namespace burl {

/// Returns the next seed of a linear congruential generator with the full period 2^16. Successive
/// seeds are far apart, because octave k of a noise uses seed + k and neighbouring seeds would
/// share most octaves.
inline std::uint32_t next_seed(std::uint64_t seed) {
    return std::uint32_t((seed % 65536U) * 25173U + 13849U) % 65536U;
}

}  // namespace burl
