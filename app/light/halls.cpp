#include "app/light/halls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/light/formulas.h"

namespace burl {

namespace {

/// A rectangle of light that faces the origin.
struct SoftBox {
    double azimuth, elevation;       ///< of its middle, in degrees
    double half_width, half_height;  ///< over its distance
    Vec3d light;                     ///< in its middle
    double edge = 0.04;              ///< width of its soft edge, over its distance
    double fall = 0.35;              ///< share of the light that is lost in its corners
};

Vec3d light_of(const SoftBox& box, const Vec3d& direction) {
    const Vec3d middle = towards(box.azimuth, box.elevation);
    const double depth = glm::dot(direction, middle);
    if (depth <= 0.05) return Vec3d(0.0);
    const Vec3d right = towards(box.azimuth + 90.0, 0.0), up = glm::cross(middle, right);
    const double x = std::abs(glm::dot(direction, right)) / depth,
                 y = std::abs(glm::dot(direction, up)) / depth;
    const auto inside = [&](double at, double half) {
        return 1.0 - smooth_step(half - box.edge, half + box.edge, at);
    };
    const double share = inside(x, box.half_width) * inside(y, box.half_height);
    const double off = std::min(
        0.5 * (std::pow(x / box.half_width, 2.0) + std::pow(y / box.half_height, 2.0)), 1.0);
    return share * (1.0 - box.fall * off) * box.light;
}

const std::array<SoftBox, 5>& studio_boxes() {
    static const std::array<SoftBox, 5> boxes{
        {{-38.0, 36.0, 0.62, 0.62, Vec3d(6.4, 6.3, 6.1)},
         {118.0, 14.0, 0.17, 1.05, Vec3d(7.0, 7.1, 7.4), 0.03},
         {20.0, 84.0, 0.75, 0.45, Vec3d(3.2, 3.2, 3.2), 0.06},
         {-125.0, 22.0, 0.28, 0.75, Vec3d(2.6, 2.7, 2.9), 0.05},
         {75.0, -6.0, 0.30, 0.22, Vec3d(0.8, 0.78, 0.74), 0.12}}};
    return boxes;
}

/// A point of the inside of a box, and the axis of the wall that it lies on.
struct WallHit {
    Vec3d point;
    int axis;
};

/// Where a ray from the origin leaves the box.
WallHit leave(const Vec3d& low, const Vec3d& high, const Vec3d& direction) {
    WallHit hit{Vec3d(0.0), 0};
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        if (direction[k] == 0.0) continue;
        const double t = (direction[k] > 0.0 ? high[k] : low[k]) / direction[k];
        if (t < nearest) nearest = t, hit.axis = k;
    }
    hit.point = nearest * direction;
    return hit;
}

/// The share of a stripe pattern: stripes of width `wide` every `period`, with soft edges.
double stripes(double x, double period, double wide, double edge) {
    const double at = std::abs(x - period * std::round(x / period));
    return 1.0 - smooth_step(0.5 * wide - edge, 0.5 * wide + edge, at);
}

double within(double x, double low, double high, double edge) {
    return smooth_step(low - edge, low + edge, x) *
           (1.0 - smooth_step(high - edge, high + edge, x));
}

// The hall in metres, about a camera 1.5 m above its floor.
const Vec3d hall_low(-9.0, -1.5, -26.0), hall_high(9.0, 6.5, 16.0);

Vec3d roof_light(const Vec3d& p) {
    const double glass = stripes(p.z, 7.0, 2.4, 0.05) * within(std::abs(p.x), 1.2, 6.8, 0.05);
    const double bars = stripes(p.x, 1.4, 0.12, 0.02);
    const double beams = stripes(p.z - 3.5, 7.0, 0.5, 0.05);
    const Vec3d steel = Vec3d(0.16, 0.16, 0.17) * (1.0 - 0.6 * beams);
    return mixed(steel, Vec3d(8.5, 9.0, 9.8), glass * (1.0 - 0.8 * bars));
}

Vec3d floor_light(const Vec3d& p) {
    const double gate = std::exp(-0.02 * (p.x * p.x + (p.z + 22.0) * (p.z + 22.0)));
    const double sky = 0.5 + 0.2 * stripes(p.z, 7.0, 2.4, 1.1);
    return Vec3d(0.46, 0.45, 0.43) * sky + gate * Vec3d(1.1, 1.0, 0.86);
}

Vec3d side_light(const Vec3d& p) {
    const Vec3d plaster = Vec3d(0.42, 0.40, 0.37) * (0.75 + 0.05 * p.y);
    const Vec3d brick = Vec3d(0.30, 0.17, 0.12);
    const Vec3d wall = mixed(brick, plaster, smooth_step(0.2, 0.3, p.y));
    if (p.x > 0.0) return wall;
    const double windows = stripes(p.z - 2.0, 5.0, 2.8, 0.04) * within(p.y, 1.6, 4.6, 0.04);
    const double bars =
        std::max(stripes(p.z - 2.0, 0.7, 0.07, 0.02), stripes(p.y, 0.75, 0.07, 0.02));
    return mixed(wall, Vec3d(5.2, 5.5, 6.0), windows * (1.0 - 0.85 * bars));
}

Vec3d end_light(const Vec3d& p) {
    const Vec3d wall = Vec3d(0.36, 0.35, 0.33);
    if (p.z > 0.0) return 0.8 * wall;
    const double gate = within(p.x, -3.4, 3.4, 0.06) * within(p.y, -1.6, 3.6, 0.06);
    const Vec3d outside =
        mixed(Vec3d(3.4, 3.1, 2.6), Vec3d(7.5, 8.2, 9.4), smooth_step(-1.0, 2.0, p.y));
    return mixed(wall, outside, gate);
}

}  // namespace

Vec3d studio_light(const Vec3d& direction) {
    const double y = direction.y;
    const Vec3d wall =
        mixed(Vec3d(0.055, 0.057, 0.062), Vec3d(0.12, 0.12, 0.125), std::exp(-18.0 * y * y));
    const double pool = smooth_step(-0.15, -0.9, y);
    Vec3d light = mixed(wall, Vec3d(0.42, 0.41, 0.40), pool);
    for (const SoftBox& box : studio_boxes()) light += light_of(box, direction);
    return light;
}

Vec3d warehouse_light(const Vec3d& direction) {
    const WallHit hit = leave(hall_low, hall_high, direction);
    if (hit.axis == 0) return side_light(hit.point);
    if (hit.axis == 2) return end_light(hit.point);
    return hit.point.y > 0.0 ? roof_light(hit.point) : floor_light(hit.point);
}

Vec3d neutral_light(const Vec3d& direction) {
    double light = 0.62 + 0.30 * smooth_step(-0.9, 0.9, direction.y);
    const auto spot = [&](double azimuth, double elevation, double strength, double narrow) {
        const double cosine = glm::dot(direction, towards(azimuth, elevation));
        light += strength * std::exp(narrow * (cosine - 1.0));
    };
    spot(-45.0, 40.0, 1.5, 7.0);
    spot(120.0, 25.0, 1.0, 9.0);
    spot(0.0, 90.0, 0.8, 5.0);
    return Vec3d(light);
}

}  // namespace burl
