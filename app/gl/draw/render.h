#pragma once
// Draws a scene with OpenGL to an 8-bit picture (docs/reference/rendering.md): what a viewer would
// show of a baked file, under one defined light and with the texture filter asked for.
#include <optional>

#include "app/gl/device/context.h"
#include "app/gl/draw/scene.h"
#include "app/gl/draw/view_texels.h"
#include "app/scene/camera.h"
#include "app/scene/scene.h"
#include "app/scene/shading.h"
#include "atlas/base/image.h"

namespace burl {

/// `filter` replaces the one each texture asks for. The context becomes current. Throws Error:
/// unsupported when a texture is larger than the context allows, runtime when OpenGL fails.
Image<Rgb8> render_scene(GlContext& context, const Scene& scene, const Camera& camera,
                         const PictureOptions& options,
                         std::optional<TextureFilter> filter = std::nullopt);

/// The same of a scene that is on the GPU already; `context` is the one it was made in.
Image<Rgb8> render_scene(GlContext& context, const GlScene& scene, const Camera& camera,
                         const PictureOptions& options);

/// The texels of texture `number` that such a picture looks up: hidden ones, those that look away
/// and those outside the picture come by drawing it. `lookup` is that of lookup_of().
ViewTexels view_texels(GlContext& context, const GlScene& scene, const Camera& camera,
                       const PictureOptions& options, int number, const TextureLookup& lookup,
                       const LookupSlack& slack = most_slack);

}  // namespace burl
