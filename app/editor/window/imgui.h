#pragma once
// A renderer of Dear ImGui's draw lists. The packaged backend loads OpenGL by itself, which fails
// under OSMesa; this one draws the same pixels in windows and in headless runs.
#include <imgui.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "app/editor/panels/changes.h"
#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "atlas/base/image.h"

namespace burl {

/// Returns the identifier of a texture for ImGui.
inline ImTextureID imgui_texture(const GlTexture& texture) {
    return reinterpret_cast<ImTextureID>(std::uintptr_t(texture.get()));
}

/// Uploads MIP levels as a texture of this internal format, with trilinear filtering, clamped to
/// the edges.
GlTexture upload_levels(const GladGLContext& gl, const std::vector<Image<Rgb8>>& levels,
                        GLenum format);

/// A rectangle of whole pixels on the screen, row 0 on top; `high` is exclusive.
struct PixelRect {
    glm::ivec2 low{0}, high{0};
    bool empty() const { return low.x >= high.x || low.y >= high.y; }
};

/// Draws a user interface. The OpenGL context must be current in every call.
class GlImGui {
  public:
    /// Uploads the fonts of ImGui's current context, which must be complete, and tells it that draw
    /// lists may have vertex offsets.
    explicit GlImGui(const GladGLContext& gl);

    /// Uploads the fonts again after ImGui's current context got other ones.
    void upload_fonts();
    /// Draws the lists over the bound framebuffer, whose row 0 is the lowest. Textures are sampled
    /// by their own parameters. Throws Error(runtime) when OpenGL fails.
    void draw(const ImDrawData& data) const;
    /// An opaque image on the screen: alpha is 1 everywhere, row 0 is on top.
    struct OpaqueImage {
        const GlTarget* target = nullptr;
        bool still = false;  ///< whether its texels are unchanged since the last call
    };
    /// Redraws only the dirty rectangles over `background`; the bound framebuffer must hold what
    /// the last call drew. A rectangle that shows any texture is dirty, except the fonts, an
    /// `image` that is still, and textures of which `lasts` says that their texels never change.
    void update(
        const ImDrawData& data, const Vec3f& background, const OpaqueImage& image,
        const std::function<bool(ImTextureID)>& lasts = [](ImTextureID) { return false; });

  private:
    void draw_within(const ImDrawData& data, const glm::ivec2& pixels, const ScreenRect& part,
                     const ImDrawCmd* after = nullptr) const;
    const ImDrawCmd* copy(const ImDrawData& data, const glm::ivec2& pixels, const ScreenRect& part,
                          const GlTarget& image) const;
    void set_state(const ImDrawData& data, const glm::ivec2& pixels) const;
    bool scissor(const PixelRect& part, const glm::ivec2& pixels) const;
    void draw(const ImDrawCmd& command) const;

    const GladGLContext* gl_;
    GlProgram program_;
    GlVertexArray vertex_array_;
    GlBuffer vertices_, indices_;
    GlTexture fonts_;
    ScreenChanges changes_;
};

}  // namespace burl
