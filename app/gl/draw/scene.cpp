#include "app/gl/draw/scene.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "app/gl/draw/view_texels.h"
#include "app/scene/shading.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

const char* word(bool value) {
    return value ? "true" : "false";
}

/// A program of mesh.vert and a fragment shader.
GlProgram scene_program(const GladGLContext& gl, ShaderSource fragment) {
    return {gl, "the scene", ShaderSource().add("draw/mesh.vert"), fragment};
}

GLint wrap_mode(TextureWrap wrap) {
    switch (wrap) {
        case TextureWrap::repeat:
            return GL_REPEAT;
        case TextureWrap::mirror:
            return GL_MIRRORED_REPEAT;
        case TextureWrap::clamp:
            break;
    }
    return GL_CLAMP_TO_EDGE;
}

/// Uploads a level of the bound texture from rows without gaps.
void upload_level(const GladGLContext& gl, GLint level, const Image<Rgb8>& image, bool is_color) {
    gl.TexImage2D(GL_TEXTURE_2D, level, is_color ? GL_SRGB8 : GL_RGB8, GLsizei(image.width()),
                  GLsizei(image.height()), 0, GL_RGB, GL_UNSIGNED_BYTE, image.pixels().data());
}

/// Uploads a level with its alpha; an image without pixels stands for opaque.
void upload_level(const GladGLContext& gl, GLint level, const Image<Rgb8>& image,
                  const Image<Grey8>& alpha, bool is_color) {
    Image<Rgba8> both(image.width(), image.height());
    for (std::size_t y = 0; y < image.height(); ++y)
        for (std::size_t x = 0; x < image.width(); ++x) {
            const Rgb8& c = image(x, y);
            both(x, y) = {c.r, c.g, c.b, alpha.width() > 0 ? alpha(x, y) : std::uint8_t(255)};
        }
    gl.TexImage2D(GL_TEXTURE_2D, level, is_color ? GL_SRGB8_ALPHA8 : GL_RGBA8,
                  GLsizei(image.width()), GLsizei(image.height()), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  both.pixels().data());
}

/// Uploads level `number` of a texture: 0 is the image.
void upload_level(const GladGLContext& gl, const SceneTexture& texture, std::size_t number) {
    const Image<Rgb8>& image = number == 0 ? texture.image : texture.levels[number - 1];
    if (texture.alpha.width() == 0) return upload_level(gl, GLint(number), image, texture.is_color);
    upload_level(gl, GLint(number), image,
                 number == 0 ? texture.alpha : texture.alpha_levels[number - 1], texture.is_color);
}

/// Generates MIP levels by box means, and replaces them by the file's own levels as far as there
/// are any.
void upload_levels(const GladGLContext& gl, const SceneTexture& texture) {
    gl.GenerateMipmap(GL_TEXTURE_2D);
    for (std::size_t l = 1; l <= texture.levels.size(); ++l) upload_level(gl, texture, l);
}

void set_filter(const GladGLContext& gl, TextureFilter filter, const SceneTexture& texture) {
    const bool nearest = filter == TextureFilter::nearest;
    const bool mip = filter == TextureFilter::mip;
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                     nearest ? GL_NEAREST : (mip ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR));
    if (mip) upload_levels(gl, texture);
}

/// Uploads a texture. Colours become an sRGB texture, whose lookups decode each texel to linear
/// light before filtering. Throws Error(unsupported) where it is larger than OpenGL allows.
GlTexture upload(const GladGLContext& gl, const SceneTexture& texture, TextureFilter filter) {
    const Image<Rgb8>& image = texture.image;
    GLint limit = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (std::max(image.width(), image.height()) > std::size_t(limit)) {
        throw Error(ExitCode::unsupported,
                    fmt::format("the texture of {}x{} texels is larger than this OpenGL draws "
                                "({}); bake it at --size {} or less",
                                image.width(), image.height(), limit, limit));
    }
    GlTexture result(gl);
    gl.BindTexture(GL_TEXTURE_2D, result.get());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    upload_level(gl, texture, 0);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_mode(texture.wrap_u));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_mode(texture.wrap_v));
    set_filter(gl, filter, texture);
    check_gl(gl, fmt::format("uploading a texture of {}x{} texels", image.width(), image.height()));
    return result;
}

}  // namespace

