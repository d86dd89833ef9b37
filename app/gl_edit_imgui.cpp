#include "app/gl_edit_imgui.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace burl {

namespace {

const void* offset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

glm::ivec2 pixel_size(const ImDrawData& data) {
    return {int(std::lround(data.DisplaySize.x * data.FramebufferScale.x)),
            int(std::lround(data.DisplaySize.y * data.FramebufferScale.y))};
}

ScreenRect whole(const ImDrawData& data) {
    const ImVec2 &low = data.DisplayPos, &size = data.DisplaySize;
    return {low, {low.x + size.x, low.y + size.y}};
}

}  // namespace

GlImGui::GlImGui(const GladGLContext& gl)
    : gl_(&gl), program_(gl, "imgui.vert", "imgui.frag"), vertex_array_(make_vertex_array(gl)) {
    gl.BindVertexArray(vertex_array_.get());
    vertices_ = make_buffer(gl);
    indices_ = make_buffer(gl);
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.get());
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
    const GLsizei stride = sizeof(ImDrawVert);
    for (GLuint index = 0; index < 3; ++index) gl.EnableVertexAttribArray(index);
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(ImDrawVert, pos)));
    gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(ImDrawVert, uv)));
    gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                           offset(offsetof(ImDrawVert, col)));
    upload_fonts();
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    check_gl(gl, "preparing the user interface");
}

void GlImGui::upload_fonts() {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    unsigned char* texels = nullptr;
    int width = 0, height = 0;
    fonts.GetTexDataAsRGBA32(&texels, &width, &height);
    fonts_ = make_texture(*gl_);
    gl_->BindTexture(GL_TEXTURE_2D, fonts_.get());
    gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    texels);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    fonts.SetTexID(imgui_texture(fonts_));
    changes_ = {};
}

void GlImGui::set_state(const ImDrawData& data, const glm::ivec2& pixels) const {
    gl_->Viewport(0, 0, pixels.x, pixels.y);
    gl_->Disable(GL_DEPTH_TEST);
    gl_->Disable(GL_CULL_FACE);
    gl_->Enable(GL_SCISSOR_TEST);
    gl_->Enable(GL_BLEND);
    gl_->BlendEquation(GL_FUNC_ADD);
    gl_->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_->ActiveTexture(GL_TEXTURE0);
    program_.use();
    program_.set("image", 0);
    program_.set("display_low", glm::vec2(data.DisplayPos.x, data.DisplayPos.y));
    program_.set("display_size", glm::vec2(data.DisplaySize.x, data.DisplaySize.y));
    gl_->BindVertexArray(vertex_array_.get());
}

void GlImGui::draw(const ImDrawData& data) const {
    const glm::ivec2 pixels = pixel_size(data);
    if (pixels.x <= 0 || pixels.y <= 0) return;  // a minimised window
    set_state(data, pixels);
    draw_within(data, pixels, whole(data));
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->Disable(GL_BLEND);
    check_gl(*gl_, "drawing the user interface");
}

void GlImGui::update(const ImDrawData& data, const Vec3f& background, ImTextureID still) {
    const glm::ivec2 pixels = pixel_size(data);
    if (pixels.x <= 0 || pixels.y <= 0) return;
    const std::vector<ScreenRect> parts = changes_.update(data, [&](ImTextureID texture) {
        return texture == still || texture == imgui_texture(fonts_);
    });
    if (parts.empty()) return;
    set_state(data, pixels);
    gl_->ClearColor(background.x, background.y, background.z, 1.0f);
    for (const ScreenRect& part : parts) {
        if (!scissor(part, data, pixels)) continue;
        gl_->Clear(GL_COLOR_BUFFER_BIT);
        draw_within(data, pixels, part);
    }
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->Disable(GL_BLEND);
    check_gl(*gl_, "drawing the user interface");
}

void GlImGui::draw_within(const ImDrawData& data, const glm::ivec2& pixels,
                          const ScreenRect& part) const {
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.get());
        gl_->BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data,
                        GL_STREAM_DRAW);
        gl_->BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(),
                        list.IdxBuffer.Data, GL_STREAM_DRAW);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const ImVec4& clip = command.ClipRect;
            const ScreenRect shown = common(part, {{clip.x, clip.y}, {clip.z, clip.w}});
            if (command.UserCallback == nullptr && scissor(shown, data, pixels)) draw(command);
        }
    }
}

/// Whole pixels; whether there are any.
bool GlImGui::scissor(const ScreenRect& part, const ImDrawData& data,
                      const glm::ivec2& pixels) const {
    const auto pixel = [&](const ImVec2& at) {
        return glm::ivec2((at.x - data.DisplayPos.x) * data.FramebufferScale.x,
                          (at.y - data.DisplayPos.y) * data.FramebufferScale.y);
    };
    const glm::ivec2 low = glm::max(pixel(part.low), glm::ivec2(0));
    const glm::ivec2 high = glm::min(pixel(part.high), pixels);
    if (low.x >= high.x || low.y >= high.y) return false;
    gl_->Scissor(low.x, pixels.y - high.y, high.x - low.x, high.y - low.y);
    return true;
}

void GlImGui::draw(const ImDrawCmd& command) const {
    gl_->BindTexture(GL_TEXTURE_2D, GLuint(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
    gl_->DrawElementsBaseVertex(GL_TRIANGLES, GLsizei(command.ElemCount),
                                sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                                offset(command.IdxOffset * sizeof(ImDrawIdx)),
                                GLint(command.VtxOffset));
}

}  // namespace burl
