#include "app/editor/window/object.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>
#include "app/gl/device/context.h"
#include "app/gl/device/objects.h"
#include "app/gl/draw/view_scene.h"
#include "app/scene/shading.h"
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

constexpr std::size_t piece_bytes = std::size_t(1) << 20;
constexpr std::chrono::milliseconds patience{4};  ///< longest upload of a surface in a frame
/// The part of a view at rest that a software OpenGL draws in a frame: triangles of a large
/// surface, and samples; an environment's light takes longer.
constexpr std::size_t part_triangles = 40'000, part_samples = 500'000;

/// The pixels that are drawn, and the samples.
PictureSize pixel_size(const ObjectViewOptions& options) {
    if (!options.half) return options.size;
    return {std::max(options.size.width / 2, 1), std::max(options.size.height / 2, 1)};
}
PictureSize sample_size(const ObjectViewOptions& options) {
    const PictureSize pixels = pixel_size(options);
    return {pixels.width * options.supersample, pixels.height * options.supersample};
}

GlProgram encode_program(const GladGLContext& gl, bool tone_curve) {
    return make_full_screen_program(gl, "the view of the object",
                                    ShaderSource()
                                        .define("TONE", tone_curve ? "true" : "false")
                                        .add("color/srgb_encode.glsl")
                                        .add("draw/tone.glsl")
                                        .add("draw/encode.frag"));
}

}  // namespace

