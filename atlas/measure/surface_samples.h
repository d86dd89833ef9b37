#pragma once
// Surfaces cut into small pieces for quadrature.
#include <functional>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// A piece of a triangle: a point in it, and its area.
struct SurfaceSample {
    Vec3d point{0.0};
    double area = 0.0;
    std::uint32_t triangle = 0;
};

/// Samples of pieces at most `edge` > 0 long, as surface_means() cuts them, in the order of the
/// triangles; only samples whose point `wanted` accepts are returned. Triangles longer than edge /
/// 2 are cut at least once, so that two seeds differ.
std::vector<SurfaceSample> sample_surface(const Mesh& mesh, double edge, std::uint64_t seed,
                                          const std::function<bool(const Vec3d&)>& wanted);

}  // namespace burl
