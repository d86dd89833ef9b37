#pragma once
// Shading normals for meshes that bring none: angle-weighted (Thuermer & Wuethrich, "Computing
// Vertex Normals from Polygonal Facets", 1998), split at creases.
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// The vector at unit length, or zero where it is zero or not finite. It is scaled first, since
/// squares of tiny numbers underflow.
Vec3d unit_or_zero(const Vec3d& v);

/// The angle between two unit vectors, in radians; 0 where one is zero.
double angle_between(const Vec3d& u, const Vec3d& v);

/// One unit normal per triangle corner (3t+k): the mesh's own where it has them. Zero or non-finite
/// ones, and all normals of a mesh without any, are computed: around each point, faces connected
/// across edges whose dihedral angle is below `crease_degrees` share one normal, the mean of their
/// face normals weighted by the angle each face has at the point. So shading is continuous across
/// every edge that is not a crease. Degenerate faces have no weight, do not interrupt the smoothing
/// of the faces beside them and take a neighbour's normal, or +Z where there is none.
std::vector<Vec3f> corner_normals(const Mesh& mesh, double crease_degrees);

}  // namespace burl
