#pragma once
// Additions to bakes of a mesh's own texture coordinates: an image for each UDIM tile, and textures
// that are not square.
#include <span>
#include <string>
#include <vector>

#include "app/bake/bake.h"
#include "app/bake/options.h"

namespace burl {

/// The plan with one output for each of the mesh's UDIM tiles, "a.1002.png" for "a.png", of the
/// recipe `recipe`. All tiles are laid out once before any is written; the plan's notes count the
/// overlaps of all. Throws Error where the mesh has no texture coordinates, or a tile is refused
/// (atlas/uv/layout.h).
BakePlan plan_of_tiles(Pipeline& pipeline, const BakePlan& plan, const Recipe& recipe);

/// Cuts the image and the pictures of a texture, with their levels, to the atlas's columns and rows
/// where these are not its whole square. Level l has its share, columns / 2^l by rows / 2^l, which
/// must be whole.
void cut_to_extent(const AtlasOptions& atlas, BakedImage& image, ExportOptions& options);

/// Throws Error(usage) for options of texture coordinates that do not fit the rest of the command:
/// tiles, sets and sizes that are not square; `kept` says whether a glTF goes back into its
/// document.
void check_uvs(const BakeCommand& command, const Recipe& recipe, const BakePlan& plan, bool kept);

}  // namespace burl
