#include "app/gl/draw/scene.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "app/gl/draw/view_texels.h"
#include "app/light/brdf.h"
#include "app/scene/shading.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

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
        lent_.push_back(nullptr);
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

void GlScene::lend_texture(int number, const GlTexture* lent) {
    lent_[std::size_t(number)] = lent;
}

void GlScene::set_material(const SceneMaterial& material) {
    for (GlSurface& surface : surfaces_) surface.set_material(material);
    for (GlSurface& surface : coarse_) surface.set_material(material);
}

void GlScene::set_target_share(double share) {
    for (GlSurface& surface : surfaces_) surface.set_target_share(share);
    for (GlSurface& surface : coarse_) surface.set_target_share(share);
}

void GlScene::clear(const SampleTile& tile, const Vec4f& color) const {
    gl_.Viewport(0, 0, tile.width, tile.height);
    gl_.ClearColor(color.x, color.y, color.z, color.w);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_.Enable(GL_DEPTH_TEST);
}

/// Binds a texture of the scene, or a white one for a negative number.
void GlScene::bind(GLenum unit, int number) const {
    gl_.ActiveTexture(unit);
    gl_.BindTexture(GL_TEXTURE_2D, (number < 0 ? white_ : texture(number)).get());
}

void GlScene::draw(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                   const GlShading& shading, const DrawPart& part) const {
    gl_.Viewport(0, 0, tile.width, tile.height);
    gl_.Enable(GL_DEPTH_TEST);
    draw_surfaces(TileView(camera, samples, tile), {}, shading, Drawn::solid, part);
}

bool GlScene::has_layers() const {
    return std::ranges::any_of(surfaces_,
                               [&](const GlSurface& one) { return draws(one, Drawn::layers); });
}

void GlScene::draw_layer(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                         const GlShading& shading, const GlLayerDepths& depths) const {
    clear(tile, Vec4f(0.0f));
    depths.bind();
    draw_surfaces(TileView(camera, samples, tile), {.blends = true, .layered = true}, shading,
                  Drawn::layers);
}

void GlScene::draw_blended(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                           const GlShading& shading) const {
    gl_.Viewport(0, 0, tile.width, tile.height);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthMask(GL_FALSE);
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.Enable(GL_CULL_FACE);
    gl_.FrontFace(GL_CW);  // rows are drawn top first
    for (const GLenum hidden : {GL_FRONT, GL_BACK}) {
        gl_.CullFace(hidden);
        draw_surfaces(TileView(camera, samples, tile), {.blends = true}, shading, Drawn::layers);
    }
    gl_.FrontFace(GL_CCW);
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_BLEND);
    gl_.DepthMask(GL_TRUE);
}

void GlScene::draw_encoded(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                           const GlShading& shading) const {
    clear(tile, background_codes());
    draw_surfaces(TileView(camera, samples, tile), {.encoded = true, .tone = shading.tone_curve},
                  shading, Drawn::all);
}

void GlScene::set_coarse(const std::vector<Surface>& surfaces, std::span<const Mat4d> frames) {
    coarse_.clear();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        GlSurface& made = coarse_.emplace_back(gl_, surfaces[i], frames[i]);
        made.set_material(surfaces_[i].material());
        made.upload(gl_, surfaces[i], std::numeric_limits<std::size_t>::max());
    }
}

bool GlScene::has_coarse() const {
    const auto is_opaque = [](const GlSurface& one) {
        return one.material().alpha == SceneAlpha::opaque;
    };
    return !coarse_.empty() && std::ranges::all_of(coarse_, is_opaque);
}

void GlScene::draw_coarse(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                          const GlShading& shading) const {
    clear(tile, background_codes());
    GlScenePrograms::Look look{.encoded = true, .coarse = true};
    look.tone = shading.tone_curve;
    look.lit = shading.lit;
    look.ambient = shading.light != nullptr;
    look.sun = shading.light && shading.light->has_sun();
    for (const GlSurface& surface : coarse_)
        draw_surface(surface, TileView(camera, samples, tile), look, shading);
    check_gl(gl_, "drawing coarsely");
}

Vec4f GlScene::background_codes() {
    return Vec4f(background_srgb.r, background_srgb.g, background_srgb.b, 255.0f) / 255.0f;
}

bool GlScene::has_places(bool in_environment) const {
    const auto shows = [&](const GlSurface& surface) {
        const SceneMaterial& material = surface.material();
        const bool linear = material.metallic == 0.0f && material.maps == no_material_maps;
        return material.texture >= 0 && material.texture == surfaces_.front().material().texture &&
               material.normals < 0 && material.factor == Vec4f(1.0f) &&
               material.alpha == SceneAlpha::opaque && has_levels(surface) &&
               !surface.in_blocks() && !surface.colored() && (linear || !in_environment);
    };
    return !surfaces_.empty() && std::ranges::all_of(surfaces_, shows);
}

