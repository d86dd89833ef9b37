#pragma once
// What lies around the object of pictures: the light, what is behind, and the shadow on the ground.
// One is made for all pictures of a scene.
#include <memory>
#include <optional>

#include "app/gl/draw/light.h"
#include "app/gl/draw/scene.h"
#include "app/scene/ground.h"
#include "app/scene/scene.h"
#include "app/scene/shading.h"

namespace burl {

/// The shadow on the ground below a scene.
class GlGround {
  public:
    /// Throws Error(runtime) when OpenGL fails.
    GlGround(const GladGLContext& gl, const Ground& ground);

    /// Draws the shadow over a tile of the bound framebuffer, as far as the eye is above the
    /// ground. Alpha becomes the share that all drawn so far hides.
    void draw(const Camera& camera, const PictureSize& samples, const SampleTile& tile) const;

  private:
    const GladGLContext& gl_;
    Vec3d corner_;
    double side_;
    GlTexture shadow_;
    GlProgram program_;
    GlVertexArray vertices_;
};

/// Light, background and ground of a scene's pictures. The context must be current wherever an
/// object is created, used or destroyed.
class GlSurroundings {
  public:
    /// Makes what `options` ask for; `light`, where there is one, is taken for their light. Throws
    /// Error: as load_environment does, unsupported for an environment beyond this OpenGL, runtime
    /// when OpenGL fails.
    GlSurroundings(const GladGLContext& gl, const Scene& scene, const PictureOptions& options,
                   std::shared_ptr<const GlLight> light = nullptr);

    /// Clears the bound framebuffer and draws all that lies behind the scene. Alpha is the share
    /// that it hides of a background that is not light.
    void draw(const Camera& camera, const PictureSize& samples, const SampleTile& tile) const;
    GlShading shading() const { return {lit_, light_.get()}; }
    /// The light, for other surroundings of the same; null: the headlight.
    const std::shared_ptr<const GlLight>& light() const { return light_; }

  private:
    const GladGLContext& gl_;
    bool lit_;
    Vec4f clear_;
    std::shared_ptr<const GlLight> light_;
    std::optional<GlBackdrop> backdrop_;
    std::optional<GlGround> ground_;
};

}  // namespace burl
