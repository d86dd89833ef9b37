#pragma once
// The presets' pictures as textures of OpenGL, uploaded as they become ready.
#include <imgui.h>

#include <functional>
#include <map>
#include <string>
#include <utility>

#include "app/editor/work/thumbnails.h"
#include "app/gl/device/objects.h"

namespace burl {

class GlEditGallery {
  public:
    /// `wake` is called by another thread whenever a picture is ready.
    GlEditGallery(const GladGLContext& gl, std::function<void()> wake);

    /// A preset's ball, side x side pixels, asked for where need be (edit_thumbnails.h); null: not
    /// yet. The context must be current.
    ImTextureID picture(const std::string& preset, int side);

    /// While held, no picture is begun.
    void hold(bool held) { thumbnails_.hold(held); }
    bool idle() const { return thumbnails_.idle(); }
    void wait() const { thumbnails_.wait(); }

  private:
    const GladGLContext* gl_;
    std::map<std::pair<std::string, int>, GlTexture> textures_;
    EditThumbnails thumbnails_;
};

}  // namespace burl
