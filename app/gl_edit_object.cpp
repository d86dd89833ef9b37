#include "app/gl_edit_object.h"

#include "app/gl_source.h"
#include "app/view_scene.h"

namespace burl {

namespace {

PictureSize sample_size(const ObjectViewOptions& options) {
    return {options.size.width * options.supersample, options.size.height * options.supersample};
}

GlRenderbuffer make_depth(const GladGLContext& gl, const PictureSize& size) {
    GLuint name = 0;
    gl.GenRenderbuffers(1, &name);
    GlRenderbuffer depth(gl, name);
    gl.BindRenderbuffer(GL_RENDERBUFFER, name);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.width, size.height);
    return depth;
}

}  // namespace

GlEditObject::GlEditObject(const GladGLContext& gl)
    : gl_(&gl),
      encode_(make_full_screen_program(gl, "the view of the object",
                                       ShaderSource().add("edit_encode.frag"))),
      pass_(gl),
      lines_(gl) {}

void GlEditObject::show(std::shared_ptr<const EditSurface> surface,
                        const std::shared_ptr<const EditPicture>& picture) {
    if (surface != surface_) {
        surface_ = std::move(surface);
        scene_ = surface_ ? std::make_unique<GlScene>(*gl_, surface_->scene) : nullptr;
        picture_.reset();
        normals_.reset();
        drawn_.reset();
    }
    const bool fits = surface_ && picture && picture->surface == surface_->number;
    if (fits && picture != picture_) upload(picture);
}

void GlEditObject::show_lines(const std::shared_ptr<const SurfaceLines>& lines) {
    if (lines_.shows(lines)) return;
    lines_.show(lines, surface_ ? surface_->sphere : Sphere{});
    drawn_.reset();
}

const GlTexture* GlEditObject::texture() const {
    if (!scene_ || !picture_) return nullptr;
    return &scene_->texture(baked_material(surface_->scene).texture);
}

void GlEditObject::upload(const std::shared_ptr<const EditPicture>& picture) {
    SceneTexture texture;
    texture.image = picture->texels;
    texture.filter = TextureFilter::mip;
    texture.wrap_u = texture.wrap_v = TextureWrap::clamp;
    scene_->set_texture(baked_material(surface_->scene).texture, texture);
    if (picture->normals != normals_) upload_normals(picture->normals);
    picture_ = picture;
    drawn_.reset();
}

void GlEditObject::upload_normals(std::shared_ptr<const Image<Rgb8>> normals) {
    normals_ = std::move(normals);
    const int number = baked_material(surface_->scene).normals;
    if (number < 0 || !normals_) return;
    SceneTexture texture = surface_->scene.textures[std::size_t(number)];
    texture.image = *normals_;
    scene_->set_texture(number, texture);
}

void GlEditObject::make_targets(const ObjectViewOptions& options) {
    const PictureSize samples = sample_size(options);
    const GlSize size{samples.width, samples.height},
        pixels{options.size.width, options.size.height};
    if (!samples_ || samples_->size() != size) {
        samples_.emplace(*gl_, size, std::initializer_list<GLenum>{GL_RGBA16F});
        depth_ = make_depth(*gl_, samples);
        samples_->bind();
        gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                     depth_.get());
    }
    if (shown_ && shown_->size() == pixels) return;
    shown_.emplace(*gl_, pixels, std::initializer_list<GLenum>{GL_RGBA8});
}

void GlEditObject::draw_samples(const ObjectViewOptions& options) {
    const PictureSize samples = sample_size(options);
    const Camera camera = camera_of(options.camera, surface_->sphere, options.size);
    samples_->bind();
    scene_->draw(camera, samples, {0, 0, samples.width, samples.height}, options.lit);
    if (options.edges) lines_.draw(GlEditLines::Kind::edges, camera, samples, options.supersample);
    if (options.borders)
        lines_.draw(GlEditLines::Kind::borders, camera, samples, options.supersample);
    gl_->Disable(GL_DEPTH_TEST);
}

void GlEditObject::encode(const ObjectViewOptions& options) const {
    shown_->bind();
    encode_.use();
    encode_.set("samples", 0);
    encode_.set("side", options.supersample);
    bind_texture(*gl_, 0, samples_->texture());
    pass_.draw();
    check_gl(*gl_, "drawing the object");
}

const GlTexture* GlEditObject::draw(const ObjectViewOptions& options) {
    if (!scene_ || options.size.width <= 0 || options.size.height <= 0) return nullptr;
    if (drawn_ != options) {
        make_targets(options);
        draw_samples(options);
        encode(options);
        drawn_ = options;
    }
    return &shown_->texture();
}

}  // namespace burl
