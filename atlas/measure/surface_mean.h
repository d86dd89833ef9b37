#pragma once
// Textures filtered on the surface itself: the mean of a solid function with a Gaussian around a
// point. MIP levels are measured against it.
#include <functional>
#include <span>
#include <vector>

#include "atlas/measure/surface_points.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// A part of a triangle, for quadrature: a point in it, and its area.
struct SurfaceSample {
    Vec3d point{0.0};
    double area = 0.0;
    std::uint32_t triangle = 0;
};

/// Samples of parts at most `edge` > 0 long, as surface_means() cuts them, in the order of the
/// triangles; only samples whose point `wanted` accepts are returned. Triangles longer than edge /
/// 2 are cut at least once, so that two seeds differ.
std::vector<SurfaceSample> sample_surface(const Mesh& mesh, double edge, std::uint64_t seed,
                                          const std::function<bool(const Vec3d&)>& wanted);

/// A texture: linear colour at a solid point. A grey texture has three equal channels.
using SolidColor = std::function<Vec3d(const Vec3d&)>;

/// The grey texture of a function of a point.
template <class Value>
SolidColor grey(Value value) {
    return [value](const Vec3d& point) { return Vec3d(value(point)); };
}

/// Mean over the channels of the squares of a difference of colours, the norm of all errors. For
/// greys it is the square of the one channel's difference.
inline double mean_square(const Vec3d& difference) {
    return glm::dot(difference, difference) / 3.0;
}

/// Radius of the kernel in sigmas.
inline constexpr double gaussian_cut = 2.6;

/// Footprints `stretch` >= 1 times as long as wide. `across` holds the unit direction at each point
/// in which the footprint stays narrow; it is empty without a stretch.
struct Elongation {
    double stretch = 1.0;
    std::span<const Vec3d> across{};
};

/// The mean of f over the surface around each point, with weight exp(-r^2 / 2 sigma^2), r the
/// straight distance, within 2.6 sigma, leaving out triangles that face away from the point's own
/// (normals at 90 degrees or more). Quadrature: triangles are bisected at their longest edge, near
/// its middle at random after `seed`, into parts of at most 1.5 sigma and at most the larger of
/// `detail` and sigma / 4, each one sample at its centroid; slivers whose area is below 1/20 of the
/// square of that length stay whole with a random point. Where that takes more than 2^24 parts
/// they become larger. Two seeds give independent errors. The mesh's coordinates are of the order
/// of 1; f has no detail finer than about `detail`.
///
/// With an elongation r^2 = v^2 + (d^2 - v^2) / stretch^2, d the straight distance and v its part
/// along `across`: the footprint of a pixel that looks along the surface. The length sigma / 4 is
/// then multiplied by sqrt(stretch).
std::vector<Vec3d> surface_means(const Mesh& mesh, const SolidColor& f,
                                 std::span<const SurfacePoint> points, double sigma, double detail,
                                 std::uint64_t seed, const Elongation& elongation = {});

/// About the number of calls of f by surface_means() at `points` points, with footprints `stretch`
/// times as long as wide: rather more than fewer.
double surface_mean_calls(const Mesh& mesh, std::size_t points, double sigma, double detail,
                          double stretch = 1.0);

}  // namespace burl
