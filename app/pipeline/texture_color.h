#pragma once
// The recipe's texture as functions of a point, unfiltered: in float64 what pictures and measures
// hold bakes against.
#include <functional>

#include "app/recipe/recipe.h"

namespace burl {

/// Linear-light colour at texture coordinates s. May be called from several threads at once.
using TextureColor = std::function<Vec3d(const Vec3d& s)>;

/// In float64, whatever the recipe says, or another precision; graphs have no fixed point.
TextureColor texture_color(const Recipe& recipe, const Precision& precision = {});

/// The normal to shade with at a point with a unit normal, both of the mesh at rest, in its own
/// coordinates. May be called from several threads at once.
using SurfaceNormal = std::function<Vec3d(const Vec3d& mesh_point, const Vec3d& normal)>;

/// Normals with the recipe's bumps; empty without any.
SurfaceNormal bumped_normals(const Recipe& recipe, const Mesh& mesh);

}  // namespace burl
