#pragma once
// Diffuse light without bounces: what reaches a point from a sky of two colours (Hemphill's
// "hemisphere light"; Landis, "Production-Ready Global Illumination", 2002, adds the rays) and from
// a sun that is a disc. Both are numbers, which a colour multiplies.
#include "atlas/shape/occlusion.h"

namespace burl {

/// The half of the sphere of directions that lies on the side of an axis, or opposite to it.
enum class SkyHalf { upper, lower };

/// The share of the cosine-weighted hemisphere, as occlusion() has it, in which nothing blocks a
/// ray and that lies in one half of the sky: what a half of radiance 1 gives as irradiance over pi.
/// The two halves about any `up` make occlusion()'s value; about a zero vector all is upper. Points
/// on triangles without area see half of each. `values` is as long as `points`.
void sky_light(const ShapeScene& shape, std::span<const ShapePoint> points, const Vec3d& up,
               SkyHalf half, const OcclusionOptions& options, std::span<float> values);

struct SunOptions {
    Vec3d direction{0.0, 1.0, 0.0};  ///< towards the sun, a unit vector
    double angle = 0.0;              ///< radius of its disc in radians, 0 to pi / 2
};

/// The mean over the sun's disc of the cosine to each point's shading normal, which is 0 where the
/// triangle faces away or anything lies between, however far: irradiance over pi, of a sun without
/// an angle 1 on what faces it. That takes one ray and has sharp shadows, any other takes sun_rays.
/// Points on triangles without area have no sun. `values` is as long as `points`.
void sun_light(const ShapeScene& shape, std::span<const ShapePoint> points,
               const SunOptions& options, std::span<float> values);

/// Rays per point to a sun that has an angle.
inline constexpr int sun_rays = 32;

}  // namespace burl
