#pragma once
// The sRGB transfer function of IEC 61966-2-1, one way.
#include <cmath>

#include "atlas/base/vec.h"

namespace burl {

/// Linear light of an encoded value, both in [0, 1].
inline double srgb_decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// The colour in linear light that a mesh file's sRGB values stand for; alpha is linear. Values
/// outside [0, 1] stay as they are.
inline Vec4f linear_color(double r, double g, double b, double a = 1.0) {
    const auto decode = [](double x) { return float(x >= 0.0 && x <= 1.0 ? srgb_decode(x) : x); };
    return {decode(r), decode(g), decode(b), float(a)};
}

}  // namespace burl