const GlProgram& GlScenePrograms::use(const Look& look) {
    auto found = looks_.find(look);
    if (found == looks_.end()) {
        ShaderSource source;
        source.define("ENCODED", word(look.encoded)).define("LIT", word(look.lit));
        source.define("BUMPED", word(look.bumped)).define("LEVELS", word(look.levels));
        source.define("IN_BLOCKS", word(look.in_blocks)).define("PLACES", word(look.places));
        source.define("MASKS", word(look.masks)).define("BLENDS", word(look.blends));
        source.add("maps/footprint.glsl")
            .add("maps/level_size.glsl")
            .add("color/srgb_encode.glsl")
            .add("draw/mesh.frag");
        found = looks_.emplace(look, scene_program(gl_, source)).first;
    }
    const GlProgram& program = found->second;
    program.use();
    program.set("ambient", float(ambient));
    program.set("base_color", 0);
    program.set("normal_map", 1);
    program.set("nearer", GlLayerDepths::nearer_unit);
    program.set("farther", GlLayerDepths::farther_unit);
    return program;
}

const GlProgram& GlScenePrograms::use_lookups() {
    if (!lookups_)
        lookups_.emplace(scene_program(
            gl_, ShaderSource().add("maps/footprint.glsl").add("draw/mesh_lookups.frag")));
    lookups_->use();
    return *lookups_;
}

GlScene::GlScene(const GladGLContext& gl, const Scene& scene, std::optional<TextureFilter> filter)
    : gl_(gl), programs_(std::make_shared<GlScenePrograms>(gl)) {
    make_textures(scene, filter);
    for (const Surface& surface : scene.surfaces)
        surfaces_.emplace_back(gl, surface, unit_frame(surface));
    upload(scene, std::numeric_limits<std::size_t>::max());
}

GlScene::GlScene(const GladGLContext& gl, const Scene& scene,
                 std::shared_ptr<GlScenePrograms> programs, std::span<const Mat4d> frames)
    : gl_(gl), programs_(std::move(programs)) {
    make_textures(scene, std::nullopt);
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
        surfaces_.emplace_back(gl, scene.surfaces[i], frames[i]);
}

void GlScene::make_textures(const Scene& scene, std::optional<TextureFilter> filter) {
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        filters_.push_back(drawn_filter(scene, int(i), filter));
        textures_.push_back(burl::upload(gl_, scene.textures[i], filters_.back()));
    }
    white_ = burl::upload(gl_, {Image<Rgb8>(1, 1, {255, 255, 255})}, TextureFilter::nearest);
}

bool GlScene::upload(const Scene& scene, std::size_t bytes) {
    while (uploaded_ < surfaces_.size()) {
        const std::size_t all = std::numeric_limits<std::size_t>::max();
        if (!surfaces_[uploaded_].upload(gl_, scene.surfaces[uploaded_], bytes)) return false;
        ++uploaded_;
        if (bytes < all && uploaded_ < surfaces_.size()) return false;
    }
    return true;
}

void GlScene::set_texture(int number, const SceneTexture& texture) {
    const auto n = std::size_t(number);
    textures_[n] = burl::upload(gl_, texture, filters_[n]);
}

void GlScene::set_target_share(double share) {
    for (GlSurface& surface : surfaces_) surface.set_target_share(share);
}

void GlScene::clear(const SampleTile& tile, const Vec4f& color) const {
    gl_.Viewport(0, 0, tile.width, tile.height);
    gl_.ClearColor(color.x, color.y, color.z, color.w);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_.Enable(GL_DEPTH_TEST);
}

/// Binds a texture of the scene, or a white one for a negative number.
void GlScene::bind(GLenum unit, int number) const {
    const GlTexture& texture = number < 0 ? white_ : textures_[std::size_t(number)];
    gl_.ActiveTexture(unit);
    gl_.BindTexture(GL_TEXTURE_2D, texture.get());
}

