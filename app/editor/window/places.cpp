#include "app/editor/window/places.h"

#include <array>

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

/// Lookups, and in an environment's light what a black and a white surface send.
constexpr std::array<GLenum, 3> place_formats{GL_RGBA32F, GL_RGBA16F, GL_RGBA16F};

GlProgram shading_program(const GladGLContext& gl, bool in_environment) {
    return make_full_screen_program(gl, "the object's places",
                                    ShaderSource()
                                        .define("AMBIENT", in_environment ? "true" : "false")
                                        .define("TONE", in_environment ? "true" : "false")
                                        .add("color/srgb_encode.glsl")
                                        .add("draw/tone.glsl")
                                        .add("draw/places.frag"));
}

}  // namespace

GlDepthTarget::GlDepthTarget(const GladGLContext& gl, const PictureSize& size, GLenum format,
                             GLenum depth_format)
    : colors(gl, {size.width, size.height}, {format}),
      depth_(std::make_shared<const GlRenderbuffer>(make_depth(gl, size, depth_format))) {
    attach_depth(gl, colors, *depth_);
}

GlDepthTarget::GlDepthTarget(const GladGLContext& gl, const GlDepthTarget& other,
                             std::span<const GLenum> formats)
    : colors(gl, other.colors.size(), formats), depth_(other.depth_) {
    attach_depth(gl, colors, *depth_);
}

GlEditPlaces::GlEditPlaces(const GladGLContext& gl)
    : gl_(&gl),
      color_(shading_program(gl, false)),
      developed_(shading_program(gl, true)),
      pass_(gl) {}

void GlEditPlaces::begin(const GlDepthTarget& target, const GlShading& shading) {
    const std::size_t count = shading.light ? place_formats.size() : 1;
    places_.emplace(*gl_, target, std::span(place_formats).first(count));
    places_->colors.bind();
    gl_->ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void GlEditPlaces::find(const GlScene& scene, const Camera& camera, const GlShading& shading,
                        const DrawPart& part) const {
    const GlSize size = places_->colors.size();
    places_->colors.bind();
    scene.draw_places(camera, {size.x, size.y}, {0, 0, size.x, size.y}, shading, part);
    gl_->Disable(GL_DEPTH_TEST);
}

/// Shades the G-buffer by a full-screen pass at the far plane. The depth test is GL_GREATER, so
/// that only pixels with a surface pass.
void GlEditPlaces::draw(const GlTexture& texture, const GlDepthTarget& target,
                        const GlShading& shading) const {
    const GlProgram& program = shading.light ? developed_ : color_;
    target.colors.bind();
    const Vec4f background = GlScene::background_codes();
    gl_->ClearColor(background.x, background.y, background.z, background.w);
    gl_->Clear(GL_COLOR_BUFFER_BIT);
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthMask(GL_FALSE);
    gl_->DepthFunc(GL_GREATER);
    gl_->DepthRange(1.0, 1.0);
    program.use();
    program.set("exposure", shading.exposure);
    bind_texture(*gl_, program, "base_color", 0, texture);
    const std::array<const char*, 3> names{"places", "dark", "bright"};
    for (std::size_t i = 0; i < places_->colors.count(); ++i)
        bind_texture(*gl_, program, names[i], int(i) + 1, places_->colors.texture(i));
    pass_.draw();
    gl_->DepthRange(0.0, 1.0);
    gl_->DepthFunc(GL_LESS);
    gl_->DepthMask(GL_TRUE);
    gl_->Disable(GL_DEPTH_TEST);
    check_gl(*gl_, "drawing the object's places");
}

}  // namespace burl
