#include "app/gl/draw/light.h"

#include "app/light/reflectance.h"

namespace burl {

namespace {

/// Uploads the faces of all levels of the cube map that is bound.
void upload_faces(const GladGLContext& gl, const PrefilteredLight& light) {
    for (std::size_t level = 0; level < light.glossy.size(); ++level)
        for (std::size_t face = 0; face < 6; ++face) {
            const Image<RgbF>& image = light.glossy[level][face];
            gl.TexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), GLint(level), GL_RGB32F,
                          GLsizei(image.width()), GLsizei(image.height()), 0, GL_RGB, GL_FLOAT,
                          image.pixels().data());
        }
}

void upload_glossy(const GladGLContext& gl, const PrefilteredLight& light) {
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    const auto set = [&](GLenum name, GLint value) {
        gl.TexParameteri(GL_TEXTURE_CUBE_MAP, name, value);
    };
    upload_faces(gl, light);
    set(GL_TEXTURE_MAX_LEVEL, GLint(light.glossy.size()) - 1);
    set(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    check_gl(gl, "uploading an environment's light");
}

/// An image of three floats a pixel as a texture that is looked up linearly.
template <class Pixel>
GlTexture upload(const GladGLContext& gl, const Image<Pixel>& image, GLint wrap_u) {
    static_assert(sizeof(Pixel) == 3 * sizeof(float));
    gl.ActiveTexture(GL_TEXTURE0);
    GlTexture texture = make_texture(gl, GL_RGB32F, {int(image.width()), int(image.height())},
                                     std::span(image.pixels()));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_u);
    return texture;
}

}  // namespace

GlLight::GlLight(const GladGLContext& gl, const PrefilteredLight& light)
    : gl_(gl),
      sun_(light.sun),
      glossy_(gl),
      table_(upload(gl, reflectance_table(), GL_CLAMP_TO_EDGE)),
      diffuse_(light.diffuse),
      last_level_(int(light.glossy.size()) - 1) {
    gl.ActiveTexture(GL_TEXTURE0 + glossy_unit);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, glossy_.get());
    upload_glossy(gl, light);
}

void GlLight::use(const GlProgram& program) const {
    gl_.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    gl_.ActiveTexture(GL_TEXTURE0 + glossy_unit);
    gl_.BindTexture(GL_TEXTURE_CUBE_MAP, glossy_.get());
    program.set("glossy", glossy_unit);
    bind_texture(gl_, program, "reflectances", table_unit, table_);
    program.set("last_level", float(last_level_));
    program.set("sun_direction", sun_.direction);
    program.set("sun_light", sun_.light);
    program.set("sun_radius", sun_.radius);
    gl_.Uniform3fv(program.uniform("diffuse"), GLsizei(diffuse_.size()), &diffuse_[0].x);
}

GlBackdrop::GlBackdrop(const GladGLContext& gl, const Environment& environment)
    : gl_(gl),
      environment_(upload(gl, environment.radiance, GL_REPEAT)),
      program_(gl, "maps/full_screen.vert", "draw/backdrop.frag"),
      pass_(gl) {}

void GlBackdrop::draw(const Camera& camera, const PictureSize& samples,
                      const SampleTile& tile) const {
    const auto at = [&](double x, double y) {
        return ray_through(camera, samples, {tile.x + x, tile.y + y}).direction;
    };
    const Vec3d corner = at(0.0, 0.0);
    program_.use();
    program_.set("corner", Vec3f(corner));
    program_.set("across", Vec3f(at(1.0, 0.0) - corner));
    program_.set("down", Vec3f(at(0.0, 1.0) - corner));
    bind_texture(gl_, program_, "environment", 0, environment_);
    gl_.Disable(GL_DEPTH_TEST);
    pass_.draw();
    check_gl(gl_, "drawing the environment");
}

}  // namespace burl
