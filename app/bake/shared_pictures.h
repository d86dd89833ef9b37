#pragma once
// Recipes that share one atlas and its pictures: each fills the texels of its own triangles, those
// of the pipeline's label with the recipe's number (Pipeline::set_labels), and no others.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/pipeline/material.h"
#include "app/pipeline/pipeline.h"

namespace burl {

/// The pictures besides the base colour and the normal map that any of the recipes has, each name
/// once.
std::vector<MaterialPicture> shared_material_pictures(std::span<const Recipe> recipes,
                                                      Packing packing, bool rough_levels);

/// Whether the base colour of any of the recipes may be transparent.
bool any_transparent(std::span<const Recipe> recipes);

/// The cutoff of the masks among the recipes; none where there are none.
std::optional<double> mask_cutoff(std::span<const Recipe> recipes);

/// Level 0 of the base colour, with paint, and of each of the `wanted`, those of
/// shared_material_pictures. Texels of a recipe that has no such picture hold no meaning, and its
/// material must not show it. One recipe is the pipeline's and fills the whole atlas; with several
/// the pipeline has the first when this returns. Defined for Rgba8, Rgba16 and RgbaF.
template <class Pixel>
std::vector<Image<Pixel>> shared_pictures(Pipeline& pipeline, std::span<const Recipe> recipes,
                                          const std::vector<MaterialPicture>& wanted,
                                          Packing packing, bool rough_levels);

/// Gives the pictures of shared_pictures() to `take` in bands of `rows` rows from the top down.
/// Masks of all recipes are in memory together. Throws Error(runtime) where the pipeline is
/// stopped.
template <class Pixel>
void shared_pictures_in_bands(Pipeline& pipeline, std::span<const Recipe> recipes,
                              const std::vector<MaterialPicture>& wanted, Packing packing,
                              bool rough_levels, std::size_t rows, const TakePictures<Pixel>& take);

/// Gives the normal map of shared_normals() in floats to `take` in bands of `rows` rows; that of
/// several recipes is whole in memory.
void shared_normals_in_bands(Pipeline& pipeline, std::span<const Recipe> recipes,
                             double crease_degrees, bool tangent_space, std::size_t rows,
                             const TakeNormals& take);

/// The normal map of Pipeline::normal_map, (0, 0, 1) at texels of recipes without bumps; recipes
/// as in shared_pictures, of which one must have bumps.
template <class Pixel>
Image<Pixel> shared_normals(Pipeline& pipeline, std::span<const Recipe> recipes,
                            double crease_degrees, bool tangent_space);

/// Throws Error(usage) in one sentence that begins with `where` if the recipes cannot share an
/// atlas with MIP levels: masks of different cutoffs, or a mask beside what is blended.
void check_shared_levels(std::span<const Recipe> recipes, const std::string& where);

}  // namespace burl