void GlScene::draw_places(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                          const GlShading& shading, const DrawPart& part) const {
    gl_.Viewport(0, 0, tile.width, tile.height);
    gl_.Enable(GL_DEPTH_TEST);
    draw_surfaces(TileView(camera, samples, tile), {.places = true}, shading, Drawn::all, part);
}

bool GlScene::has_levels(const GlSurface& surface) const {
    for (std::size_t i = 0; i < filters_.size(); ++i)
        if (filters_[i] == TextureFilter::mip && surface.material().shows(int(i))) return true;
    return false;
}

bool GlScene::has_levels() const {
    return std::ranges::any_of(surfaces_, [&](const GlSurface& one) { return has_levels(one); });
}

bool GlScene::draws(const GlSurface& surface, Drawn drawn) const {
    const bool blends = surface.material().alpha == SceneAlpha::blend;
    return drawn == Drawn::all || blends == (drawn == Drawn::layers);
}

/// The properties of the surface's program, some of which `look` has already.
GlScenePrograms::Look GlScene::look_of(const GlSurface& surface, GlScenePrograms::Look look) const {
    const SceneMaterial& material = surface.material();
    look.masks = material.alpha == SceneAlpha::mask;
    look.bumped = surface.bumped();
    look.levels = has_levels(surface);
    look.in_blocks = look.levels && surface.in_blocks();
    look.anisotropic = look.levels && most_probes_ > 1;
    if (material.unlit) look.lit = false;
    look.ambient &= look.lit;
    look.sun &= look.ambient;
    if (!look.ambient) return look;
    look.clearcoat = material.clearcoat > 0.0f;
    look.sheen = material.sheen != Vec3f(0.0f);
    look.transmits = material.transmission > 0.0f;
    const int orm = material.map(MaterialMap::metallic_roughness);
    look.one_orm = orm >= 0 && orm == material.map(MaterialMap::occlusion);
    for (std::size_t i = 0; i < material.maps.size(); ++i)
        if (material.maps[i] >= 0) look.maps |= 1u << i;
    return look;
}

/// Binds the pictures of the material and sets its numbers, for the program in use.
void GlScene::bind_material(const GlProgram& program, const SceneMaterial& material) const {
    bind(GL_TEXTURE0 + base_color_unit, material.texture);
    bind(GL_TEXTURE0 + normal_map_unit, material.normals);
    for (std::size_t i = 0; i < material.maps.size(); ++i)
        if (material.maps[i] >= 0)
            bind(GLenum(GL_TEXTURE0 + first_map_unit + int(i)), material.maps[i]);
    program.set("most_probes", float(most_probes_));
    program.set("normal_scale", material.normal_scale);
    program.set("base_color_factor", material.factor);
    program.set("alpha_cutoff", material.alpha_cutoff);
    program.set("metallic", material.metallic);
    program.set("roughness", material.roughness);
    program.set("occlusion_strength", material.occlusion_strength);
    program.set("emissive", material.emissive);
    program.set("dielectric_f0", float(dielectric_f0(double(material.ior))));
    program.set("specular", material.specular);
    program.set("specular_color", material.specular_color);
    program.set("clearcoat", material.clearcoat);
    program.set("clearcoat_roughness", material.clearcoat_roughness);
    program.set("sheen", material.sheen);
    program.set("sheen_roughness", material.sheen_roughness);
    program.set("transmission", material.transmission);
}

/// Draws these surfaces; `look` holds the properties that depend on neither surface nor light.
void GlScene::draw_surfaces(const TileView& view, GlScenePrograms::Look look,
                            const GlShading& shading, Drawn drawn, const DrawPart& part) const {
    look.lit = shading.lit;
    look.ambient = shading.light != nullptr;
    look.sun = shading.light && shading.light->has_sun();
    for (const GlSurface& surface : surfaces_)
        if (draws(surface, drawn)) draw_surface(surface, view, look, shading, part);
    check_gl(gl_, "drawing");
}

void GlScene::draw_surface(const GlSurface& surface, const TileView& view,
                           const GlScenePrograms::Look& look, const GlShading& shading,
                           const DrawPart& part) const {
    const GlProgram& program = programs_->use(look_of(surface, look));
    if (shading.light) shading.light->use(program);
    program.set("exposure", shading.exposure);
    bind_material(program, surface.material());
    surface.draw(gl_, program, view, part);
}

void GlScene::draw_lookups(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                           int number, std::uint32_t size) const {
    clear(tile, Vec4f(0.0f, 0.0f, 0.0f, 1.0f));
    const GlProgram& lookups = programs_->use_lookups();
    lookups.set("texture_size", glm::vec2(float(size)));
    const TileView view(camera, samples, tile);
    int first_triangle = 0;
    for (const GlSurface& surface : surfaces_) {
        lookups.set("first_triangle", surface.material().shows(number) ? first_triangle : -1);
        surface.draw(gl_, lookups, view);
        first_triangle += surface.triangles();
    }
    check_gl(gl_, "drawing what is looked up");
}

}  // namespace burl
