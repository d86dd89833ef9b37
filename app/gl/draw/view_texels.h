#pragma once
// Which texels of a texture, and of which MIP levels, a picture looks up: the marking half of
// virtual texturing's feedback (Barrett, "Sparse Virtual Textures", 2008). With the slack that
// OpenGL takes, whatever it may read with a weight above 0 is marked, so that a picture of a
// texture that holds nothing else has the same bits.
#include <functional>
#include <optional>
#include <vector>

#include "app/scene/scene.h"
#include "atlas/base/image.h"
#include "atlas/solid/texel_set.h"

namespace burl {

/// What a sample of a picture looks up: texture coordinates u, v; the square of the longer side of
/// its footprint in texels of level 0; and its triangle's number, counted from 1 over the scene's
/// surfaces, 0 where it does not see the texture.
using LookupSample = Vec4f;

/// How a square texture of a scene is looked up.
struct TextureLookup {
    std::uint32_t size = 0;  ///< texels a side
    TextureFilter filter = TextureFilter::linear;
    TextureWrap wrap_u = TextureWrap::repeat, wrap_v = TextureWrap::repeat;
    /// Per triangle of the scene the block that lookups are clamped to (Surface::blocks); empty:
    /// none are. With blocks the filter is `mip`.
    std::vector<Vec4f> blocks{};
};

/// The filter texture `number` of the scene is drawn with: the one asked for, else its own. One in
/// blocks is minified whatever the file asks of other viewers.
TextureFilter drawn_filter(const Scene& scene, int number, std::optional<TextureFilter> filter);

/// `size` is that of the texture, whatever the scene holds. Throws Error(unsupported) for blocks of
/// 2^24 triangles or more.
TextureLookup lookup_of(const Scene& scene, int number, std::optional<TextureFilter> filter,
                        std::uint32_t size);

struct ViewTexels {
    explicit ViewTexels(std::uint32_t size);

    /// Per level from 0 on, the last 1 x 1 texel, those that lookups read.
    std::vector<TexelSet> levels;

    /// Per level the texels that must be worked out where those of level l are means of samples of
    /// level source(l), which is at most l and may be l itself.
    std::vector<TexelSet> beneath(const std::function<std::uint32_t(std::uint32_t)>& source) const;
    /// Pairs of a 32 x 32 tile and a level with texels that are read.
    std::uint64_t count_tiles() const;
    ViewTexels& operator|=(const ViewTexels& other);
};

/// How far OpenGL's lookups may be from those of exact arithmetic.
struct LookupSlack {
    double coordinate = 0.0;  ///< texels of the level that is read
    double level = 0.0;       ///< by which the level may be another, either way
};
inline constexpr LookupSlack no_slack{};

/// What no OpenGL exceeds: coordinates are counted in 1/256 of a texel, or finer, and floats add
/// less; the level is chosen by our shader (mesh.frag) and only rounded, to 1/256 at worst.
inline constexpr LookupSlack most_slack{1.0 / 32, 1.0 / 64};

/// Adds what `samples` look up, all threads at work; the result does not depend on their number.
/// Texels that would weigh nothing are not read.
void add_lookups(const Image<LookupSample>& samples, const TextureLookup& lookup,
                 ViewTexels& texels, const LookupSlack& slack = most_slack);

}  // namespace burl
