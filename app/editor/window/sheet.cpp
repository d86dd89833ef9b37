#include "app/editor/window/sheet.h"

#include <algorithm>
#include <bit>

namespace burl {

GlEditSheet::GlEditSheet(const GladGLContext& gl)
    : gl_(&gl),
      program_(make_full_screen_program(
          gl, "the atlas view",
          ShaderSource().add("color/srgb_encode.glsl").add("draw/sheet.frag"))),
      pass_(gl) {}

void GlEditSheet::upload(const SheetPicture& picture) {
    texture_ = GlTexture(*gl_);
    gl_->BindTexture(GL_TEXTURE_2D, texture_.get());
    gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (std::size_t l = 0; l < picture.levels.size(); ++l) {
        const Image<Rgb8>& level = picture.levels[l];
        gl_->TexImage2D(GL_TEXTURE_2D, GLint(l), GL_SRGB8, GLsizei(level.width()),
                        GLsizei(level.height()), 0, GL_RGB, GL_UNSIGNED_BYTE,
                        level.pixels().data());
    }
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    check_gl(*gl_, "uploading a picture of the atlas");
}

const GlTexture* GlEditSheet::draw(const std::shared_ptr<const SheetPicture>& picture,
                                   const SheetViewOptions& options) {
    if (!picture || picture->levels.empty()) return nullptr;
    if (picture != picture_) {
        upload(*picture);
        picture_ = picture;
        ++uploads_;
    }
    return draw(texture_, std::uint32_t(picture->levels.front().width()), uploads_, options);
}

const GlTexture* GlEditSheet::draw(const GlTexture& texture, std::uint32_t side,
                                   std::uint64_t number, const SheetViewOptions& options) {
    if (options.size.x <= 0 || options.size.y <= 0) return nullptr;
    const Drawn now{texture.get(), number, options};
    if (drawn_ == now) return &shown_->texture();
    if (!shown_ || shown_->size() != options.size)
        shown_.emplace(*gl_, options.size, std::initializer_list<GLenum>{GL_RGBA8});
    const int coarsest = int(std::bit_width(std::max(side, 1U))) - 1;
    const Vec2d size(options.size);
    shown_->bind();
    program_.use();
    program_.set("image", 0);
    program_.set("uv_low", glm::vec2(uv_at(options.frame, size, Vec2d(0.0))));
    program_.set("uv_per_pixel", glm::vec2(float(1.0 / pixels_per_unit(options.frame, size))));
    program_.set("level", std::clamp(options.level, 0, coarsest));
    bind_texture(*gl_, 0, texture);
    pass_.draw();
    check_gl(*gl_, "drawing the atlas");
    drawn_ = now;
    return &shown_->texture();
}

void GlEditSheet::release() {
    picture_.reset();
    texture_ = {};
    shown_.reset();
    drawn_.reset();
}

}  // namespace burl
