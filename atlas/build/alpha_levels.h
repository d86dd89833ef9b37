#pragma once
// MIP levels of a masked texture, of which viewers show the texels whose opacity is at least a
// cutoff: opacities are scaled so that every level shows as much of the surface as level 0 does
// (Castano, "Computing Alpha Mipmaps", 2010). Blended textures need only means of premultiplied
// texels, block_levels() of RgbaF.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/build/mesh_atlas.h"

namespace burl {

/// Levels 1 to `levels` (at most down to 1 x 1) of a premultiplied texture of the atlas's size, of
/// which texels with a >= cutoff are shown: means as of block_levels(), with opacities times a
/// factor, at most 1, and colours that stay what they are when divided by opacity. The factor is
/// the one whose shown share of the surface is nearest to level 0's, over blocks of a patch atlas
/// that have 1024 texels and more in a level without mixtures of blocks, over all smaller blocks
/// together, else over the whole level. So shares differ by half a texel's share of the region,
/// unless texels have equal opacities. A cutoff that is not in (0, 1] leaves the means.
std::vector<Image<RgbaF>> masked_levels(const MeshAtlas& atlas, const Image<RgbaF>& image,
                                        float cutoff, std::uint32_t levels);

/// Turns the means of a premultiplied texture, its levels 1, 2, ..., into those of masked_levels();
/// `opacities` are those of its level 0.
void scale_masks(const MeshAtlas& atlas, const Image<float>& opacities, float cutoff,
                 std::span<Image<RgbaF>> levels);

}  // namespace burl
