#pragma once
// The same surface in another shape: where a second file, or a pose of the mesh's own file, has the
// corners of its triangles. A solid texture is made for the mesh at rest and sticks to
// whatever the surface becomes (Carr and Hart, "Real-Time Procedural Solid Texturing", 2001).
//
// Triangles correspond corner by corner, in the order of the file. Points of a file that coincide
// at rest are welded to one point of the mesh; where the pose takes them apart (lips that open),
// the posed mesh has a point for each again. One point of the mesh's file is one point of the pose.
#include <span>
#include <string>
#include <vector>

#include "atlas/file/file_buffer.h"
#include "atlas/mesh/mesh.h"
#include "atlas/mesh/read_options.h"

namespace burl {

struct MeshPose {
    std::string name;              ///< the file's without folder and extension, or the pose's own
    std::vector<Vec3d> positions;  ///< per triangle corner (3t+k) of the mesh
    /// Per triangle corner, of any length, zero where the pose says none; or empty.
    std::vector<Vec3f> normals{};
};

/// What poses the file brings itself (atlas/gltf/pose.h); none of other formats than glTF. Throws
/// Error as read_mesh does.
std::vector<std::string> pose_names(const FileBuffer& mesh);

/// The pose of the mesh that read_mesh makes of `mesh` with the same options; `posed` is a mesh
/// file with the same faces. Throws Error: as read_mesh does, invalid_file where the faces are
/// others.
MeshPose read_pose(const FileBuffer& mesh, const FileBuffer& posed,
                   const ReadOptions& options = {});

/// The same from the mesh's own file: a morph target, a moment of an animation ("walk@0.5"), or the
/// skeleton as the nodes stand ("nodes"). Throws Error: as read_mesh does, usage where there is no
/// such pose.
MeshPose read_own_pose(const FileBuffer& mesh, const std::string& name,
                       const ReadOptions& options = {});

/// Throws Error(runtime) where the pose is of a mesh with more or fewer triangles: a file has
/// changed between.
void check_pose(const MeshPose& pose, const Mesh& mesh);

/// The mesh's points as far as the pose leaves them together.
struct PosedPoints {
    std::vector<Triangle> triangles;  ///< the mesh's, numbered anew where points part
    /// Per point the mesh's point that it is: 0, 1, 2, ... as far as the mesh has points, then the
    /// further ones of those that part.
    std::vector<std::uint32_t> rest;
    std::vector<Vec3d> positions;  ///< per point, in the pose
};
/// Throws Error as check_pose does.
PosedPoints posed_points(const Mesh& mesh, const MeshPose& pose);

/// The mesh on its way to the pose: a share `weight` (0: at rest, 1: posed) of the straight line of
/// each point. Triangles, parts and corners' attributes are the mesh's, but for normals: it has
/// none.
Mesh posed_mesh(const Mesh& mesh, const MeshPose& pose, double weight);

}  // namespace burl
