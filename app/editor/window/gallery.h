#pragma once
// The presets' thumbnails as OpenGL textures, uploaded as they become ready.
#include <imgui.h>

#include <functional>
#include <map>
#include <string>
#include <utility>

#include "app/editor/jobs/thumbnails.h"
#include "app/gl/device/objects.h"

namespace burl {

/// Thumbnails of the presets. All functions are called by the user interface's thread.
class GlEditGallery {
  public:
    /// `wake` is called by another thread whenever a thumbnail is ready.
    GlEditGallery(const GladGLContext& gl, std::function<void()> wake);

    /// The thumbnail of a preset, side x side pixels, drawn in the background when first asked for
    /// (app/editor/jobs/thumbnails.h); null: not ready. The OpenGL context must be current.
    ImTextureID picture(const std::string& preset, int side);

    /// While held, no thumbnail is begun.
    void hold(bool held) { thumbnails_.hold(held); }
    bool idle() const { return thumbnails_.idle(); }
    void wait() const { thumbnails_.wait(); }

  private:
    const GladGLContext* gl_;
    std::map<std::pair<std::string, int>, GlTexture> textures_;
    EditThumbnails thumbnails_;
};

}  // namespace burl
