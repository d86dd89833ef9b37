#pragma once
// The texels of a texture, by MIP level, that a picture looks up: the marking half of virtual
// texturing's feedback (Barrett, "Sparse Virtual Textures", 2008). With OpenGL's tolerances as
// slack, every texel that may be read with a weight above 0 is marked, so that a picture of a
// texture with only these texels has the same bits.
#include <functional>
#include <optional>
#include <vector>

#include "app/scene/scene.h"
#include "atlas/base/image.h"
#include "atlas/solid/texel_set.h"

namespace burl {

/// The lookup of a picture's sample: texture coordinates u, v; the square of the longer side of its
/// footprint in texels of level 0; and its triangle's number, counted from 1 over the scene's
/// surfaces, 0 where it does not show the texture.
using LookupSample = Vec4f;

/// The lookup parameters of a square texture in a scene.
struct TextureLookup {
    std::uint32_t size = 0;  ///< the side in texels
    TextureFilter filter = TextureFilter::linear;
    TextureWrap wrap_u = TextureWrap::repeat, wrap_v = TextureWrap::repeat;
    /// Per triangle of the scene the block that lookups are clamped to (Surface::blocks), for the
    /// filter `mip`; empty without blocks.
    std::vector<Vec4f> blocks{};
};

/// The filter that texture `number` of the scene is drawn with: `filter`, else the texture's own; a
/// linear texture in blocks is drawn with `mip`.
TextureFilter drawn_filter(const Scene& scene, int number, std::optional<TextureFilter> filter);

/// The lookup parameters of texture `number`; `size` is the texture's side whatever the scene
/// holds. Throws Error(unsupported) for blocks of 2^24 triangles or more.
TextureLookup lookup_of(const Scene& scene, int number, std::optional<TextureFilter> filter,
                        std::uint32_t size);

/// The texels of a texture that are looked up.
struct ViewTexels {
    explicit ViewTexels(std::uint32_t size);

    /// The texels that lookups read, per level from 0 to the level of 1 x 1.
    std::vector<TexelSet> levels;

    /// The texels that must be synthesised, per level, where texels of level l are means over
    /// samples of level source(l) <= l.
    std::vector<TexelSet> beneath(const std::function<std::uint32_t(std::uint32_t)>& source) const;
    /// The number of pairs of a 32 x 32 tile and a level with texels that are read.
    std::uint64_t count_tiles() const;
    ViewTexels& operator|=(const ViewTexels& other);
};

/// The largest deviation of OpenGL's lookups from exact arithmetic.
struct LookupSlack {
    double coordinate = 0.0;  ///< the deviation of coordinates, in texels of the level read
    double level = 0.0;       ///< the deviation of the MIP level, either way
};
inline constexpr LookupSlack no_slack{};

/// Bounds for every OpenGL: coordinates are quantised to 1/256 of a texel or finer, and floats add
/// less; the level is computed by mesh.frag and only rounded, to 1/256 at worst.
inline constexpr LookupSlack most_slack{1.0 / 32, 1.0 / 64};

/// Adds the texels that `samples` look up with a weight above 0. Uses all threads; the result does
/// not depend on their number.
void add_lookups(const Image<LookupSample>& samples, const TextureLookup& lookup,
                 ViewTexels& texels, const LookupSlack& slack = most_slack);

}  // namespace burl
