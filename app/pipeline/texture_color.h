#pragma once
// The recipe's texture as functions of a point, unfiltered; in float64 they are the reference of
// pictures and measures.
#include <functional>

#include "app/recipe/recipe.h"

namespace burl {

/// Function that gives the colour, in linear light, at texture coordinates s. May be called from
/// several threads at once.
using TextureColor = std::function<Vec3d(const Vec3d& s)>;

/// The recipe's colour in `precision`, float64 by default; the recipe's own precision is ignored.
/// For a graph, fixed point means float64.
TextureColor texture_color(const Recipe& recipe, const Precision& precision = {});

/// Function that gives the shading normal at a point with a unit normal, both of the mesh at rest
/// and in its own coordinates. May be called from several threads at once.
using SurfaceNormal = std::function<Vec3d(const Vec3d& mesh_point, const Vec3d& normal)>;

/// The normals with the recipe's bumps; an empty function if the recipe has none.
SurfaceNormal bumped_normals(const Recipe& recipe, const Mesh& mesh);

}  // namespace burl
