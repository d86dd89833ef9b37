#pragma once
// A G-buffer of the object, kept while the view stays: every pixel's texture coordinates, MIP level
// and light, which in an environment is linear in the texture's colour. While a slider moves, a
// frame then costs a texture lookup per pixel, and no triangle is drawn (deferred shading: Deering
// et al., "The Triangle Processor and Normal Vector Shader", 1988).
#include <memory>
#include <optional>
#include <span>

#include "app/gl/device/target.h"
#include "app/scene/camera.h"

namespace burl {

class GlScene;
struct DrawPart;
struct GlShading;

/// A colour target with a depth buffer.
class GlDepthTarget {
  public:
    GlDepthTarget(const GladGLContext& gl, const PictureSize& size, GLenum format,
                  GLenum depth_format = GL_DEPTH_COMPONENT24);
    /// Shares the depth buffer of another target of the same size.
    GlDepthTarget(const GladGLContext& gl, const GlDepthTarget& other,
                  std::span<const GLenum> formats);

    GlTarget colors;

  private:
    std::shared_ptr<const GlRenderbuffer> depth_;
};

/// The G-buffer and its shading pass; the OpenGL context must be current in every call.
class GlEditPlaces {
  public:
    explicit GlEditPlaces(const GladGLContext& gl);

    /// Makes an empty G-buffer for the shading, and leaves it bound. The depth buffer of `target`
    /// is shared, cleared, and says from then on which pixels show a surface.
    void begin(const GlDepthTarget& target, const GlShading& shading);
    /// Renders the G-buffer of a scene that has_places(), or a part of it, into that of begin().
    void find(const GlScene& scene, const Camera& camera, const GlShading& shading,
              const DrawPart& part) const;
    /// Shades the G-buffer into the target of begin(), whose depth must be unchanged: the pixels
    /// are those of GlScene::draw_encoded for a scene with this texture, bit-identical under the
    /// headlight.
    void draw(const GlTexture& texture, const GlDepthTarget& target,
              const GlShading& shading) const;

  private:
    const GladGLContext* gl_;
    GlProgram color_, developed_;  ///< under the headlight, and in an environment's light
    GlFullScreen pass_;
    std::optional<GlDepthTarget> places_;
};

}  // namespace burl
