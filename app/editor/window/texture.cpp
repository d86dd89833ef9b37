#include "app/editor/window/texture.h"

#include <fmt/format.h>

#include <algorithm>

#include "atlas/base/error.h"

namespace burl {

namespace {

void check_size(const GladGLContext& gl, const Image<Rgba8>& image) {
    GLint limit = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (std::max(image.width(), image.height()) > std::size_t(limit))
        throw Error(ExitCode::unsupported,
                    fmt::format("the texture of {}x{} texels is larger than this OpenGL draws ({})",
                                image.width(), image.height(), limit));
}

}  // namespace

void GlEditTexture::make_storage(const std::vector<Image<Rgba8>>& levels) {
    check_size(*gl_, levels.front());
    for (std::size_t level = 0; level < levels.size(); ++level)
        gl_->TexImage2D(GL_TEXTURE_2D, GLint(level), GL_SRGB8_ALPHA8,
                        GLsizei(levels[level].width()), GLsizei(levels[level].height()), 0, GL_RGBA,
                        GL_UNSIGNED_BYTE, nullptr);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    width_ = levels.front().width();
    height_ = levels.front().height();
    count_ = levels.size();
}

void GlEditTexture::show(const std::vector<Image<Rgba8>>& levels) {
    const Image<Rgba8>& finest = levels.front();
    gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_->BindTexture(GL_TEXTURE_2D, texture_);
    if (finest.width() != width_ || finest.height() != height_ || levels.size() != count_)
        make_storage(levels);
    for (std::size_t level = 0; level < levels.size(); ++level)
        gl_->TexSubImage2D(GL_TEXTURE_2D, GLint(level), 0, 0, GLsizei(levels[level].width()),
                           GLsizei(levels[level].height()), GL_RGBA, GL_UNSIGNED_BYTE,
                           levels[level].pixels().data());
    if (levels.size() == 1) gl_->GenerateMipmap(GL_TEXTURE_2D);
    check_gl(*gl_, fmt::format("uploading a texture of {}x{} texels", width_, height_));
}

}  // namespace burl
