#pragma once
// Normals and tangents of a mesh in a pose. Which corners share a vertex is decided at rest, so
// that a surface has the same vertices on its whole way to the pose, and an engine can move them.
#include <span>
#include <vector>

#include "atlas/read/pose.h"

namespace burl {

/// Per triangle corner but for the points.
struct PosedCorners {
    PosedPoints points;
    std::vector<Vec3f> normals;   ///< unit length
    std::vector<Vec4f> tangents;  ///< of app/surface/tangents.h, or empty
};

/// `normals` are those at rest (app/surface/normals.h). Corners that share their point and their
/// normal at rest share one in the pose: the mean of the pose's own where it has any there, else
/// that at rest turned as the mean of the faces about it turns, each weighted by its angle at the
/// point. With texture coordinates per corner there are tangents, too.
PosedCorners posed_corners(const Mesh& mesh, const MeshPose& pose, std::span<const Vec3f> normals,
                           std::span<const Vec2d> uvs = {});

/// On the way between two vectors per corner, 0 being the first; unit length.
std::vector<Vec3f> blended_normals(std::span<const Vec3f> rest, std::span<const Vec3f> posed,
                                   double weight);

}  // namespace burl
