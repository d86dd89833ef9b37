#include "app/gl/device/target.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace burl {

namespace {

constexpr std::array formats{
    GlFormat{GL_R8, "R8", GL_RED, GL_UNSIGNED_BYTE, 1, 1},
    GlFormat{GL_RG8, "RG8", GL_RG, GL_UNSIGNED_BYTE, 2, 1},
    GlFormat{GL_RGB8, "RGB8", GL_RGB, GL_UNSIGNED_BYTE, 3, 1},
    GlFormat{GL_RGBA8, "RGBA8", GL_RGBA, GL_UNSIGNED_BYTE, 4, 1},
    GlFormat{GL_SRGB8, "SRGB8", GL_RGB, GL_UNSIGNED_BYTE, 3, 1},
    GlFormat{GL_SRGB8_ALPHA8, "SRGB8_ALPHA8", GL_RGBA, GL_UNSIGNED_BYTE, 4, 1},
    GlFormat{GL_RGBA16, "RGBA16", GL_RGBA, GL_UNSIGNED_SHORT, 4, 2},
    GlFormat{GL_R16F, "R16F", GL_RED, GL_FLOAT, 1, 4},
    GlFormat{GL_RG16F, "RG16F", GL_RG, GL_FLOAT, 2, 4},
    GlFormat{GL_RGBA16F, "RGBA16F", GL_RGBA, GL_FLOAT, 4, 4},
    GlFormat{GL_R32F, "R32F", GL_RED, GL_FLOAT, 1, 4},
    GlFormat{GL_RG32F, "RG32F", GL_RG, GL_FLOAT, 2, 4},
    GlFormat{GL_RGB32F, "RGB32F", GL_RGB, GL_FLOAT, 3, 4},
    GlFormat{GL_RGBA32F, "RGBA32F", GL_RGBA, GL_FLOAT, 4, 4},
    GlFormat{GL_R32UI, "R32UI", GL_RED_INTEGER, GL_UNSIGNED_INT, 1, 4},
    GlFormat{GL_RG32UI, "RG32UI", GL_RG_INTEGER, GL_UNSIGNED_INT, 2, 4},
    GlFormat{GL_RGBA32UI, "RGBA32UI", GL_RGBA_INTEGER, GL_UNSIGNED_INT, 4, 4},
};

/// The size of a texel in host memory, in bytes.
std::size_t texel_bytes(const GlFormat& format) {
    return std::size_t(format.components * format.component_bytes);
}

void check_limit(const GladGLContext& gl, GLenum name, std::size_t asked, std::string_view what) {
    GLint limit = 0;
    gl.GetIntegerv(name, &limit);
    if (asked <= std::size_t(limit)) return;
    throw Error(ExitCode::unsupported,
                fmt::format("{} is more than the {} this OpenGL has", what, limit));
}

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

const GlFormat& format_of(GLenum internal) {
    const auto found = std::ranges::find(formats, internal, &GlFormat::internal);
    if (found == formats.end())
        throw Error(ExitCode::runtime,
                    fmt::format("synthesis has no texture format {:#x}", internal));
    return *found;
}

GlTexture make_texture(const GladGLContext& gl, GLenum internal, GlSize size,
                       std::span<const std::byte> texels) {
    const GlFormat& format = format_of(internal);
    const std::string what =
        fmt::format("a {} texture of {}x{} texels", format.name, size.x, size.y);
    check_limit(gl, GL_MAX_TEXTURE_SIZE, std::size_t(std::max(size.x, size.y)), what);
    const std::size_t bytes = std::size_t(size.x) * std::size_t(size.y) * texel_bytes(format);
    if (!texels.empty() && texels.size() != bytes)
        throw Error(ExitCode::runtime,
                    fmt::format("{} takes {} bytes, not {}", what, bytes, texels.size()));
    GlTexture texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.get());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GLint(internal), size.x, size.y, 0, format.layout, format.type,
                  texels.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    check_gl(gl, "making " + what);
    return texture;
}

void bind_texture(const GladGLContext& gl, int unit, const GlTexture& texture) {
    gl.ActiveTexture(GLenum(GL_TEXTURE0 + unit));
    gl.BindTexture(GL_TEXTURE_2D, texture.get());
}

void bind_texture(const GladGLContext& gl, const GlProgram& program, const char* name, int unit,
                  const GlTexture& texture) {
    bind_texture(gl, unit, texture);
    program.set(name, unit);
}

GlBufferTexture::GlBufferTexture(const GladGLContext& gl, GLenum internal,
                                 std::span<const std::byte> texels)
    : gl_(&gl), buffer_(gl), texture_(gl) {
    const GlFormat& format = format_of(internal);
    const std::size_t count = texels.size() / texel_bytes(format);
    const std::string what = fmt::format("a {} array of {} texels", format.name, count);
    check_limit(gl, GL_MAX_TEXTURE_BUFFER_SIZE, count, what);
    gl.BindBuffer(GL_TEXTURE_BUFFER, buffer_.get());
    gl.BufferData(GL_TEXTURE_BUFFER, GLsizeiptr(texels.size()), texels.data(), GL_STATIC_DRAW);
    gl.BindTexture(GL_TEXTURE_BUFFER, texture_.get());
    gl.TexBuffer(GL_TEXTURE_BUFFER, internal, buffer_.get());
    check_gl(gl, "making " + what);
}

void GlBufferTexture::bind(const GlProgram& program, const char* name, int unit) const {
    gl_->ActiveTexture(GLenum(GL_TEXTURE0 + unit));
    gl_->BindTexture(GL_TEXTURE_BUFFER, texture_.get());
    program.set(name, unit);
}

GlTarget::GlTarget(const GladGLContext& gl, GlSize size, std::span<const GLenum> internals)
    : gl_(&gl), size_(size), framebuffer_(gl) {
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
