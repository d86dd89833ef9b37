#pragma once
// Small functions that the files of this room share.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

inline Vec3d vec_of(const RgbF& c) {
    return {double(c.r), double(c.g), double(c.b)};
}

inline RgbF rgb_of(const Vec3d& c) {
    return {float(c.x), float(c.y), float(c.z)};
}

/// Luminance of linear light with Rec. 709 primaries.
inline double luminance(const Vec3d& c) {
    return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

/// A cubic step from 0 at `low` to 1 at `high`, which may be the smaller of the two.
inline double smooth_step(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

inline Vec3d mixed(const Vec3d& a, const Vec3d& b, double share) {
    return a + share * (b - a);
}

/// The unit direction at an azimuth (0: +z, 90: +x, as cameras count it) and elevation in degrees.
inline Vec3d towards(double azimuth, double elevation) {
    const double a = azimuth * std::numbers::pi / 180.0, e = elevation * std::numbers::pi / 180.0;
    return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

}  // namespace burl
