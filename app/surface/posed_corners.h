#pragma once
// Normals and tangents of a mesh in a pose. Vertices are shared as at rest, so that a surface has
// the same vertices all the way to the pose, and engines can morph them.
#include <span>
#include <vector>

#include "atlas/read/pose.h"

namespace burl {

/// A mesh in a pose; normals and tangents are per triangle corner (3t+k).
struct PosedCorners {
    PosedPoints points;
    std::vector<Vec3f> normals;  ///< unit length
    /// Tangents of app/surface/tangents.h; empty without texture coordinates.
    std::vector<Vec4f> tangents;
};

/// The mesh in the pose; `normals` are those at rest (app/surface/normals.h). Corners that share
/// point and normal at rest share one normal in the pose: the mean of the pose file's normals where
/// it has any there, else the normal at rest turned by the rotation of the mean of the adjacent
/// face normals, each weighted by its angle at the point. Tangents are computed where `uvs` holds
/// texture coordinates per corner.
PosedCorners posed_corners(const Mesh& mesh, const MeshPose& pose, std::span<const Vec3f> normals,
                           std::span<const Vec2d> uvs = {});

/// Unit normals interpolated between those at rest (weight 0) and those in the pose (1), per
/// corner.
std::vector<Vec3f> blended_normals(std::span<const Vec3f> rest, std::span<const Vec3f> posed,
                                   double weight);

}  // namespace burl
