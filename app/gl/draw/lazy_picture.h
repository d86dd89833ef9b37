#pragma once
// `burl render --lazy`: a picture of a recipe on a mesh without a baked texture, by virtual
// texturing. A feedback pass finds the texels that the picture looks up, the host synthesises them,
// and a second pass draws. Both passes are of the same picture, so no texel is missing.
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/gl/device/context.h"
#include "app/gl/draw/render.h"
#include "app/gl/draw/view_texels.h"
#include "app/pipeline/direct_levels.h"
#include "app/pipeline/fill_texture.h"
#include "app/pipeline/pipeline.h"
#include "app/scene/scene.h"
#include "atlas/read/pose.h"

namespace burl {

/// Counts of texels in spans, over level 0 and, where levels are direct, over the levels that have
/// samples of their own.
struct ViewWork {
    std::uint64_t tiles = 0;         ///< pairs of a 32 x 32 tile and a level that are looked up
    std::uint64_t texels_read = 0;   ///< texels looked up, or averaged into such texels
    std::uint64_t texels_made = 0;   ///< texels synthesised: whole cells of those read
    std::uint64_t texels_whole = 0;  ///< texels of level 0 of the whole atlas
    SynthesisWork synthesis{};       ///< the synthesis of colours
};

/// The side in texels of the cells that texels are synthesised in. Cells of one texel take no
/// longer than larger ones with more texels in them (docs/lab/benchmarks.md).
inline constexpr std::uint32_t view_cell = 1;

/// The recipe's atlas, and the rule by which its texture's levels are computed.
struct ViewSource {
    const MeshAtlas& layout;
    const SolidAtlas& solid;
    const Recipe& recipe;
    LevelRule rule{};
    MaskSource masks{};  ///< of whole levels of the atlas; none: the recipe reads no masks

    /// The masks that the base colour reads over a whole level.
    MaskImages color_masks(const SolidAtlas& level) const;
    /// The level whose samples the texels of `level` are means of. Levels that a bake does not
    /// write are averaged by OpenGL, from level 0.
    std::uint32_t source(std::uint32_t level) const;
    /// The spans of a level of the atlas.
    SolidAtlas level(std::uint32_t number) const;
};

/// Per level the texels that are synthesised for a view (ViewTexels::beneath), with the rest of
/// their cells.
std::vector<TexelSet> view_part(const ViewSource& source, const ViewTexels& view,
                                std::uint32_t cell);
/// Per level the texels that are synthesised for the whole atlas.
std::vector<TexelSet> whole_part(const ViewSource& source);
/// The number of texels of `part` in spans.
std::uint64_t count_texels(const ViewSource& source, const std::vector<TexelSet>& part);

/// The colours of a baked scene as `burl bake` writes them, and where `filter` is `mip` their
/// levels as `burl bake --levels all` writes them. Texels outside `part`, and texels of other
/// levels outside `view`, are unspecified; levels that the view does not read may be missing.
SceneTexture view_texture(const ViewSource& source, const std::vector<TexelSet>& part,
                          const ViewTexels& view, TextureFilter filter, const HostWay& way,
                          const Economy& economy = {});

/// Options of render_lazily().
struct LazyOptions {
    PictureOptions picture{};
    std::optional<TextureFilter> filter{};  ///< replaces the filter of the baked texture
    LevelRule rule{.direct = true};         ///< the rule of MIP levels, as --levels of a bake
    HostWay way{};
    double crease_degrees = 40.0;
    const MeshPose* pose = nullptr;  ///< a pose of the pipeline's mesh; null: none
    std::uint32_t cell = view_cell;
    /// The light of `picture`, where it has been made for another picture; null: it is made.
    std::shared_ptr<const GlLight> light{};
    Skips skips{};  ///< Skip::unseen_tiles forbidden: the whole atlas is synthesised
};

/// A picture with alpha, with the work and the seconds that it took.
struct LazyPicture {
    Image<Rgba8> picture;
    ViewWork work{};
    double seconds_finding = 0.0;    ///< seconds to find the texels looked up
    double seconds_synthesis = 0.0;  ///< seconds to synthesise the texels
    double seconds_drawing = 0.0;
};

/// Draws the pipeline's recipe as if it had been baked into a .glb, bit for bit: with all MIP
/// levels where they are looked up, by the same rule, or, where the material varies in more than
/// colour, with no levels but those that OpenGL averages. Makes the context current. Throws Error
/// as render_scene does, and usage for paint over what is transparent.
LazyPicture render_lazily(GlContext& context, Pipeline& pipeline, const View& view,
                          const LazyOptions& options);

}  // namespace burl