void GlScene::draw(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                   bool lit) const {
    clear(tile, Vec4f(Vec3f(background_linear()), 1.0f));
    draw_surfaces(TileView(camera, samples, tile), {.lit = lit}, Drawn::solid);
}

bool GlScene::has_layers() const {
    return std::ranges::any_of(surfaces_,
                               [&](const GlSurface& one) { return draws(one, Drawn::layers); });
}

void GlScene::draw_layer(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                         bool lit, const GlLayerDepths& depths) const {
    clear(tile, Vec4f(0.0f));
    depths.bind();
    draw_surfaces(TileView(camera, samples, tile), {.lit = lit, .blends = true}, Drawn::layers);
}

void GlScene::draw_encoded(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                           bool lit) const {
    clear(tile, background_codes());
    draw_surfaces(TileView(camera, samples, tile), {.encoded = true, .lit = lit}, Drawn::all);
}

Vec4f GlScene::background_codes() {
    return Vec4f(background_srgb.r, background_srgb.g, background_srgb.b, 255.0f) / 255.0f;
}

bool GlScene::has_places() const {
    const auto shows = [&](const GlSurface& surface) {
        const SceneMaterial& material = surface.material();
        return material.texture >= 0 && material.texture == surfaces_.front().material().texture &&
               material.normals < 0 && material.factor == Vec4f(1.0f) && has_levels(surface) &&
               !surface.in_blocks() && !surface.colored();
    };
    return !surfaces_.empty() && std::ranges::all_of(surfaces_, shows);
}

void GlScene::draw_places(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                          bool lit) const {
    clear(tile, Vec4f(0.0f));
    draw_surfaces(TileView(camera, samples, tile), {.lit = lit, .places = true}, Drawn::all);
}

bool GlScene::has_levels(const GlSurface& surface) const {
    const auto has = [&](int number) {
        return number >= 0 && filters_[std::size_t(number)] == TextureFilter::mip;
    };
    return has(surface.material().texture) || has(surface.material().normals);
}

bool GlScene::draws(const GlSurface& surface, Drawn drawn) const {
    const bool blends = surface.material().alpha == SceneAlpha::blend;
    return drawn == Drawn::all || blends == (drawn == Drawn::layers);
}

/// Draws these surfaces; `look` holds the properties that do not depend on the surface.
void GlScene::draw_surfaces(const TileView& view, const GlScenePrograms::Look& look,
                            Drawn drawn) const {
    for (const GlSurface& surface : surfaces_) {
        if (!draws(surface, drawn)) continue;
        const SceneMaterial& material = surface.material();
        GlScenePrograms::Look own = look;
        own.masks = material.alpha == SceneAlpha::mask;
        own.bumped = surface.bumped();
        own.levels = has_levels(surface);
        own.in_blocks = own.levels && surface.in_blocks();
        const GlProgram& program = programs_->use(own);
        bind(GL_TEXTURE0, material.texture);
        bind(GL_TEXTURE1, material.normals);
        program.set("normal_scale", material.normal_scale);
        program.set("base_color_factor", material.factor);
        program.set("alpha_cutoff", material.alpha_cutoff);
        surface.draw(gl_, program, view);
    }
    check_gl(gl_, "drawing");
}

void GlScene::draw_lookups(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                           int number, std::uint32_t size) const {
    clear(tile, Vec4f(0.0f, 0.0f, 0.0f, 1.0f));
    const GlProgram& lookups = programs_->use_lookups();
    lookups.set("texture_size", glm::vec2(float(size)));
    const TileView view(camera, samples, tile);
    int first_triangle = 0;
    for (const GlSurface& surface : surfaces_) {
        const SceneMaterial& material = surface.material();
        const bool shows = material.texture == number || material.normals == number;
        lookups.set("first_triangle", shows ? first_triangle : -1);
        surface.draw(gl_, lookups, view);
        first_triangle += surface.triangles();
    }
    check_gl(gl_, "drawing what is looked up");
}

}  // namespace burl
