// Column lengths are the scale; the remaining matrix must be a rotation, whose quaternion is
// computed from its largest component (Shepperd, "Quaternion from rotation matrix", 1978).
#include "app/surface/node_transform.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace burl {
namespace {

constexpr double tolerance = 1e-9;

std::array<double, 4> quaternion(const Mat3d& r) {
    // Four times the squares of x, y, z, w; glm indexes [column][row].
    const std::array<double, 4> squares{
        1.0 + r[0][0] - r[1][1] - r[2][2], 1.0 - r[0][0] + r[1][1] - r[2][2],
        1.0 - r[0][0] - r[1][1] + r[2][2], 1.0 + r[0][0] + r[1][1] + r[2][2]};
    const double xy = r[1][0] + r[0][1], xz = r[2][0] + r[0][2], yz = r[2][1] + r[1][2];
    const double xw = r[1][2] - r[2][1], yw = r[2][0] - r[0][2], zw = r[0][1] - r[1][0];
    std::array<double, 4> q{};
    switch (std::max_element(squares.begin(), squares.end()) - squares.begin()) {
        case 0:
            q = {squares[0], xy, xz, xw};
            break;
        case 1:
            q = {xy, squares[1], yz, yw};
            break;
        case 2:
            q = {xz, yz, squares[2], zw};
            break;
        default:
            q = {xw, yw, zw, squares[3]};
            break;
    }
    const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    for (double& component : q) component = component / length + 0.0;
    return q;
}

}  // namespace

std::optional<NodeTransform> decompose(const Mat4d& matrix) {
    NodeTransform result;
    result.translation = Vec3d(matrix[3]);
    const Mat3d linear(matrix);
    for (int c = 0; c < 3; ++c) {
        result.scale[c] = glm::length(linear[c]);
        const bool usable = std::isfinite(result.scale[c]) && result.scale[c] > 0.0;
        if (!usable || !std::isfinite(result.translation[c])) return std::nullopt;
    }
    if (linear == Mat3d(1.0)) return result;
    if (glm::determinant(linear) < 0.0) result.scale.x = -result.scale.x;
    const Mat3d rotation(linear[0] / result.scale.x, linear[1] / result.scale.y,
                         linear[2] / result.scale.z);
    for (int c = 0; c < 3; ++c) {
        if (std::abs(glm::dot(rotation[c], rotation[(c + 1) % 3])) > tolerance) return std::nullopt;
    }
    result.rotation = quaternion(rotation);
    return result;
}

Mat4d matrix_of(const NodeTransform& transform) {
    const auto& [x, y, z, w] = transform.rotation;
    const Mat4d turned = glm::mat4_cast(glm::normalize(glm::dquat(w, x, y, z)));
    return glm::scale(glm::translate(Mat4d(1.0), transform.translation) * turned, transform.scale);
}

NormalTransform::NormalTransform(const Mat4d& matrix)
    : mirrors_(glm::determinant(Mat3d(matrix)) < 0.0) {
    const Mat3d m(matrix);
    cofactors_ = Mat3d(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    if (mirrors_) cofactors_ *= -1.0;
}

Vec3f NormalTransform::operator()(const Vec3f& normal) const {
    const Vec3d moved = cofactors_ * Vec3d(normal);
    const double longest = std::max({std::abs(moved.x), std::abs(moved.y), std::abs(moved.z)});
    if (!(longest > 0.0)) return {0.0f, 0.0f, 1.0f};
    return Vec3f(glm::normalize(moved / longest)) + 0.0f;
}

}  // namespace burl
