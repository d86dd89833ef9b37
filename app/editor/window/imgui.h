#pragma once
// Draws Dear ImGui's lists with our own OpenGL layer, because the packaged backend loads OpenGL by
// itself and cannot under OSMesa: so windows and headless runs draw the same pixels.
#include <imgui.h>

#include <cstdint>

#include "app/editor/panels/changes.h"
#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"

namespace burl {

/// A texture as ImGui names it.
inline ImTextureID imgui_texture(const GlTexture& texture) {
    return reinterpret_cast<ImTextureID>(std::uintptr_t(texture.get()));
}

/// Of the screen, row 0 the highest.
struct PixelRect {
    glm::ivec2 low{0}, high{0};
    bool empty() const { return low.x >= high.x || low.y >= high.y; }
};

class GlImGui {
  public:
    /// Takes the fonts of ImGui's current context, which must be complete; tells it that large
    /// lists may be drawn. The OpenGL context must be current, here and in every call.
    explicit GlImGui(const GladGLContext& gl);

    /// The fonts of ImGui's current context are other ones now.
    void upload_fonts();
    /// Into the bound framebuffer, over its whole area, whose row 0 is the picture's lowest.
    /// Textures are sampled as their parameters say. Throws Error(runtime) when OpenGL fails.
    void draw(const ImDrawData& data) const;
    /// A target whose alpha is 1 everywhere; its row 0 is the picture's top row.
    struct OpaqueImage {
        const GlTarget* target = nullptr;
        bool still = false;  ///< it has the texels that it had at the last call
    };
    /// The same over `background`, in a framebuffer that holds what the last call drew: only what
    /// changed. Textures besides the fonts count as changed but for `image` that is still.
    void update(const ImDrawData& data, const Vec3f& background, const OpaqueImage& image);

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
