#include "app/gl/device/texture.h"

#include <algorithm>
#include <array>

#include "atlas/base/error.h"

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
    GlTexture texture = make_texture(gl);
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

GlBufferTexture::GlBufferTexture(const GladGLContext& gl, GLenum internal,
                                 std::span<const std::byte> texels)
    : gl_(&gl), buffer_(make_buffer(gl)), texture_(make_texture(gl)) {
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

void GlBufferTexture::bind(int unit) const {
    gl_->ActiveTexture(GLenum(GL_TEXTURE0 + unit));
    gl_->BindTexture(GL_TEXTURE_BUFFER, texture_.get());
}

}  // namespace burl
