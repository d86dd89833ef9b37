#pragma once
// Masks that a point of a mesh has by itself: where it faces, how high it lies, which piece it is
// on, and what the file says there.
#include <span>
#include <vector>

#include "atlas/shape/shape_scene.h"

namespace burl {

/// The cosine between each point's shading normal and `direction`, a unit vector: in [-1, 1].
void facing(std::span<const ShapePoint> points, const Vec3d& direction, std::span<float> values);

/// The gradients of facing(), along the triangles and per mesh unit: those of normals interpolated
/// between corners and made as long as 1. 0 where the shading normal is the triangle's.
void facing_slopes(const ShapeScene& shape, std::span<const ShapePoint> points,
                   const Vec3d& direction, std::span<Vec3d> slopes);

/// How high each point lies in the mesh's bounding box along an axis (0 to 2 for x to z): 0 on its
/// low side, 1 on its high side, 0.5 where the box has no height.
void height_in_box(std::span<const ShapePoint> points, const Box3& box, int axis,
                   std::span<float> values);

/// The gradient of height_in_box(), which is the same everywhere; 0 where the box has no height.
Vec3d height_slope(const Box3& box, int axis);

/// The kind of a mesh's pieces: triangles that hang together across shared points, or parts of the
/// file.
enum class PieceKind { connected, part };

/// A random number in [0, 1) for each triangle, the same on all of a piece; a function of `seed`
/// and the piece's number: that of its first point, or of the part.
std::vector<float> piece_values(const Mesh& mesh, PieceKind kind, std::uint64_t seed);

/// The file's colours (linear RGBA) at each point, interpolated between its triangle's corners;
/// white where the mesh has none.
void vertex_color(const Mesh& mesh, const ShapeScene& shape, std::span<const ShapePoint> points,
                  std::span<Vec4f> values);

/// The file's texture coordinates at each point, as vertex_color(); 0 where the mesh has none.
void vertex_uv(const Mesh& mesh, const ShapeScene& shape, std::span<const ShapePoint> points,
               std::span<Vec2d> values);

/// The gradients of a component of vertex_color(), along the triangles and per mesh unit.
void vertex_color_slopes(const Mesh& mesh, const ShapeScene& shape, int component,
                         std::span<const ShapePoint> points, std::span<Vec3d> slopes);

/// The gradients of a component of vertex_uv(), along the triangles and per mesh unit.
void vertex_uv_slopes(const Mesh& mesh, const ShapeScene& shape, int component,
                      std::span<const ShapePoint> points, std::span<Vec3d> slopes);

}  // namespace burl
