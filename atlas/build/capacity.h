#pragma once
// The capacity of a texture for a mesh, decided before anything is laid out (Carr & Hart 2001,
// section 4.3, on textures too small for a mesh). With fewer texels an atlas degrades in this
// order: gutters are halved, slivers are paired that were better alone, pairs get one texel each,
// and pairs share texels. Only strips have a size below which they do not hold a mesh at all.
#include <string>

#include "atlas/solid/atlas.h"

namespace burl {

/// Texels per triangle, T: from `good_texels_per_triangle` on triangles are sampled well, below
/// `poor_texels_per_triangle` a colour per vertex shows as much.
inline constexpr double good_texels_per_triangle = 25.0, poor_texels_per_triangle = 5.0;
/// Texels per shell (connected component) below which gutters leave a patch too few inner texels.
inline constexpr double least_texels_per_shell = 256.0;

/// Figures of how well a texture of `columns` x `rows` texels holds a mesh of `triangles`
/// triangles.
struct Capacity {
    std::uint64_t triangles = 0;
    std::uint32_t columns = 0, rows = 0;
    double texels_per_triangle = 0.0;  ///< T = columns * rows / triangles
    /// Smallest sides of square textures with T >= good and T >= poor, respectively (powers of two
    /// for quad); 0 where no texture is large enough.
    std::uint32_t good_size = 0, least_size = 0;
    /// Smallest size at which no two triangles have to share a texel; 0 where no texture is large
    /// enough.
    std::uint32_t holding_size = 0;

    bool suffices() const { return texels_per_triangle >= good_texels_per_triangle; }
    bool vertex_colours_better() const { return texels_per_triangle < poor_texels_per_triangle; }
};

/// The capacity of a texture of the options' columns and rows for so many triangles.
Capacity capacity(std::uint64_t triangles, const AtlasOptions& options);

/// One sentence on the number of texels and the size that would suffice; empty where the texels
/// suffice.
std::string shortage(const Capacity& capacity);

/// One clause on why patches, or charts, are not worth trying: the mesh is mostly loose pieces,
/// each of which would get a block of its own. Empty where they are worth trying.
std::string why_no_patches(const Connectivity& connectivity, const AtlasOptions& options);

}  // namespace burl
