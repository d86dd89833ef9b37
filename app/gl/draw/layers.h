#pragma once
// Depths between which surfaces that blend are drawn, layer by layer from the front (Everitt,
// "Interactive Order-Independent Transparency", 2001), so that no order of triangles matters.
#include "app/gl/device/objects.h"

namespace burl {

/// The depths of a tile of samples: that of the layer drawn last, and that of what is opaque. The
/// context must be current wherever an object is created or used.
class GlLayerDepths {
  public:
    /// The texture units that bind() occupies.
    static constexpr int nearer_unit = 2, farther_unit = 3;

    /// Makes depths of no layer; those of the bound framebuffer are of what is opaque. Throws
    /// Error(runtime) when OpenGL fails.
    GlLayerDepths(const GladGLContext& gl, int width, int height);

    /// Takes the depths of the bound framebuffer for those of the layer drawn last. They are 1, the
    /// farthest, where nothing was drawn, and nothing lies behind.
    void take_layer();
    /// Binds both to their units.
    void bind() const;

  private:
    void take(const GlTexture& depths) const;

    const GladGLContext& gl_;
    int width_, height_;
    GlTexture nearer_, farther_;
};

}  // namespace burl
