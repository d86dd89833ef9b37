#pragma once
// Single texels of a texture, wherever they lie in the atlas: for what another way of synthesis
// left open.
#include <span>

#include "atlas/solid/solid_atlas.h"
#include "procedural/color/table.h"
#include "procedural/model/texture.h"

namespace burl {

/// Sets texels of the image, columns and rows, to what synthesize_rgb8 gives with Kernel::direct
/// and no filter. `maps` are the atlas's in the texture's space (moved_maps), `table` that of the
/// texture's colours.
void synthesize_sparse(const SolidAtlas& solid, std::span<const TexelMap> maps,
                       const Texture& texture, const ColorTable8& table,
                       std::span<const glm::uvec2> texels, Image<Rgb8>& image);

}  // namespace burl
