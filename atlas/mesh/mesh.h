#pragma once
// The triangle mesh every stage starts from: welded points, triangles in file order, and everything
// else per corner, so that an STL (no shared vertices) and its OBJ (shared ones) are the same mesh
// to the atlas.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

using Triangle = std::array<std::uint32_t, 3>;

/// Attributes per triangle corner; each vector is empty or has 3 * triangle count entries (corner
/// 3t+k).
struct CornerAttributes {
    std::vector<Vec3f> normals;                        ///< unit length, in the space of `positions`
    std::vector<Vec4f> colors;                         ///< linear RGBA
    std::vector<Vec2d> uvs;                            ///< v = 0 at image row 0 (glTF)
    std::vector<std::array<std::uint16_t, 4>> joints;  ///< indices into the source's skin
    std::vector<Vec4f> weights;                        ///< skin weights, sum 1
};

/// A run of triangles that is drawn as one object, with the places it stands in.
struct Part {
    std::string name;
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_count = 0;
    /// Placements relative to `positions` (which are those of the first placement: element 0 is the
    /// identity).
    std::vector<Mat4d> instances{Mat4d(1.0)};
};

/// What reading had to repair, ignore or note; every count is printed by the programs when it is
/// not zero.
struct MeshNotes {
    std::uint64_t polygons = 0;              ///< faces with more than three corners, triangulated
    std::uint64_t degenerate_triangles = 0;  ///< repeated point or zero area (relative to the box)
    std::uint64_t duplicate_triangles = 0;   ///< same three points as an earlier triangle
    std::uint64_t unreferenced_points = 0;   ///< points no triangle uses, left out
    std::uint64_t merged_points = 0;         ///< file vertices that coincide with an earlier one
    std::uint64_t ignored_elements =
        0;  ///< points, lines, curves the format may carry beside faces
    std::vector<std::string> sentences;  ///< anything else worth a line on stderr
};

struct Mesh {
    std::string name;                 ///< file name without folder and extension
    std::vector<Vec3d> positions;     ///< distinct points, numbered by first use in `triangles`
    std::vector<Triangle> triangles;  ///< file order; every face is kept
    std::vector<std::uint32_t>
        source_faces;  ///< per triangle: the face's number in the file, from 0
    CornerAttributes corners;
    std::vector<Part> parts;  ///< cover all triangles in order; at least one
    MeshNotes notes;
};

struct Box3 {
    Vec3d low{0.0}, high{0.0};
    Vec3d centre() const { return 0.5 * low + 0.5 * high; }
    Vec3d size() const { return high - low; }
    double longest_side() const;
};

/// Box of all points; the zero box for an empty mesh.
Box3 bounding_box(const Mesh& mesh);

/// Area of triangle t, in squared mesh units.
double triangle_area(const Mesh& mesh, std::size_t t);

/// Longest edge of triangle t, in mesh units.
double longest_edge(const Mesh& mesh, std::size_t t);

}  // namespace burl
