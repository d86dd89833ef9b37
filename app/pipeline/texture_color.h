#pragma once
// The recipe's texture as functions of a point: unfiltered, which in float64 is the reference of
// pictures and measures; or filtered over the footprint of a picture's sample, by a bake's filters
// (docs/reference/filtering.md).
#include <functional>
#include <string>

#include "app/recipe/recipe.h"
#include "procedural/batch/texel_batch.h"

namespace burl {

/// Throws Error(unsupported) where the graph at `path` of a recipe reads a mask of the mesh's shape
/// (procedural/graph/masks.h), for it has no values at points. The functions below do so, too.
void check_points(const TextureGraph& graph, const std::string& path);

/// Function that gives linear light multiplied by alpha, and alpha, at texture coordinates s. The
/// footprint is the change of s to the neighbouring samples. May be called from several threads at
/// once.
using FilteredColor = std::function<Vec4d(const Vec3d& s, const Footprint& footprint)>;

/// The texture filtered by `kind`, which must not be `supersample`. With `none` footprints are
/// ignored, and the 1999 model is evaluated in the recipe's precision, else float64. A filter of a
/// recipe in fixed point takes differences of f over the footprint for its slopes. Throws
/// Error(usage) for a graph in fixed point.
FilteredColor filtered_color(const Recipe& recipe, FilterKind kind);

/// The colour that pictures show: that of filtered_color() times the recipe's opacity, and what
/// `material.alpha` makes of it. A mask is there whole or not at all, and what is `opaque` shows
/// black where it is transparent. Throws as filtered_color() does.
FilteredColor shown_color(const Recipe& recipe, FilterKind kind);

/// A colour with alpha as pictures show it, as FilteredColor has it, where the opacity is this.
Vec4d shown_color(const Material& material, const Vec4d& color, double opacity);

/// The filter's width instead of the colour (Hart et al. 1999, figure 9c): a grey whose sRGB code
/// is w - 1 where the footprint covers w entries of a colour table of 256; w is clamped to [1,
/// 256]. Throws Error(usage) for a recipe whose texture is a graph, which has no single colour map.
FilteredColor filter_width_grey(const Recipe& recipe);

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
