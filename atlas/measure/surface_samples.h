#pragma once
// A surface cut into small pieces for quadrature.
#include <functional>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

struct SurfaceSample {
    Vec3d point{0.0};
    double area = 0.0;
    std::uint32_t triangle = 0;
};

/// Pieces of at most `edge` along their longest edge (surface_mean.h), those that `wanted` takes
/// only, in the order of the triangles. Triangles longer than half of it are cut at least once, so
/// that two seeds differ. `edge` > 0.
std::vector<SurfaceSample> sample_surface(const Mesh& mesh, double edge, std::uint64_t seed,
                                          const std::function<bool(const Vec3d&)>& wanted);

}  // namespace burl
