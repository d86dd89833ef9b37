#pragma once
// MIP levels (Williams, "Pyramidal Parametrics", 1983) of an atlas's texture that mix blocks as
// late and as little as the atlas allows: plain box means while every level texel lies in one
// block, and above that means of the texels that show surface, so that gutters never count twice.
#include <cstdint>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/build/mesh_atlas.h"

namespace burl {

/// The last level that is not only mixtures of unrelated triangles: for strips the level where the
/// narrowest block is two texels wide, for the other kinds the level whose
/// shorter side is 1.
std::uint32_t last_level(const MeshAtlas& atlas);

/// The last level at which no texel covers two blocks: log2 of the largest power of two that
/// divides the texture's side and, for patches with gutters of g texels, 2g (2 where g = 0), for
/// charts the side of a cell (outline_cell()), or, for quad, is at most the narrowest block's side;
/// 0 for strips and uv.
std::uint32_t last_pure_level(const MeshAtlas& atlas);

/// The last level that is worth working out from the surface instead of from finer levels
/// (app/pipeline/direct_levels.h): for patches the last level whose texels are gutter or surface
/// and not both, for charts the last pure level, else log2 of the side of a block (uv: a chart's
/// share) of mean area, beyond which the map under a texel's centre says little about all that the
/// texel covers.
std::uint32_t last_source_level(const MeshAtlas& atlas);

/// The share of each of the level's texels that shows surface, 0..1; in level 0 it is 1, or 0 in
/// gutters and between blocks.
Image<float> inner_texels(const PatchAtlas& atlas, std::uint32_t level = 0);

/// Whether level 1 is plain means of texels, and the levels above it can be made of it alone with
/// the same bytes: level 1 of a patch atlas mixes no gutter with surface, which it does where the
/// texture's side is odd.
bool halves_in_bands(const MeshAtlas& atlas);

/// Levels first + 1 to `levels` (at most down to 1 x 1) of a texture of linear values whose level
/// `first` is `image`. Level l has max(1, floor(N / 2^l)) texels a side, as in OpenGL; sums are in
/// double, texels rounded once per level. T is float (a number, such as metalness), Vec4f, RgbF
/// (linear light) or RgbaF (premultiplied, which makes these the levels of a blended texture: the
/// mean of an opaque red texel and a transparent one of any colour is red of opacity 1/2).
template <class T>
std::vector<Image<T>> block_levels(const MeshAtlas& atlas, const Image<T>& image,
                                   std::uint32_t levels, std::uint32_t first = 0);

}  // namespace burl
