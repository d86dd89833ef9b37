#include "app/editor/window/gallery.h"

#include "app/editor/window/imgui.h"

namespace burl {

namespace {

GlTexture upload(const GladGLContext& gl, const Image<Rgb8>& image) {
    GlTexture texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.get());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const std::vector<Image<Rgb8>> levels = picture_levels(image);
    for (std::size_t level = 0; level < levels.size(); ++level)
        gl.TexImage2D(GL_TEXTURE_2D, GLint(level), GL_RGB8, GLsizei(levels[level].width()),
                      GLsizei(levels[level].height()), 0, GL_RGB, GL_UNSIGNED_BYTE,
                      levels[level].pixels().data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
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
