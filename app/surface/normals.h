#pragma once
// Shading normals for meshes that bring none: angle-weighted (Thuermer & Wuethrich, "Computing
// Vertex Normals from Polygonal Facets", 1998), split at creases.
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// v at unit length, or zero where v is zero or not finite. It is scaled first: squares of tiny
/// numbers vanish.
Vec3d unit_or_zero(const Vec3d& v);

/// Between two unit vectors, in radians; 0 where one is zero.
double angle_between(const Vec3d& u, const Vec3d& v);

/// One unit normal per triangle corner (3t+k). The mesh's own normals where it has them; zero or
/// non-finite ones among them, and all of a mesh without any, are computed: around each point,
/// faces that follow one another across edges whose dihedral angle is below `crease_degrees` share
/// one normal, the mean of their face normals weighted by the angle each face has at the point. So
/// shading is continuous across every edge that is not a crease. Degenerate faces weigh nothing,
/// do not break the smoothing of the faces beside them and take over a neighbour's normal; +Z where
/// there is none.
std::vector<Vec3f> corner_normals(const Mesh& mesh, double crease_degrees);

}  // namespace burl
