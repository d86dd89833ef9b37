#pragma once
// The rounding of float32 to the half floats (IEEE 754 binary16, 11 significant bits) of a 16-bit
// image; OpenGL leaves the direction to the implementation.
#include <bit>
#include <cmath>
#include <cstdint>

namespace burl {

enum class HalfRounding { nearest_even, toward_zero };

/// The half float next to x in the direction of `rounding`, as a float32; |x| must be less than
/// 65504.
inline float half_rounded(float x, HalfRounding rounding) {
    // Below 2^-14 half floats are 2^-24 apart, and scaling by 2^24 is exact.
    if (std::abs(x) < 0x1p-14f) {
        const float units = x * 0x1p24f;
        return 0x1p-24f *
               (rounding == HalfRounding::toward_zero ? std::trunc(units) : std::nearbyint(units));
    }
    auto bits = std::bit_cast<std::uint32_t>(x);
    if (rounding == HalfRounding::nearest_even) bits += 0xfff + (bits >> 13 & 1);
    return std::bit_cast<float>(bits & ~0x1fffu);
}

}  // namespace burl
