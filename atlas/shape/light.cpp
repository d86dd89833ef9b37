#include "atlas/shape/light.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/each_index.h"
#include "atlas/base/elementary.h"
#include "atlas/shape/open_share.h"

namespace burl {

namespace {

constexpr float endless = std::numeric_limits<float>::infinity();

/// One half of the sky about an axis.
struct HalfSky {
    Vec3f up{0.0f};
    bool upper = true;
    bool holds(const Vec3f& direction) const { return (glm::dot(direction, up) >= 0.0f) == upper; }
};

float share_of_sky(const ShapeScene& shape, const Hemisphere& hemisphere, const ShapePoint& point,
                   const HalfSky& sky, float reach) {
    if (point.normal == Vec3d(0.0)) return 0.5f;
    const auto counts = [&sky](const Vec3f& direction) { return sky.holds(direction); };
    return open_share(shape, hemisphere, point, reach, counts)
        .value_or(float(sky.holds(Vec3f(point.normal))));
}

/// Directions about the sun's, even on its disc: the cosine-weighted hemisphere's, whose squared
/// distances from the axis are even, taken to a cap.
class SunDisc {
  public:
    explicit SunDisc(const SunOptions& options)
        : axis_(options.direction),
          depth_(2.0 * sine(0.5 * options.angle) * sine(0.5 * options.angle)),
          spiral_(depth_ > 0.0 ? sun_rays : 1) {}

    /// The directions at a place, in the frame that they come with.
    Directions at(const Vec3d& place) const { return spiral_.at(place, axis_); }

    /// The direction on the cap that `local` of at() stands for.
    Vec3f on_cap(const Vec3f& local) const {
        const double x = double(local.x), y = double(local.y), square = x * x + y * y;
        const double out = std::sqrt(depth_ * (2.0 - square * depth_));
        return Vec3f(Vec3d(out * x, out * y, 1.0 - square * depth_));
    }

  private:
    Vec3d axis_;
    double depth_;  ///< of the cap: 1 less the cosine of its radius
    Hemisphere spiral_;
};

float sun_at(const ShapeScene& shape, const SunDisc& sun, const ShapePoint& point) {
    if (point.normal == Vec3d(0.0)) return 0.0f;
    const Vec3d place = shape.to_unit(point.position);
    const Directions directions = sun.at(place);
    const Vec3f normal(point.normal), shading(point.shading);
    const Vec3f origin(place + ray_offset * point.normal);
    double sum = 0.0;
    for (const Vec3f& local : directions.local) {
        const Vec3f direction = directions.frame(sun.on_cap(local));
        const float cosine = glm::dot(direction, shading);
        if (!(cosine > 0.0f && glm::dot(direction, normal) > 0.0f)) continue;
        if (!shape.rays().blocked({origin, direction}, endless)) sum += double(cosine);
    }
    return float(sum / double(directions.local.size()));
}

}  // namespace

void sky_light(const ShapeScene& shape, std::span<const ShapePoint> points, const Vec3d& up,
               SkyHalf half, const OcclusionOptions& options, std::span<float> values) {
    const Hemisphere hemisphere(options.rays);
    const auto reach = float(options.distance / shape.diagonal());
    const HalfSky sky{Vec3f(up), half == SkyHalf::upper};
    const auto work = [&](std::size_t i) {
        values[i] = share_of_sky(shape, hemisphere, points[i], sky, reach);
    };
    for_each_index(points.size(), work, points_at_a_time);
}

void sun_light(const ShapeScene& shape, std::span<const ShapePoint> points,
               const SunOptions& options, std::span<float> values) {
    const SunDisc sun(options);
    const auto work = [&](std::size_t i) { values[i] = sun_at(shape, sun, points[i]); };
    for_each_index(points.size(), work, points_at_a_time);
}

}  // namespace burl
