#pragma once
// The baked texture in OpenGL, in storage that is reused: a new texture of the same size is a copy
// of its MIP levels.
#include <vector>

#include "app/editor/jobs/levels.h"
#include "app/gl/device/objects.h"

namespace burl {

/// Writes into an OpenGL texture; the OpenGL context must be current in every call.
class GlEditTexture {
  public:
    /// `texture` is owned by the caller.
    GlEditTexture(const GladGLContext& gl, GLuint texture) : gl_(&gl), texture_(texture) {}

    /// Uploads MIP levels and sets trilinear filtering, clamped to the edges. Where only level 0 is
    /// given, OpenGL generates the others. Throws Error(unsupported) where the texture is larger
    /// than this OpenGL supports.
    void show(const std::vector<Image<Rgba8>>& levels);

  private:
    void make_storage(const std::vector<Image<Rgba8>>& levels);

    const GladGLContext* gl_;
    GLuint texture_;
    std::size_t width_ = 0, height_ = 0, count_ = 0;  ///< size of level 0, and number of levels
};

}  // namespace burl
