#pragma once
// A G-buffer of the object, kept while the view stays: every pixel's texture coordinates, MIP level
// and light. While a slider moves, a frame then costs a texture lookup per pixel, and no triangle
// is drawn (deferred shading: Deering et al., "The Triangle Processor and Normal Vector Shader",
// 1988).
#include <memory>
#include <optional>

#include "app/gl/device/target.h"
#include "app/scene/camera.h"

namespace burl {

class GlScene;
struct DrawPart;

/// A colour target with a depth buffer.
class GlDepthTarget {
  public:
    GlDepthTarget(const GladGLContext& gl, const PictureSize& size, GLenum format,
                  GLenum depth_format = GL_DEPTH_COMPONENT24);
    /// Shares the depth buffer of another target of the same size.
    GlDepthTarget(const GladGLContext& gl, const GlDepthTarget& other, GLenum format);

    GlTarget colors;

  private:
    std::shared_ptr<const GlRenderbuffer> depth_;
};

/// The G-buffer and its shading pass; the OpenGL context must be current in every call.
class GlEditPlaces {
  public:
    explicit GlEditPlaces(const GladGLContext& gl);

    /// Renders the G-buffer of a scene that has_places(), or a part of it, which needs all before.
    /// The depth buffer of `target` is shared, and says from then on which pixels show a surface.
    void find(const GlScene& scene, const Camera& camera, const GlDepthTarget& target, bool lit,
              const DrawPart& part);
    /// Shades the G-buffer into the target of the last find(), whose depth must be unchanged: the
    /// pixels are bit-identical to those of GlScene::draw_encoded for a scene with this texture.
    void draw(const GlTexture& texture, const GlDepthTarget& target) const;

  private:
    const GladGLContext* gl_;
    GlProgram color_;
    GlFullScreen pass_;
    std::optional<GlDepthTarget> places_;
};

}  // namespace burl
