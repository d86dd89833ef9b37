#pragma once
// Where the object's pixels look their texture up, kept while the view stays: a slider that moves
// then costs a lookup a pixel, and no triangle is drawn again (deferred shading: Deering et al.,
// "The Triangle Processor and Normal Vector Shader", 1988).
#include <memory>
#include <optional>

#include "app/gl/device/target.h"
#include "app/scene/camera.h"

namespace burl {

class GlScene;

/// A colour target with depth.
class GlDepthTarget {
  public:
    GlDepthTarget(const GladGLContext& gl, const PictureSize& size, GLenum format);
    /// With the depth of another one of the same size.
    GlDepthTarget(const GladGLContext& gl, const GlDepthTarget& other, GLenum format);

    GlTarget colors;

  private:
    std::shared_ptr<const GlRenderbuffer> depth_;
};

class GlEditPlaces {
  public:
    explicit GlEditPlaces(const GladGLContext& gl);

    /// Of a scene that has_places(), as it is seen in `target`, whose depth tells from then on
    /// where there is a surface.
    void find(const GlScene& scene, const Camera& camera, const GlDepthTarget& target, bool lit);
    /// Into the target of the last find(), whose depth is still the same: the pixels that
    /// GlScene::draw_encoded draws of a scene with this texture, to the bit.
    void draw(const GlTexture& texture, const GlDepthTarget& target) const;

  private:
    const GladGLContext* gl_;
    GlProgram color_;
    GlFullScreen pass_;
    std::optional<GlDepthTarget> places_;
};

}  // namespace burl
