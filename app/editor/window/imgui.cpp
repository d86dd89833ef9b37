#include "app/editor/window/imgui.h"

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

bool contains(const ScreenRect& outer, const ScreenRect& inner) {
    return outer.low.x <= inner.low.x && outer.low.y <= inner.low.y &&
           outer.high.x >= inner.high.x && outer.high.y >= inner.high.y;
}

/// Returns the rectangle where a command draws a whole image unmodulated; empty for other commands.
ScreenRect image_place(const ImDrawList& list, const ImDrawCmd& command) {
    if (command.ElemCount != 6) return {};
    const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
    const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
    for (int i = 0; i < 6; ++i)
        if (vertices[index[i]].col != IM_COL32_WHITE) return {};
    // ImGui's AddImage writes the quad from its low corner; the third vertex is the high corner.
    return {vertices[index[0]].pos, vertices[index[2]].pos};
}

/// Returns a rectangle in whole pixels of the screen, row 0 on top.
PixelRect pixel_rect(const ScreenRect& part, const ImDrawData& data, const glm::ivec2& pixels) {
    const auto pixel = [&](const ImVec2& at) {
        return glm::ivec2((at.x - data.DisplayPos.x) * data.FramebufferScale.x,
                          (at.y - data.DisplayPos.y) * data.FramebufferScale.y);
    };
    return {glm::max(pixel(part.low), glm::ivec2(0)), glm::min(pixel(part.high), pixels)};
}

ScreenRect whole(const ImDrawData& data) {
    const ImVec2 &low = data.DisplayPos, &size = data.DisplaySize;
    return {low, {low.x + size.x, low.y + size.y}};
}

}  // namespace

GlTexture upload_levels(const GladGLContext& gl, const std::vector<Image<Rgb8>>& levels,
                        GLenum format) {
    GlTexture texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.get());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (std::size_t level = 0; level < levels.size(); ++level)
        gl.TexImage2D(GL_TEXTURE_2D, GLint(level), GLint(format), GLsizei(levels[level].width()),
                      GLsizei(levels[level].height()), 0, GL_RGB, GL_UNSIGNED_BYTE,
                      levels[level].pixels().data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    check_gl(gl, "uploading a picture of the user interface");
    return texture;
}

GlImGui::GlImGui(const GladGLContext& gl)
    : gl_(&gl), program_(gl, "draw/imgui.vert", "draw/imgui.frag"), vertex_array_(gl) {
    gl.BindVertexArray(vertex_array_.get());
    vertices_ = GlBuffer(gl);
    indices_ = GlBuffer(gl);
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
    fonts_ = GlTexture(*gl_);
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
    if (pixels.x <= 0 || pixels.y <= 0) return;  // the window is minimised
    set_state(data, pixels);
    draw_within(data, pixels, whole(data));
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->Disable(GL_BLEND);
    check_gl(*gl_, "drawing the user interface");
}

void GlImGui::update(const ImDrawData& data, const Vec3f& background, const OpaqueImage& image,
                     const std::function<bool(ImTextureID)>& lasts) {
    const glm::ivec2 pixels = pixel_size(data);
    if (pixels.x <= 0 || pixels.y <= 0) return;
    const ImTextureID picture = image.target ? imgui_texture(image.target->texture()) : nullptr;
    const std::vector<ScreenRect> parts = changes_.update(data, [&](ImTextureID texture) {
        return (image.still && texture == picture) || texture == imgui_texture(fonts_) ||
               lasts(texture);
    });
    if (parts.empty()) return;
    set_state(data, pixels);
    gl_->ClearColor(background.x, background.y, background.z, 1.0f);
    for (const ScreenRect& part : parts) {
        const ImDrawCmd* copied = picture ? copy(data, pixels, part, *image.target) : nullptr;
        if (!scissor(pixel_rect(part, data, pixels), pixels)) continue;
        if (!copied) gl_->Clear(GL_COLOR_BUFFER_BIT);
        draw_within(data, pixels, part, copied);
    }
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->Disable(GL_BLEND);
    check_gl(*gl_, "drawing the user interface");
}

/// Copies a dirty rectangle from the image instead of drawing it, where the image covers the
/// rectangle pixel by pixel, or is all of it and half as large. Returns the last command that does
/// so, or null where none does.
const ImDrawCmd* GlImGui::copy(const ImDrawData& data, const glm::ivec2& pixels,
                               const ScreenRect& part, const GlTarget& image) const {
    const ImDrawCmd* found = nullptr;
    PixelRect place;
    const PixelRect box = pixel_rect(part, data, pixels);
    for (int i = 0; i < data.CmdListsCount; ++i)
        for (const ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) {
            const ImVec4& clip = command.ClipRect;
            if (command.GetTexID() != imgui_texture(image.texture())) continue;
            const ScreenRect at = image_place(*data.CmdLists[i], command);
            const PixelRect all = pixel_rect(at, data, pixels);
            const glm::ivec2 size = all.high - all.low;
            const bool whole = size == image.size();
            const bool half =
                size / 2 == image.size() && box.low == all.low && box.high == all.high;
            if ((!whole && !half) || !contains(at, part) ||
                !contains({{clip.x, clip.y}, {clip.z, clip.w}}, part))
                continue;
            found = &command;
            place = all;
        }
    if (!found || box.empty()) return nullptr;
    const bool whole = place.high - place.low == image.size();
    const glm::ivec2 low = whole ? box.low - place.low : glm::ivec2(0);
    const glm::ivec2 high = whole ? box.high - place.low : image.size();
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, image.framebuffer());
    gl_->BlitFramebuffer(low.x, low.y, high.x, high.y, box.low.x, pixels.y - box.low.y, box.high.x,
                         pixels.y - box.high.y, GL_COLOR_BUFFER_BIT,
                         whole ? GL_NEAREST : GL_LINEAR);
    gl_->Enable(GL_SCISSOR_TEST);
    return found;
}

/// Draws the lists within a dirty rectangle, beginning behind the command `after`; null: at the
/// first one.
void GlImGui::draw_within(const ImDrawData& data, const glm::ivec2& pixels, const ScreenRect& part,
                          const ImDrawCmd* after) const {
    bool begun = after == nullptr;
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
            if (begun && command.UserCallback == nullptr &&
                scissor(pixel_rect(shown, data, pixels), pixels))
                draw(command);
            begun = begun || &command == after;
        }
    }
}

/// Sets the scissor rectangle; returns false where it is empty.
bool GlImGui::scissor(const PixelRect& part, const glm::ivec2& pixels) const {
    if (part.empty()) return false;
    const glm::ivec2 size = part.high - part.low;
    gl_->Scissor(part.low.x, pixels.y - part.high.y, size.x, size.y);
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
