#pragma once
// Synthesis of single texels, wherever they lie in the atlas: for those that another way of
// synthesis left undecided.
#include <span>

#include "atlas/solid/solid_atlas.h"
#include "procedural/color/table.h"
#include "procedural/model/texture.h"

namespace burl {

/// Sets the pixels `texels` (column, row) of the image to those of synthesize_rgb8 with
/// Kernel::direct and no filter. `maps` are the atlas's maps in the texture's space (moved_maps),
/// `table` is that of the texture's colours.
void synthesize_sparse(const SolidAtlas& solid, std::span<const TexelMap> maps,
                       const Texture& texture, const ColorTable8& table,
                       std::span<const glm::uvec2> texels, Image<Rgb8>& image);

}  // namespace burl
