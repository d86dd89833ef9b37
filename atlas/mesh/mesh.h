#pragma once
// The triangle mesh every stage starts from: welded points, triangles in file order, and everything
// else per corner, so that an STL (no shared vertices) and its OBJ (shared ones) are the same mesh
// to the atlas.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "atlas/base/named_files.h"
#include "atlas/base/vec.h"

namespace burl {

/// The points of a triangle's three corners, in order.
using Triangle = std::array<std::uint32_t, 3>;

/// Attributes of triangle corners; each vector is empty or has 3 * triangle count entries, corner k
/// of triangle t at 3t+k.
struct CornerAttributes {
    std::vector<Vec3f> normals;                        ///< unit vectors in the space of `positions`
    std::vector<Vec4f> colors;                         ///< linear RGBA, 1 is full scale
    std::vector<Vec2d> uvs;                            ///< texture coordinates; row 0 has v = 0
    std::vector<std::array<std::uint16_t, 4>> joints;  ///< joint indices into the source's skin
    std::vector<Vec4f> weights;                        ///< weights of `joints`, sum 1
};

/// A run of consecutive triangles that is drawn as one object, with its instances.
struct Part {
    std::string name;
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_count = 0;
    /// Transforms of the instances relative to `positions`, which are those of the first instance:
    /// element 0 is the identity.
    std::vector<Mat4d> instances{Mat4d(1.0)};
};

/// Repairs and omissions of a mesh's reading, which the programs print, and counts of what the file
/// holds besides.
struct MeshNotes {
    std::uint64_t polygons = 0;              ///< faces with more than three corners, triangulated
    std::uint64_t degenerate_triangles = 0;  ///< triangles with a repeated point or zero area
    std::uint64_t duplicate_triangles = 0;   ///< triangles on the same points as an earlier one
    std::uint64_t unreferenced_points = 0;   ///< points that no triangle uses, left out
    std::uint64_t merged_points = 0;         ///< file vertices that coincide with an earlier one
    /// Points, lines and curves that the format may carry beside faces.
    std::uint64_t ignored_elements = 0;
    std::uint64_t unchosen_triangles = 0;  ///< triangles that ReadOptions::choice leaves out
    /// Names of materials and groups of an OBJ, which a mesh does not hold.
    std::uint64_t materials = 0, groups = 0;
    std::vector<std::string> sentences;  ///< further notes, each a line on stderr
};

/// A triangle mesh with everything that its file says of corners and parts.
struct Mesh {
    std::string name;                 ///< file name without folder and extension
    std::vector<Vec3d> positions;     ///< distinct points, numbered by first use in `triangles`
    std::vector<Triangle> triangles;  ///< triangles in file order; every face is kept
    /// The number, from 0, of each triangle's face in the file.
    std::vector<std::uint32_t> source_faces;
    CornerAttributes corners;
    std::vector<Part> parts;  ///< parts that cover all triangles in order; at least one
    MeshNotes notes;
};

/// An axis-aligned bounding box (AABB).
struct Box3 {
    Vec3d low{0.0}, high{0.0};
    Vec3d centre() const { return 0.5 * low + 0.5 * high; }
    Vec3d size() const { return high - low; }
    double longest_side() const;
};

/// The bounding box of all points; the zero box for an empty mesh.
Box3 bounding_box(const Mesh& mesh);

/// Area of triangle t, in squared mesh units.
double triangle_area(const Mesh& mesh, std::size_t t);

/// Longest edge of triangle t, in mesh units.
double longest_edge(const Mesh& mesh, std::size_t t);

/// The primitives of a glTF that are read, by globs (atlas/base/glob.h) over names; an empty list
/// takes all. What has no name is called "mesh 0", "node 0", "material 0" by its number, and the
/// material of a primitive without one "no material".
struct GltfChoice {
    std::vector<std::string> meshes, materials;
    std::vector<std::string> nodes;  ///< nodes, each with all nodes below it
    /// Mesh and primitive of the only primitives that are read, ascending; empty: all that the
    /// globs choose.
    std::vector<std::array<int, 2>> only;

    bool any() const {
        return !meshes.empty() || !materials.empty() || !nodes.empty() || !only.empty();
    }
    bool operator==(const GltfChoice&) const = default;
};

/// A user's choices of how a file becomes a mesh.
struct ReadOptions {
    /// Welding distance as a share of the box's longest side: closer points are welded; 0 welds
    /// points with the same bits (-0 counts as 0).
    double weld = 0.0;
    /// Whether each glTF instance gets triangles of its own, in scene space, instead of sharing
    /// those of the first instance.
    bool unshare_instances = false;
    /// The N of the glTF attribute TEXCOORD_N that texture coordinates are read from.
    std::uint32_t uv_set = 0;
    GltfChoice choice{};
    /// Where files may lie that the mesh's file names.
    NamedFiles named = NamedFiles::below;
    /// The most triangles that a mesh may have, those of instances that share none included.
    std::uint64_t most_triangles = std::uint64_t(1) << 27U;
};

}  // namespace burl
