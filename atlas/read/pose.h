#pragma once
// Poses of a mesh: places of its triangles' corners after a second file, or after a pose of the
// mesh's own file. A solid texture is made for the mesh at rest and sticks to whatever the surface
// becomes (Carr and Hart, "Real-Time Procedural Solid Texturing", 2001).
//
// Triangles correspond corner by corner, in the order of the file. Points of a file that coincide
// at rest are welded to one point of the mesh; where the pose takes them apart (lips that open),
// the posed mesh has a point for each again. One point of the mesh's file is one point of the pose.
#include <span>
#include <string>
#include <vector>

#include "atlas/file/file_buffer.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// The places of a mesh's triangle corners in a pose.
struct MeshPose {
    std::string name;              ///< the pose's own, or its file's without folder and extension
    std::vector<Vec3d> positions;  ///< places of the mesh's triangle corners (3t+k)
    /// Normals of the triangle corners, of any length, zero where the pose says none; or empty.
    std::vector<Vec3f> normals{};
};

/// Names of the poses that the file holds itself (atlas/gltf/pose.h); none for formats other than
/// glTF. Throws Error as read_mesh() does.
std::vector<std::string> pose_names(const FileBuffer& mesh);

/// The pose of the mesh that read_mesh() makes of `mesh` with the same options; `posed` is a mesh
/// file with the same faces. Throws Error as read_mesh() does, and Error(invalid_file) where the
/// faces differ.
MeshPose read_pose(const FileBuffer& mesh, const FileBuffer& posed,
                   const ReadOptions& options = {});

/// A pose that the mesh's own file holds: a morph target, a moment of an animation ("walk@0.5"), or
/// the skeleton as the nodes stand ("nodes"). Throws Error as read_mesh() does, and Error(usage)
/// where there is no such pose.
MeshPose read_own_pose(const FileBuffer& mesh, const std::string& name,
                       const ReadOptions& options = {});

/// Throws Error(runtime) where pose and mesh differ in their number of triangles, as they do when a
/// file has changed between their reading.
void check_pose(const MeshPose& pose, const Mesh& mesh);

/// A posed mesh's points: a mesh point stays one point if all its corners are in one place of the
/// pose, and is split into several otherwise.
struct PosedPoints {
    std::vector<Triangle> triangles;  ///< mesh's triangles, renumbered where points are split
    /// The mesh point that each point comes from: 0, 1, 2, ... for as many points as the mesh has,
    /// then the mesh points of the further points that splits made.
    std::vector<std::uint32_t> rest;
    std::vector<Vec3d> positions;  ///< places of the points in the pose
};
/// Points and triangles of the mesh in the pose. Throws Error as check_pose() does.
PosedPoints posed_points(const Mesh& mesh, const MeshPose& pose);

/// The mesh on its way to the pose: each point moved by the share `weight` (0: at rest, 1: posed)
/// along the straight line from its place at rest to its posed place. Triangles, parts and the
/// corners' attributes are those of posed_points() and the mesh; it has no normals.
Mesh posed_mesh(const Mesh& mesh, const MeshPose& pose, double weight);

}  // namespace burl
