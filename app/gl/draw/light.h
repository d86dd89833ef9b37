#pragma once
// An environment in OpenGL: as light for shaders/draw/light.glsl, and as what lies behind a scene.
#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "app/gl/draw/surface.h"
#include "app/light/environment.h"
#include "app/light/prefilter.h"

namespace burl {

/// Prefiltered light of an environment. The context must be current wherever an object is created,
/// used or destroyed.
class GlLight {
  public:
    /// The texture units that use() occupies.
    static constexpr int table_unit = 4, glossy_unit = 5;

    /// Throws Error(runtime) when OpenGL fails.
    GlLight(const GladGLContext& gl, const PrefilteredLight& light);

    /// Binds the light to the program in use, which follows draw/light.glsl.
    void use(const GlProgram& program) const;
    bool has_sun() const { return sun_.shines(); }

  private:
    const GladGLContext& gl_;
    Sun sun_;
    GlTexture glossy_, table_;
    std::array<Vec3f, 9> diffuse_;
    int last_level_;
};

/// An environment behind the scene.
class GlBackdrop {
  public:
    /// Throws Error: unsupported where the environment is larger than this OpenGL allows, runtime
    /// when OpenGL fails.
    GlBackdrop(const GladGLContext& gl, const Environment& environment);

    /// Fills the bound framebuffer with a tile of the picture, with alpha 1; depth stays.
    void draw(const Camera& camera, const PictureSize& samples, const SampleTile& tile) const;

  private:
    const GladGLContext& gl_;
    GlTexture environment_;
    GlProgram program_;
    GlFullScreen pass_;
};

}  // namespace burl