void GlEditTexture::make_storage(const std::vector<Image<Rgba8>>& levels) {
    check_size(*gl_, levels.front());
    for (std::size_t level = 0; level < levels.size(); ++level)
        gl_->TexImage2D(GL_TEXTURE_2D, GLint(level), is_color_ ? GL_SRGB8_ALPHA8 : GL_RGBA8,
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

GlEditObject::GlEditObject(const GladGLContext& gl)
    : gl_(&gl),
      is_software_(is_software(gl)),
      encode_(encode_program(gl, false)),
      develop_(encode_program(gl, true)),
      pass_(gl),
      programs_(std::make_shared<GlScenePrograms>(gl)),
      lines_(gl),
      places_(gl) {}

void GlEditObject::show(const std::shared_ptr<const EditSurface>& surface,
                        const std::shared_ptr<const EditPicture>& picture,
                        const std::shared_ptr<const EditSurface>& coming) {
    begin(coming ? coming : surface);
    upload();
    if (next_ == surface && next_ != surface_ && !uploading()) take_over();
    const bool fits = surface_ && picture && picture->surface == surface_->number;
    if (fits && picture != picture_) upload(picture);
}

/// Begins the upload of a surface, unless it is uploaded or under way.
void GlEditObject::begin(const std::shared_ptr<const EditSurface>& surface) {
    if (surface == next_) return;
    next_ = surface;
    next_scene_.reset();
    uploaded_ = false;
    if (next_ && next_ != surface_)
        next_scene_ = std::make_unique<GlScene>(*gl_, next_->scene, programs_, next_->frames);
}

void GlEditObject::upload() {
    const auto begin = std::chrono::steady_clock::now();
    while (uploading() && std::chrono::steady_clock::now() - begin < patience)
        uploaded_ = next_scene_->upload(next_->scene, piece_bytes);
}

/// Makes the uploaded surface the one shown.
void GlEditObject::take_over() {
    scene_ = std::move(next_scene_);
    // Freeing hundreds of megabytes takes longer than a frame, so another thread does it.
    dropping_ = std::async(std::launch::async,
                           [old = std::exchange(surface_, next_)]() mutable { old.reset(); });
    textures_.clear();
    picture_.reset();
    normals_.reset();
    coarse_.reset();
    pictured_ = false;
    drawn_.reset();
    parted_.reset();
    seen_.reset();
    placed_.reset();
}

void GlEditObject::show_coarse(const std::shared_ptr<const CoarseSurfaces>& coarse) {
    if (coarse == coarse_ || !scene_) return;
    coarse_ = coarse;
    scene_->set_coarse(coarse ? *coarse : CoarseSurfaces(), surface_->frames);
}

void GlEditObject::show_lines(const std::shared_ptr<const SurfaceLines>& lines) {
    if (lines_.shows(lines)) return;
    lines_.show(lines, surface_ ? surface_->sphere : Sphere{});
    drawn_.reset();
    parted_.reset();
}

const GlTexture* GlEditObject::texture() const {
    if (!scene_ || !picture_) return nullptr;
    return &scene_->texture(baked_material(surface_->scene).texture);
}

void GlEditObject::upload(const std::shared_ptr<const EditPicture>& picture) {
    const int colors = baked_material(surface_->scene).texture;
    const EditMaterial* material = picture->material.get();
    borrow(picture->resident);
    const bool made_here = picture->resident.pictures != nullptr;
    if (!made_here && (!material || !material->pictures.contains(colors)))
        upload(colors, picture->levels);
    if (material && (!picture_ || material != picture_->material.get())) {
        const SceneMaterial* before =
            picture_ && picture_->material ? &picture_->material->numbers : nullptr;
        if (!before || *before != material->numbers) placed_.reset();  // its light is another
        scene_->set_material(material->numbers);
        for (const auto& [number, levels] : material->pictures) upload(number, levels);
    }
    if (picture->normals != normals_) upload_normals(picture->normals);
    picture_ = picture;
    drawn_.reset();
    parted_.reset();
}

/// Has the scene show the textures that OpenGL made, or its own where it made none.
void GlEditObject::borrow(const ResidentPicture& resident) {
    for (std::size_t i = 0; i < surface_->scene.textures.size(); ++i)
        scene_->lend_texture(int(i), nullptr);
    for (std::size_t i = 0; i < resident.numbers.size(); ++i)
        scene_->lend_texture(resident.numbers[i], &resident.pictures->images[i]);
}

/// Uploads the levels of the scene's texture `number`.
void GlEditObject::upload(int number, const std::vector<Image<Rgba8>>& levels) {
    const bool is_color = surface_->scene.textures[std::size_t(number)].is_color;
    textures_.try_emplace(number, *gl_, scene_->texture(number).get(), is_color)
        .first->second.show(levels);
}

void GlEditObject::upload_normals(std::shared_ptr<const Image<Rgb8>> normals) {
    normals_ = std::move(normals);
    const int number = baked_material(surface_->scene).normals;
    if (number < 0 || !normals_) return;
    SceneTexture texture = surface_->scene.textures[std::size_t(number)];
    texture.image = *normals_;
    scene_->set_texture(number, texture);
}

void GlEditObject::make_target(std::optional<GlDepthTarget>& target, const PictureSize& size,
                               GLenum format) {
    if (target && target->colors.size() == GlSize{size.width, size.height}) return;
    if (target && image_ == &*target) image_ = nullptr;
    target.emplace(*gl_, size, format);
    if (&target == &shown_) placed_.reset();
    parted_.reset();
    pictured_ &= image_ != nullptr;
}

/// Whether the view can be drawn without a second pass: with one sample per pixel, no lines and
/// nothing that blends, where that pass would take longer than the first.
bool GlEditObject::is_direct(const ObjectViewOptions& options) const {
    return options.supersample == 1 && !options.edges && !options.borders && !scene_->has_layers();
}

/// Whether coarse surfaces are drawn: not where only the texture has changed and the G-buffer does.
bool GlEditObject::is_coarse(const ObjectViewOptions& options) const {
    return options.coarse && scene_->has_coarse() &&
           !(keeps_places(options) && (seen_ == options || placed_ == options));
}

/// A part of a view that a software OpenGL draws: of the triangles of a large surface, else of the
/// rows; others draw all.
ViewPart GlEditObject::part_of(const ObjectViewOptions& options, int number) const {
    if (!is_software_) return {};
    const bool rows = !scene_->has_coarse();
    const PictureSize size = sample_size(options);
    const std::size_t all = rows ? std::size_t(size.width) * std::size_t(size.height)
                                 : drawn_triangles(surface_->scene);
    const std::size_t each = rows ? part_samples : part_triangles;
    return {number, int(1 + all / (!options.light ? each : rows ? each / 4 : each / 2)), rows};
}

/// Restricts drawing to the part's rows, until the scissor test is disabled.
void GlEditObject::keep_to(const ViewPart& part, const PictureSize& samples) const {
    if (!part.rows) return;
    const auto row = [&](int number) { return samples.height * number / part.count; };
    gl_->Enable(GL_SCISSOR_TEST);
    gl_->Scissor(0, row(part.number), samples.width, row(part.number + 1) - row(part.number));
}

void GlEditObject::make_targets(const ObjectViewOptions& options) {
    std::optional<GlDepthTarget>& shown = options.half ? small_ : shown_;
    make_target(shown, pixel_size(options), GL_RGBA8);
    gl_->BindTexture(GL_TEXTURE_2D, shown->colors.texture().get());
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    if (!is_direct(options) && !is_coarse(options))
        make_target(samples_, sample_size(options), GL_RGBA16F);
}

/// The pixels to draw; the depth of the G-buffer is that of all pixels.
GlDepthTarget& GlEditObject::target_of(const ObjectViewOptions& options) {
    if (options.half) return *small_;
    placed_.reset();
    return *shown_;
}

/// Draws the samples of the view, or their next part; part_ is 0 after the last one.
void GlEditObject::draw_samples(const ObjectViewOptions& options) {
    const PictureSize samples = sample_size(options);
    const Camera camera = camera_of(options.camera, surface_->sphere, pixel_size(options));
    samples_->colors.bind();
    const SampleTile tile{0, 0, samples.width, samples.height};
    const GlShading shading = shading_of(options);
    if (part_ == 0)
        scene_->clear(tile,
                      shading.tone_curve ? Vec4f(0.0f) : Vec4f(Vec3f(background_linear()), 1.0f));
    const ViewPart part = pictured_ ? part_of(options, part_) : ViewPart();
    keep_to(part, samples);
    scene_->draw(camera, samples, tile, shading, part.triangles());
    if (part.rows || part.is_last()) {
        draw_layers(options);
        draw_lines(options);
    }
    part_ = part.is_last() ? 0 : part.number + 1;
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->Disable(GL_DEPTH_TEST);
}

/// Draws what blends over what the samples show.
void GlEditObject::draw_layers(const ObjectViewOptions& options) {
    if (!scene_->has_layers()) return;
    const PictureSize samples = sample_size(options);
    const Camera camera = camera_of(options.camera, surface_->sphere, pixel_size(options));
    const GlShading shading = shading_of(options);
    if (!options.every_layer)
        return scene_->draw_blended(camera, samples, {0, 0, samples.width, samples.height},
                                    shading);
    if (!layers_) layers_.emplace(*gl_);
    layers_->draw(*scene_, camera, shading, *samples_);
    gl_->Enable(GL_DEPTH_TEST);
}

void GlEditObject::draw_lines(const ObjectViewOptions& options) {
    const Camera camera = camera_of(options.camera, surface_->sphere, options.size);
    for (const auto& [kind, shown] : {std::pair(GlEditLines::Kind::edges, options.edges),
                                      std::pair(GlEditLines::Kind::borders, options.borders)})
        if (shown)
            lines_.draw(kind, camera, sample_size(options), options.supersample, options.share);
}

/// Draws the coarse surfaces, without lines, which belong to other triangles.
void GlEditObject::draw_coarse(const ObjectViewOptions& options) {
    scene_->set_target_share(options.share);
    const PictureSize size = pixel_size(options);
    target_of(options).colors.bind();
    scene_->draw_coarse(camera_of(options.camera, surface_->sphere, size), size,
                        {0, 0, size.width, size.height}, shading_of(options));
    gl_->Disable(GL_DEPTH_TEST);
}

void GlEditObject::draw_pixels(const ObjectViewOptions& options) {
    const PictureSize size = pixel_size(options);
    target_of(options).colors.bind();
    scene_->draw_encoded(camera_of(options.camera, surface_->sphere, size), size,
                         {0, 0, size.width, size.height}, shading_of(options));
    gl_->Disable(GL_DEPTH_TEST);
}

void GlEditObject::encode(const ObjectViewOptions& options) {
    const GlShading shading = shading_of(options);
    const GlProgram& program = shading.tone_curve ? develop_ : encode_;
    (options.half ? small_ : shown_)->colors.bind();
    program.use();
    program.set("samples", 0);
    program.set("side", options.supersample);
    program.set("exposure", shading.exposure);
    program.set("background", Vec3f(background_linear()));
    bind_texture(*gl_, 0, samples_->colors.texture());
    pass_.draw();
    check_gl(*gl_, "drawing the object");
}

/// Draws the view, or the next part of it.
void GlEditObject::draw_view(const ObjectViewOptions& options) {
    if (is_coarse(options)) return draw_coarse(options);
    if (is_direct(options) && draw_places(options)) return;
    scene_->set_target_share(options.share);
    if (is_direct(options)) return draw_pixels(options);
    draw_samples(options);
    if (part_ == 0) encode(options);
}

const GlTexture* GlEditObject::draw(const ObjectViewOptions& options) {
    if (!scene_ || options.size.width <= 0 || options.size.height <= 0) return nullptr;
    drew_ = drawn_ != options;
    if (drew_) {
        make_targets(options);
        if (std::exchange(parted_, options) != options) part_ = 0;
        draw_view(options);
        drew_ = part_ == 0;
    } else {
        part_ = 0;
    }
    if (drew_) {
        drawn_ = seen_ = options;
        image_ = options.half ? &*small_ : &*shown_;
        pictured_ = true;
    }
    if (part_ == 0) parted_.reset();
    return &image_->colors.texture();
}

}  // namespace burl
