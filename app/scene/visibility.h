#pragma once
// The triangle visible at each sample of a picture, in float64: homogeneous edge functions (Olano &
// Greer, "Triangle Scan Conversion using 2D Homogeneous Coordinates", 1997), which need no clipping
// and give perspective-correct barycentrics directly. Two triangles that share an edge evaluate
// exactly opposite edge functions, so that no sample between them is lost or drawn twice.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "app/scene/camera.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// A triangle in one placement on the sample grid. Sample (i,j) lies at (i+0.5, j+0.5), y down.
struct ScreenTriangle {
    /// The edge functions: edges[k] . (x,y,1) is barycentric k over w, times a positive constant;
    /// >= 0 inside.
    std::array<Vec3d, 3> edges;
    Vec3d inverse_depth;  ///< inverse_depth . (x,y,1) = far distance / depth along the view axis
    std::uint32_t triangle = 0;                          ///< an index into Mesh::triangles
    const Mat4d* placement = nullptr;                    ///< an element of Part::instances
    int x_begin = 0, x_end = 0, y_begin = 0, y_end = 0;  ///< the box of samples that it may cover
};

/// All triangles in all placements that may be visible, in drawing order. Triangles that are
/// edge-on, behind the near plane or outside the picture are left out. The result points into
/// `mesh`.
std::vector<ScreenTriangle> screen_triangles(const Mesh& mesh, const Camera& camera,
                                             const PictureSize& samples);

/// The index of samples where no triangle is visible.
inline constexpr std::uint32_t nothing_visible = 0xffffffffu;

/// The frontmost triangle of every sample in rows [first_row, first_row + rows): indices into
/// `triangles`, or nothing_visible; the earlier of two equally far ones wins. `candidates` are the
/// ascending indices of the triangles that may reach these rows. Points nearer than the near plane
/// are not visible.
std::vector<std::uint32_t> visible_triangles(std::span<const ScreenTriangle> triangles,
                                             std::span<const std::uint32_t> candidates,
                                             const Camera& camera, int width, int first_row,
                                             int rows);

/// The next triangle behind each of `front`, which holds visible triangles, or such as lie behind
/// others, of the same rows: the frontmost of those that are farther away or, equally far, come
/// later. There is nothing behind nothing_visible.
std::vector<std::uint32_t> triangles_behind(std::span<const std::uint32_t> front,
                                            std::span<const ScreenTriangle> triangles,
                                            std::span<const std::uint32_t> candidates,
                                            const Camera& camera, int width, int first_row,
                                            int rows);

/// The perspective-correct barycentric coordinates (sum 1) of sample (x, y) in a triangle that
/// covers it.
Vec3d barycentrics(const ScreenTriangle& triangle, int x, int y);

/// The derivatives of the barycentric coordinates per sample, to the right (x) and downwards (y);
/// `at` are the barycentrics of sample (x, y).
std::array<Vec3d, 2> barycentric_steps(const ScreenTriangle& triangle, int x, int y,
                                       const Vec3d& at);

/// The distance of sample (x, y) along the view axis, in scene units.
double depth_of(const ScreenTriangle& triangle, const Camera& camera, int x, int y);

}  // namespace burl
