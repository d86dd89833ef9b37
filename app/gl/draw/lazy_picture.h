#pragma once
// `burl render --lazy`: a recipe on a mesh as a picture without a baked texture. A first pass finds
// what the picture looks up, the host works out that, and the second pass draws (virtual
// texturing's loop, with nothing left to guess: both passes are of one picture).
#include <optional>

#include "app/gl/device/context.h"
#include "app/gl/draw/render.h"
#include "app/gl/draw/view_texture.h"
#include "app/pipeline/pipeline.h"
#include "atlas/read/pose.h"

namespace burl {

struct LazyOptions {
    PictureOptions picture{};
    std::optional<TextureFilter> filter{};  ///< instead of the one a bake asks for
    LevelRule rule{.direct = true};         ///< of the bake's --levels
    HostWay way{};
    double crease_degrees = 40.0;
    const MeshPose* pose = nullptr;  ///< of the pipeline's mesh; null: none
    std::uint32_t cell = view_cell;
    Skips skips{};  ///< without Skip::unseen_tiles the whole atlas is worked out
};

struct LazyPicture {
    Image<Rgb8> picture;
    ViewWork work{};
    double seconds_finding = 0.0;    ///< what the view looks up
    double seconds_synthesis = 0.0;  ///< of the texels
    double seconds_drawing = 0.0;
};

/// The picture of the pipeline's recipe as baked into a .glb, with all MIP levels where they are
/// looked up, by the same rule, bit for bit. The context becomes current. Throws Error as
/// render_scene does.
LazyPicture render_lazily(GlContext& context, Pipeline& pipeline, const View& view,
                          const LazyOptions& options);

}  // namespace burl
