#pragma once
// Draws a scene with OpenGL to an 8-bit picture (docs/rendering.md): what a viewer would show of a
// baked file, under one defined light and with the texture filter asked for.
#include <optional>

#include "app/camera.h"
#include "app/gl_context.h"
#include "app/scene.h"
#include "app/shading.h"
#include "atlas/image.h"

namespace burl {

/// `filter` replaces the one each texture asks for. The context becomes current. Throws Error:
/// unsupported when a texture is larger than the context allows, runtime when OpenGL fails.
Image<Rgb8> render_scene(GlContext& context, const Scene& scene, const Camera& camera,
                         const PictureOptions& options,
                         std::optional<TextureFilter> filter = std::nullopt);

}  // namespace burl
