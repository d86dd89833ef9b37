#pragma once
// `burl render --lazy`: a picture of a recipe on a mesh without a baked texture, by virtual
// texturing. A feedback pass finds the texels that the picture looks up, the host synthesises them,
// and a second pass draws. Both passes are of the same picture, so no texel is missing.
#include <optional>

#include "app/gl/device/context.h"
#include "app/gl/draw/render.h"
#include "app/gl/draw/view_texture.h"
#include "app/pipeline/pipeline.h"
#include "atlas/read/pose.h"

namespace burl {

/// Options of render_lazily().
struct LazyOptions {
    PictureOptions picture{};
    std::optional<TextureFilter> filter{};  ///< replaces the filter of the baked texture
    LevelRule rule{.direct = true};         ///< the rule of MIP levels, as --levels of a bake
    HostWay way{};
    double crease_degrees = 40.0;
    const MeshPose* pose = nullptr;  ///< a pose of the pipeline's mesh; null: none
    std::uint32_t cell = view_cell;
    Skips skips{};  ///< Skip::unseen_tiles forbidden: the whole atlas is synthesised
};

/// A picture, with the work and the seconds that it took.
struct LazyPicture {
    Image<Rgb8> picture;
    ViewWork work{};
    double seconds_finding = 0.0;    ///< seconds to find the texels looked up
    double seconds_synthesis = 0.0;  ///< seconds to synthesise the texels
    double seconds_drawing = 0.0;
};

/// Draws the pipeline's recipe as if it had been baked into a .glb, with all MIP levels where they
/// are looked up, by the same rule, bit for bit. Makes the context current. Throws Error as
/// render_scene does.
LazyPicture render_lazily(GlContext& context, Pipeline& pipeline, const View& view,
                          const LazyOptions& options);

}  // namespace burl
