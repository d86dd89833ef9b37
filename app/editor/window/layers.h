#pragma once
// Surfaces that blend in the editor's view at rest, by layers from the front, so that no order of
// triangles matters. A view that moves, or that the processor draws, has two layers: back faces and
// front faces.
#include <optional>

#include "app/editor/window/places.h"
#include "app/gl/draw/scene.h"

namespace burl {

/// Layers of what blends; the OpenGL context must be current in every call.
class GlEditLayers {
  public:
    explicit GlEditLayers(const GladGLContext& gl);

    /// Draws the layers of a scene that has_layers() over what is opaque, which has been drawn into
    /// the target; its colours are premultiplied. What lies behind the nearest 12 is left out.
    void draw(const GlScene& scene, const Camera& camera, const GlShading& shading,
              const GlDepthTarget& target);

  private:
    void add(const GlTexture& colors, const GlTarget& sum, GLenum sum_share, GLenum color_share);
    bool draw_layer(const GlScene& scene, const Camera& camera, const GlShading& shading,
                    const GlLayerDepths& depths);

    const GladGLContext* gl_;
    GlProgram copy_;
    GlFullScreen pass_;
    std::optional<GlDepthTarget> layer_;
    std::optional<GlTarget> sum_;
};

}  // namespace burl
