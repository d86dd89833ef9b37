#pragma once
// What a texture would show if it were filtered on the surface itself: the mean of a solid function
// with a Gaussian around a point. The truth that MIP levels are measured against.
#include <functional>
#include <span>
#include <vector>

#include "atlas/surface_points.h"

namespace burl {

/// A texture: linear value at a solid point.
using SolidFunction = std::function<double(const Vec3d&)>;

/// The kernel ends here, in sigmas.
inline constexpr double gaussian_cut = 2.6;

/// Per point the mean of f over the surface with weight exp(-r^2 / 2 sigma^2), r the straight
/// distance, within 2.6 sigma, leaving out triangles that face away from the point's own (normals
/// at 90 degrees or more). Quadrature: triangles are bisected at their longest edge, near its
/// middle at random after `seed`, into pieces of at most 1.5 sigma and at most the larger of
/// `detail` and sigma / 4, each one sample at its centroid; slivers below 1/20 of the square of
/// that stay whole with a random point. Where that takes more than 2^24 pieces they become larger.
/// Two seeds give independent errors. The mesh's coordinates are of the order of 1; f has no detail
/// finer than about `detail`.
std::vector<double> surface_means(const Mesh& mesh, const SolidFunction& f,
                                  std::span<const SurfacePoint> points, double sigma, double detail,
                                  std::uint64_t seed);

}  // namespace burl
