#pragma once
// Ambient occlusion: how much of the sky a point sees (Zhukov, Iones, Kronin, "An Ambient Light
// Illumination Model", 1998; Landis, "Production-Ready Global Illumination", 2002), by rays.
#include <limits>
#include <span>

#include "atlas/shape/shape_scene.h"

namespace burl {

struct OcclusionOptions {
    /// Rays per point. The RMS error falls about as rays^-0.75; 128 keep it below 0.01.
    int rays = 128;
    /// Length of the rays in mesh units: what lies farther off does not block.
    double distance = std::numeric_limits<double>::infinity();
};

/// The share of the cosine-weighted hemisphere about each point's shading normal, less what lies
/// below its triangle, in which nothing blocks a ray: 1 is open, 0 closed. `values` is as long as
/// `points`. Rays start ray_offset off the triangle's plane, so that walls nearer to one another
/// than that are one. Points on triangles without area are open.
void occlusion(const ShapeScene& shape, std::span<const ShapePoint> points,
               const OcclusionOptions& options, std::span<float> values);

}  // namespace burl
