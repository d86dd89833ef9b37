#pragma once
// What a 16-bit floating-point image makes of a float32 (IEEE 754 binary16: 11 significant bits).
// OpenGL leaves the rounding to the implementation.
#include <bit>
#include <cmath>
#include <cstdint>

namespace burl {

enum class HalfRounding { nearest_even, toward_zero };

/// The neighbouring half float, as a float32; |x| must be less than 65504.
inline float half_rounded(float x, HalfRounding rounding) {
    if (std::abs(x) < 0x1p-14f) {  // here halves are 2^-24 apart; exact but for the rounding
        const float units = x * 0x1p24f;
        return 0x1p-24f *
               (rounding == HalfRounding::toward_zero ? std::trunc(units) : std::nearbyint(units));
    }
    auto bits = std::bit_cast<std::uint32_t>(x);
    if (rounding == HalfRounding::nearest_even) bits += 0xfff + (bits >> 13 & 1);
    return std::bit_cast<float>(bits & ~0x1fffu);
}

}  // namespace burl
