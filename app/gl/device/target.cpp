#include "app/gl/device/target.h"

#include <numeric>

namespace burl {

namespace {

bool is_integer(const GlFormat& format) {
    return format.type == GL_UNSIGNED_INT;
}

GLenum layout_of(const GlFormat& format, int components) {
    if (components == 0 || components == format.components) return format.layout;
    const bool integer = is_integer(format);
    if (components == 1) return integer ? GL_RED_INTEGER : GL_RED;
    if (components == 3) return integer ? GL_RGB_INTEGER : GL_RGB;
    return integer ? GL_RGBA_INTEGER : GL_RGBA;
}

GlFramebufferName make_framebuffer(const GladGLContext& gl) {
    GLuint name = 0;
    gl.GenFramebuffers(1, &name);
    return {gl, name};
}

void check_count(const GladGLContext& gl, std::size_t count) {
    GLint attachments = 0, outputs = 0;
    gl.GetIntegerv(GL_MAX_COLOR_ATTACHMENTS, &attachments);
    gl.GetIntegerv(GL_MAX_DRAW_BUFFERS, &outputs);
    if (count <= std::size_t(std::min(attachments, outputs))) return;
    throw Error(ExitCode::unsupported,
                fmt::format("{} textures drawn into together are more than the {} this OpenGL has",
                            count, std::min(attachments, outputs)));
}

}  // namespace

GlTarget::GlTarget(const GladGLContext& gl, GlSize size, std::span<const GLenum> internals)
    : gl_(&gl), size_(size), framebuffer_(make_framebuffer(gl)) {
    check_count(gl, internals.size());
    std::string names;
    for (const GLenum internal : internals) {
        formats_.push_back(&format_of(internal));
        textures_.push_back(make_texture(gl, internal, size));
        names += (names.empty() ? "" : " + ") + std::string(formats_.back()->name);
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    std::vector<GLenum> outputs(internals.size());
    std::iota(outputs.begin(), outputs.end(), GLenum(GL_COLOR_ATTACHMENT0));
    for (std::size_t i = 0; i < outputs.size(); ++i)
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, outputs[i], GL_TEXTURE_2D, textures_[i].get(), 0);
    gl.DrawBuffers(GLsizei(outputs.size()), outputs.data());
    const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
    check_gl(gl, fmt::format("making a {} target of {}x{} texels", names, size.x, size.y));
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ExitCode::unsupported,
                    fmt::format("this OpenGL cannot draw into a {} target of {}x{} texels "
                                "(status {:#x})",
                                names, size.x, size.y, status));
}

void GlTarget::bind(const GlTile& part) const {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    gl_->Viewport(part.origin.x, part.origin.y, part.size.x, part.size.y);
}

void GlTarget::clear(std::size_t number, const Vec4f& value) const {
    bind();
    gl_->ClearBufferfv(GL_COLOR, GLint(number), &value[0]);
}

void GlTarget::clear(std::size_t number, const glm::uvec4& value) const {
    bind();
    gl_->ClearBufferuiv(GL_COLOR, GLint(number), &value[0]);
}

void GlTarget::read_bytes(std::span<std::byte> texels, std::size_t component_bytes,
                          const GlTile& part, std::size_t number, int components) const {
    const GlFormat& own = format(number);
    const std::size_t count = std::size_t(components == 0 ? own.components : components);
    const std::size_t bytes =
        std::size_t(part.size.x) * std::size_t(part.size.y) * count * component_bytes;
    if (component_bytes != std::size_t(own.component_bytes) || texels.size() != bytes)
        throw Error(ExitCode::runtime,
                    fmt::format("{}x{} texels of {} are not {} bytes of {} each", part.size.x,
                                part.size.y, own.name, texels.size(), component_bytes));
    bind();
    gl_->ReadBuffer(GLenum(GL_COLOR_ATTACHMENT0 + number));
    gl_->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_->ReadPixels(part.origin.x, part.origin.y, part.size.x, part.size.y,
                    layout_of(own, components), own.type, texels.data());
    check_gl(*gl_, fmt::format("reading {}x{} texels of {}", part.size.x, part.size.y, own.name));
}

}  // namespace burl
