#include "app/gl/draw/surroundings.h"

#include <utility>

#include "app/light/chosen_environment.h"

namespace burl {

namespace {

/// The rows of a built-in environment that is shown, and not only light.
constexpr std::size_t backdrop_rows = 1024;

GlTexture shadow_texture(const GladGLContext& gl, const Image<float>& shadow) {
    gl.ActiveTexture(GL_TEXTURE0);
    GlTexture texture = make_texture(gl, GL_R32F, {int(shadow.width()), int(shadow.height())},
                                     std::span(shadow.pixels()));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

/// Whether what a picture shows of its light is the light itself, so that the background may be
/// drawn with the scene.
bool shows_as_is(const PictureOptions& options) {
    return !options.lit || (options.light.is_headlight() && options.light.exposure == 0.0);
}

/// The value of samples that show nothing.
Vec4f clear_value(const PictureOptions& options) {
    if (options.background.kind != Background::Kind::color || !shows_as_is(options))
        return Vec4f(0.0f);
    return Vec4f(Vec3f(linear_light(options.background.color)), 1.0f);
}

}  // namespace

GlGround::GlGround(const GladGLContext& gl, const Ground& ground)
    : gl_(gl),
      corner_(ground.corner),
      side_(ground.side),
      shadow_(shadow_texture(gl, ground.shadow)),
      program_(gl, "draw/ground.vert", "draw/ground.frag"),
      vertices_(gl) {}

void GlGround::draw(const Camera& camera, const PictureSize& samples,
                    const SampleTile& tile) const {
    if (camera.eye.y <= corner_.y) return;
    const TileView view(camera, samples, tile);
    Mat4d scene_from_ground(side_);
    scene_from_ground[3] = Vec4d(corner_, 1.0);
    program_.use();
    program_.set("clip_from_ground",
                 glm::mat4(view.clip_from_eye * view.eye_from_scene * scene_from_ground));
    bind_texture(gl_, program_, "shadow", 0, shadow_);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Enable(GL_DEPTH_CLAMP);  // the ground goes on beyond the scene's far plane
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.BindVertexArray(vertices_.get());
    gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_DEPTH_CLAMP);
    check_gl(gl_, "drawing the ground");
}

GlSurroundings::GlSurroundings(const GladGLContext& gl, const Scene& scene,
                               const PictureOptions& options, std::shared_ptr<const GlLight> light)
    : gl_(gl), lit_(options.lit), clear_(clear_value(options)), light_(std::move(light)) {
    const bool headlit = !options.lit || options.light.is_headlight();
    Environment environment;
    if (!headlit && (!light_ || options.ground)) environment = environment_of(options.light);
    if (!headlit && !light_) light_ = std::make_shared<const GlLight>(gl, prefilter(environment));
    if (!headlit && options.background.kind == Background::Kind::light)
        backdrop_.emplace(gl, environment_of(options.light, backdrop_rows));
    if (options.ground)
        ground_.emplace(gl, ground_under(scene, headlit ? white_environment() : environment));
}

void GlSurroundings::draw(const Camera& camera, const PictureSize& samples,
                          const SampleTile& tile) const {
    gl_.Viewport(0, 0, tile.width, tile.height);
    gl_.ClearColor(clear_.x, clear_.y, clear_.z, clear_.w);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (backdrop_) backdrop_->draw(camera, samples, tile);
    if (ground_) ground_->draw(camera, samples, tile);
}

}  // namespace burl
