#pragma once
// Tangent space as glTF 2.0 defines it (specification 3.7.2.1 and 3.9.3): a normal map stores the
// components of a normal along a tangent (image to the right), a bitangent (image up) and the
// vertex normal.
#include <algorithm>
#include <cmath>
#include <limits>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

/// A tangent frame: unit vectors except for the bitangent, which is shorter where the other two are
/// not perpendicular.
struct TangentFrame {
    Vec3d tangent{0.0}, bitangent{0.0}, normal{0.0};
};

/// The frame of a point inside a triangle, from its vertices' interpolated vectors: tangent and
/// normal are normalised each by itself, and the bitangent is cross(normal, tangent) * w. `w` is 1,
/// or -1 on mirrored charts. shaders/draw/mesh.frag has the same arithmetic.
inline TangentFrame tangent_frame(const Vec3d& normal, const Vec3d& tangent, double w) {
    TangentFrame frame{glm::normalize(tangent), {}, glm::normalize(normal)};
    frame.bitangent = w * glm::cross(frame.normal, frame.tangent);
    return frame;
}

/// The unit vector c from which a viewer gets the direction of `v`: c.x tangent + c.y bitangent +
/// c.z normal. c.z is at least 0, as the format requires; c is (0, 0, 1) in a degenerate frame, and
/// exactly where v is the normal.
inline Vec3d in_frame(const TangentFrame& frame, const Vec3d& v) {
    if (v == frame.normal) return {0.0, 0.0, 1.0};
    const double height = glm::dot(frame.bitangent, frame.bitangent);
    const double slant = glm::dot(frame.tangent, frame.normal);
    const double along = glm::dot(frame.tangent, v), up = glm::dot(frame.normal, v);
    // |bitangent|^2 = 1 - slant^2 is the determinant for the other two.
    const Vec3d c(along - slant * up, glm::dot(frame.bitangent, v), up - slant * along);
    const Vec3d kept(c.x, c.y, std::max(c.z, 0.0));
    const double length = glm::length(kept);
    if (!(height > 1e-12) || !(length > 0.0)) return {0.0, 0.0, 1.0};
    return kept / length;
}

/// The direction that a viewer gets from c.
inline Vec3d from_frame(const TangentFrame& frame, const Vec3d& c) {
    return glm::normalize(c.x * frame.tangent + c.y * frame.bitangent + c.z * frame.normal);
}

/// Components from -1 to 1 as linear codes from 0 to the largest, rounded: 0 is 128 of 255 (decoded
/// as 1/255), 32768 of 65535.
template <class Code>
Rgb<Code> encode_normal(const Vec3d& n) {
    const auto code = [](double x) {
        const double largest = double(std::numeric_limits<Code>::max());
        return Code(std::floor(std::clamp(0.5 + 0.5 * x, 0.0, 1.0) * largest + 0.5));
    };
    return {code(n.x), code(n.y), code(n.z)};
}

}  // namespace burl
