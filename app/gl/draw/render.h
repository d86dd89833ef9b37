#pragma once
// Drawing a scene with OpenGL to an 8-bit picture (docs/reference/rendering.md): the picture that a
// viewer would show of a baked file, under one defined light and with a given texture filter.
#include <optional>

#include "app/gl/device/context.h"
#include "app/gl/draw/scene.h"
#include "app/gl/draw/surroundings.h"
#include "app/gl/draw/view_texels.h"
#include "app/scene/camera.h"
#include "app/scene/scene.h"
#include "app/scene/shading.h"
#include "atlas/base/image.h"

namespace burl {

/// Draws the scene, with its surroundings; `filter` replaces the filter of all textures. Alpha of a
/// transparent background is lost. Makes the context current. Throws Error: unsupported where a
/// texture is larger than the context allows, runtime when OpenGL fails.
Image<Rgb8> render_scene(GlContext& context, const Scene& scene, const Camera& camera,
                         const PictureOptions& options,
                         std::optional<TextureFilter> filter = std::nullopt);

/// Draws a scene that has been uploaded in `context`, which becomes current, as `around`, which was
/// made with the same options, lights it. Throws Error(runtime) when OpenGL fails.
Image<Rgba8> render_picture(GlContext& context, const GlScene& scene, const GlSurroundings& around,
                            const Camera& camera, const PictureOptions& options);

/// The texels of texture `number` that the picture looks up. The lookups are drawn, so that
/// clipping and the depth test exclude surfaces that the picture does not show. `lookup` is the
/// result of lookup_of().
ViewTexels view_texels(GlContext& context, const GlScene& scene, const Camera& camera,
                       const PictureOptions& options, int number, const TextureLookup& lookup,
                       const LookupSlack& slack = most_slack);

}  // namespace burl
