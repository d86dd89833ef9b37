#pragma once
// UDIM tiles: one bake that writes an image for each tile that a mesh's texture coordinates lie in.
#include <span>
#include <string>
#include <vector>

#include "app/bake/bake.h"

namespace burl {

/// The plan with one output for each of the mesh's UDIM tiles, "a.1002.png" for "a.png", of the
/// recipe `recipe`. All tiles are laid out once before any is written. Throws Error where the mesh
/// has no texture coordinates, or a tile is refused (atlas/uv/layout.h).
BakePlan plan_of_tiles(Pipeline& pipeline, const BakePlan& plan, const Recipe& recipe);

/// Cuts the image and the pictures of a texture, with their levels, to the atlas's columns and rows
/// where these are not its whole square. Level l has its share, columns / 2^l by rows / 2^l, which
/// must be whole.
void cut_to_extent(const AtlasOptions& atlas, BakedImage& image, ExportOptions& options);

/// One sentence on why a texture that is not square cannot be had in this file, or with so many
/// levels; empty where it can.
std::string why_not_this_extent(const AtlasOptions& atlas, const BakePlan& plan);

}  // namespace burl
