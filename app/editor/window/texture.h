#pragma once
// The editor's picture in OpenGL: storage that stays, so that a new picture is a copy of its
// levels.
#include <vector>

#include "app/editor/work/levels.h"
#include "app/gl/device/objects.h"

namespace burl {

class GlEditTexture {
  public:
    /// `texture` is to be written and belongs to another one.
    GlEditTexture(const GladGLContext& gl, GLuint texture) : gl_(&gl), texture_(texture) {}

    /// Looked up trilinearly, and not beyond its edges. Where there could be more levels than the
    /// one given, OpenGL makes them. Throws Error(unsupported) when it is larger than this OpenGL
    /// has.
    void show(const std::vector<Image<Rgba8>>& levels);

  private:
    void make_storage(const std::vector<Image<Rgba8>>& levels);

    const GladGLContext* gl_;
    GLuint texture_;
    std::size_t width_ = 0, height_ = 0, count_ = 0;  ///< of level 0, and of levels
};

}  // namespace burl
