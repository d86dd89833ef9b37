#include "app/gl_edit_gallery.h"

#include "app/gl_edit_imgui.h"

namespace burl {

namespace {

GlTexture upload(const GladGLContext& gl, const Image<Rgb8>& image) {
    GlTexture texture = make_texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.get());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, GLsizei(image.width()), GLsizei(image.height()), 0,
                  GL_RGB, GL_UNSIGNED_BYTE, image.pixels().data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.GenerateMipmap(GL_TEXTURE_2D);
    check_gl(gl, "uploading a preset's picture");
    return texture;
}

}  // namespace

GlEditGallery::GlEditGallery(const GladGLContext& gl, std::function<void()> wake)
    : gl_(&gl), thumbnails_(std::move(wake)) {}

ImTextureID GlEditGallery::picture(const std::string& preset, int side) {
    const std::pair key(preset, side);
    if (const auto found = textures_.find(key); found != textures_.end())
        return imgui_texture(found->second);
    const auto image = thumbnails_.picture(preset, side);
    if (!image) return nullptr;
    return imgui_texture(textures_.emplace(key, upload(*gl_, *image)).first->second);
}

}  // namespace burl
