#pragma once
// Masks that a point of a mesh has by itself: where it faces, how high it lies, which piece it is
// on, and what the file says there.
#include <span>
#include <vector>

#include "atlas/shape/shape_scene.h"

namespace burl {

/// The cosine between each point's shading normal and `direction`, a unit vector: in [-1, 1].
void facing(std::span<const ShapePoint> points, const Vec3d& direction, std::span<float> values);

/// How high each point lies in the mesh's bounding box along an axis (0 to 2 for x to z): 0 on its
/// low side, 1 on its high side, 0.5 where the box has no height.
void height_in_box(std::span<const ShapePoint> points, const Box3& box, int axis,
                   std::span<float> values);

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

}  // namespace burl
