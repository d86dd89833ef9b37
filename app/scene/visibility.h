#pragma once
// Which triangle a picture sample shows, in float64: homogeneous edge functions (Olano & Greer,
// "Triangle Scan Conversion using 2D Homogeneous Coordinates", 1997), which need no clipping and
// give perspective-correct barycentrics directly. Two triangles that share an edge evaluate
// exactly opposite edge functions, so that no sample between them is lost or drawn twice.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "app/scene/camera.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// A triangle of one placement on the sample grid. Sample (i,j) lies at (i+0.5, j+0.5), y down.
struct ScreenTriangle {
    /// edges[k] . (x,y,1) is barycentric k over w, times a positive constant; >= 0 inside.
    std::array<Vec3d, 3> edges;
    Vec3d inverse_depth;  ///< inverse_depth . (x,y,1) = far distance / depth along the view axis
    std::uint32_t triangle = 0;                          ///< index into Mesh::triangles
    const Mat4d* placement = nullptr;                    ///< into Part::instances
    int x_begin = 0, x_end = 0, y_begin = 0, y_end = 0;  ///< samples it may cover
};

/// All triangles of all placements that may be seen, in drawing order. Triangles that are edge-on,
/// behind the near plane or outside the picture are left out. Points into `mesh`.
std::vector<ScreenTriangle> screen_triangles(const Mesh& mesh, const Camera& camera,
                                             const PictureSize& samples);

inline constexpr std::uint32_t nothing_visible = 0xffffffffu;

/// The frontmost triangle of every sample in rows [first_row, first_row + rows): indices into
/// `triangles`, or nothing_visible; of two equally far the earlier one stays. `candidates` are the
/// indices (ascending) of those that may reach these rows; what is closer than the near plane is
/// not seen.
std::vector<std::uint32_t> visible_triangles(std::span<const ScreenTriangle> triangles,
                                             std::span<const std::uint32_t> candidates,
                                             const Camera& camera, int width, int first_row,
                                             int rows);

/// Perspective-correct barycentric coordinates (sum 1) of sample (x, y) in a triangle that covers
/// it.
Vec3d barycentrics(const ScreenTriangle& triangle, int x, int y);

/// By how much they change from one sample to the next, to first order: to the right (x) and
/// downwards (y); `at` are the barycentrics of sample (x, y).
std::array<Vec3d, 2> barycentric_steps(const ScreenTriangle& triangle, int x, int y,
                                       const Vec3d& at);

/// Distance of sample (x, y) along the view axis.
double depth_of(const ScreenTriangle& triangle, const Camera& camera, int x, int y);

}  // namespace burl
