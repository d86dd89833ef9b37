#include "app/base/rotation_angles.h"

#include <cmath>
#include <numbers>

#include "procedural/numbers/rotation.h"

namespace burl {

namespace {

constexpr double pole = 1e-14;  // a cosine of y's angle up to this counts as gimbal lock

double degrees(double radians) {
    return radians * 180.0 / std::numbers::pi;
}

/// The angle in degrees plus the whole turns that bring it nearest to `near`, wrapped into [-360,
/// 360].
double wound(double angle, double near) {
    const double close = angle + 360.0 * std::round((near - angle) / 360.0);
    return close > 360.0 ? close - 360.0 : close < -360.0 ? close + 360.0 : close;
}

Vec3d wound(const Vec3d& angles, const Vec3d& near) {
    return {wound(angles.x, near.x), wound(angles.y, near.y), wound(angles.z, near.z)};
}

double away(const Vec3d& angles, const Vec3d& near) {
    const Vec3d d = glm::abs(angles - near);
    return d.x + d.y + d.z;
}

/// The three angles for a given x: y and z come from the rotation with the turn about x undone, so
/// that an error of x does not spread to them.
Vec3d with_x(const Mat3d& rotation, double x) {
    const Mat3d rest = rotation * glm::transpose(rotation_about(0, x));  // Rz Ry
    return {x, degrees(std::atan2(-rest[0][2], rest[2][2])),
            degrees(std::atan2(-rest[1][0], rest[1][1]))};
}

/// The direction at length 1; a zero vector stays 0.
Vec3d unit(const Vec3d& direction) {
    const double length = glm::length(direction);
    return length > 0.0 ? direction / length : Vec3d(0.0);
}

Mat3d half_turn_about(const Vec3d& unit_axis) {
    return 2.0 * glm::outerProduct(unit_axis, unit_axis) - Mat3d(1.0);
}

Vec3d across(const Vec3d& unit_direction) {
    const Vec3d a = glm::abs(unit_direction);
    const Vec3d aside = a.x <= a.y && a.x <= a.z ? Vec3d(1, 0, 0)
                        : a.y <= a.z             ? Vec3d(0, 1, 0)
                                                 : Vec3d(0, 0, 1);
    return glm::normalize(glm::cross(unit_direction, aside));
}

}  // namespace

Vec3d angles_of(const Mat3d& rotation, const Vec3d& near) {
    // Sine and cosine of x's angle, times the cosine of y's.
    const double sine = rotation[1][2], cosine = rotation[2][2];
    if (std::hypot(sine, cosine) < pole) return wound(with_x(rotation, near.x), near);
    const double x = degrees(std::atan2(sine, cosine));
    const Vec3d one = wound(with_x(rotation, x), near),
                other = wound(with_x(rotation, x + 180.0), near);
    return away(one, near) <= away(other, near) ? one : other;
}

/// Two half turns, about `from` and about the bisector of both directions, make twice the rotation
/// from the one axis to the other. Unlike Rodrigues' formula this preserves lengths near opposite
/// directions, too.
Mat3d turn_between(const Vec3d& from, const Vec3d& to) {
    const Vec3d a = unit(from), b = unit(to);
    if (a == Vec3d(0.0) || b == Vec3d(0.0)) return Mat3d(1.0);
    const Vec3d sum = a + b;
    const Vec3d middle = glm::length(sum) > 1e-9 ? glm::normalize(sum) : across(a);
    return half_turn_about(middle) * half_turn_about(a);
}

Mat3d turn_about(const Vec3d& axis, double radians) {
    const Vec3d a = glm::normalize(axis), u = across(a), v = glm::cross(a, u);
    const Vec3d turned = std::cos(radians) * u + std::sin(radians) * v;
    const Mat3d from(u, v, a), to(turned, glm::cross(a, turned), a);
    return to * glm::transpose(from);
}

}  // namespace burl
