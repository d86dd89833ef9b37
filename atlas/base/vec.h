#pragma once
// Names for the GLM types the project uses, so that a signature says its precision: geometry is
// double, texture values are float.
#include <glm/glm.hpp>

namespace burl {

using Vec2d = glm::dvec2;
using Vec3d = glm::dvec3;
using Vec4d = glm::dvec4;
using Vec3f = glm::vec3;
using Vec4f = glm::vec4;
using Mat3d = glm::dmat3;
using Mat4d = glm::dmat4;

/// Signed area of the parallelogram that `a` and `b` span; positive where b lies counter-clockwise
/// of a.
inline double cross(const Vec2d& a, const Vec2d& b) {
    return a.x * b.y - a.y * b.x;
}

/// Affine map of space: p -> linear * p + offset.
struct Affine3 {
    Mat3d linear{1.0};
    Vec3d offset{0.0};
    Vec3d operator()(const Vec3d& p) const { return linear * p + offset; }
    /// The composition p -> (*this)(first(p)).
    Affine3 after(const Affine3& first) const {
        return {linear * first.linear, linear * first.offset + offset};
    }
    bool operator==(const Affine3&) const = default;
};

}  // namespace burl
