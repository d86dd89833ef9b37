#include "app/editor/window/places.h"

#include "app/gl/device/objects.h"
#include "app/gl/draw/scene.h"

namespace burl {

namespace {

GlRenderbuffer make_depth(const GladGLContext& gl, const PictureSize& size, GLenum format) {
    GlRenderbuffer depth(gl);
    gl.BindRenderbuffer(GL_RENDERBUFFER, depth.get());
    gl.RenderbufferStorage(GL_RENDERBUFFER, format, size.width, size.height);
    return depth;
}

void attach_depth(const GladGLContext& gl, const GlTarget& target, const GlRenderbuffer& depth) {
    target.bind();
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.get());
}

}  // namespace

GlDepthTarget::GlDepthTarget(const GladGLContext& gl, const PictureSize& size, GLenum format,
                             GLenum depth_format)
    : colors(gl, {size.width, size.height}, {format}),
      depth_(std::make_shared<const GlRenderbuffer>(make_depth(gl, size, depth_format))) {
    attach_depth(gl, colors, *depth_);
}

GlDepthTarget::GlDepthTarget(const GladGLContext& gl, const GlDepthTarget& other, GLenum format)
    : colors(gl, other.colors.size(), {format}), depth_(other.depth_) {
    attach_depth(gl, colors, *depth_);
}

GlEditPlaces::GlEditPlaces(const GladGLContext& gl)
    : gl_(&gl),
      color_(make_full_screen_program(
          gl, "the object's places",
          ShaderSource().add("color/srgb_encode.glsl").add("draw/places.frag"))),
      pass_(gl) {}

void GlEditPlaces::find(const GlScene& scene, const Camera& camera, const GlDepthTarget& target,
                        bool lit, const DrawPart& part) {
    if (part.number == 0) places_.emplace(*gl_, target, GL_RGBA32F);
    const GlSize size = target.colors.size();
    places_->colors.bind();
    scene.draw_places(camera, {size.x, size.y}, {0, 0, size.x, size.y}, lit, part);
    gl_->Disable(GL_DEPTH_TEST);
}

/// Shades the G-buffer by a full-screen pass at the far plane. The depth test is GL_GREATER, so
/// that only pixels with a surface pass.
void GlEditPlaces::draw(const GlTexture& texture, const GlDepthTarget& target) const {
    target.colors.bind();
    const Vec4f background = GlScene::background_codes();
    gl_->ClearColor(background.x, background.y, background.z, background.w);
    gl_->Clear(GL_COLOR_BUFFER_BIT);
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthMask(GL_FALSE);
    gl_->DepthFunc(GL_GREATER);
    gl_->DepthRange(1.0, 1.0);
    color_.use();
    color_.set("places", 0);
    color_.set("base_color", 1);
    bind_texture(*gl_, 0, places_->colors.texture());
    bind_texture(*gl_, 1, texture);
    pass_.draw();
    gl_->DepthRange(0.0, 1.0);
    gl_->DepthFunc(GL_LESS);
    gl_->DepthMask(GL_TRUE);
    gl_->Disable(GL_DEPTH_TEST);
    check_gl(*gl_, "drawing the object's places");
}

}  // namespace burl
