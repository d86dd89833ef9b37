#pragma once
// MIP levels of a normal map together with its roughness map: normals that differ within a texel
// make it rougher, which the shortened length of their mean measures (Toksvig, "Mipmapping Normal
// Maps", 2005). Derivation and errors: docs/reference/materials-levels.md.
#include <cstdint>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"
#include "atlas/build/mesh_atlas.h"

namespace burl {

/// One level of a normal map with its roughness map.
struct NormalLevel {
    Image<RgbF> normals;     ///< unit vectors in tangent space, components -1..1
    Image<float> roughness;  ///< perceptual roughness, 0..1
};

/// Levels 1 to `levels` (at most down to 1 x 1) of a normal map and a roughness map of the atlas's
/// size. Normals are vectors in tangent space of any length above 0 (0 counts as (0, 0, 1));
/// roughness is perceptual, 0..1: GGX with alpha = roughness^2, as in glTF 2.0. A texel has the
/// direction of the mean of level 0's unit normals, with the blocks and weights of block_levels(),
/// and with r <= 1, the length of that mean, and m, the mean roughness, the roughness
/// (m^4 + 2 (1 - r) / r)^(1/4), at most 1. Equal normals leave m as it is up to 1e-6 in alpha^2.
std::vector<NormalLevel> normal_levels(const MeshAtlas& atlas, const Image<RgbF>& normals,
                                       const Image<float>& roughness, std::uint32_t levels);

/// The numbers of texels whose means make levels: x, y and 1 - z of the unit normal, and the
/// roughness. The images may be rows of larger ones.
Image<Vec4f> normal_moments(const Image<RgbF>& normals, const Image<float>& roughness);

/// The level that has these means.
NormalLevel normal_level(const Image<Vec4f>& moments);

}  // namespace burl
