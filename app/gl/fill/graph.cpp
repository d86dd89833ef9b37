#include "app/gl/fill/graph.h"

#include <algorithm>
#include <utility>

#include "app/base/stopwatch.h"
#include "app/gl/device/objects.h"
#include "procedural/glsl/functions.h"
#include "procedural/graph/noise_count.h"

namespace burl {

namespace {

constexpr int first_table = 2, first_image = 4;  // texture units after those of the point map

/// Whether the graph's nodes filter; otherwise texels are one sample or the mean of several.
bool nodes_filter(FilterKind kind) {
    return kind != FilterKind::none && kind != FilterKind::supersample;
}

/// A table of glsl_buffer_tables() as a buffer texture.
GlBufferTexture table_of(const GladGLContext& gl, const GlslTable& table, GlslReal real) {
    const std::vector<float> floats(table.numbers.begin(), table.numbers.end());
    if (real == GlslReal::float32) return {gl, GL_R32F, std::as_bytes(std::span(floats))};
    return {gl, GL_RG32UI, std::as_bytes(std::span(table.numbers))};
}

/// The fragment shader of a graph's text but for its last part, and the expression of a texel's
/// colour for that.
std::pair<ShaderSource, std::string> shader_of(const GlslTexture& texture, FilterKind kind,
                                               bool float64) {
    ShaderSource source;
    source.define_real(float64);
    const std::span parts(texture.parts);
    add_parts(source, parts.first(1));  // numbers/real.glsl
    source.add("tables",
               glsl_buffer_tables(texture.tables, float64 ? GlslReal::float64 : GlslReal::float32));
    add_parts(source, parts.subspan(1));
    source.add("numbers/real_bits.glsl");
    const char* color = "texture_color(solid_point(texel))";
    if (kind == FilterKind::none) {
        source.add("maps/point_texel.glsl");
    } else if (kind == FilterKind::supersample) {
        source.add("maps/texel_line.glsl").add("maps/supersample.glsl").add("graph/samples.glsl");
        color = "mean_color(texel)";
    } else {
        source.add("maps/texel_line.glsl").add("graph/footprint.glsl");
        color = "footprint_color(texel)";
    }
    return {std::move(source), color};
}

}  // namespace

GlGraphPass::GlGraphPass(const GladGLContext& gl, bool float64, std::size_t budget)
    : gl_(&gl), float64_(float64), colors_(gl), points_(gl, budget), lines_(gl, budget) {}

std::string GlGraphPass::problem(const TextureGraph& graph, const Filter& filter) const {
    std::string why =
        nodes_filter(filter.kind) ? no_filtered_shader(graph, filter) : no_graph_shader(graph);
    if (!why.empty()) return why;
    if (const std::size_t noises = graph_noises(graph, GraphOutput::planes);
        noises > most_shader_noises)
        return fmt::format("its graph evaluates {} noises for a texel, and OpenGL is given {}",
                           noises, most_shader_noises);
    GLint units = 0;
    gl_->GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    // Alpha is read from an image, or a table, of its own.
    std::ptrdiff_t reads = 0;
    for (const GraphImage& image : graph.images) reads += image.pixels->alpha() ? 2 : 1;
    for (const Texture& texture : graph.textures)
        if (texture.colors.stops.size() + 2 > most_compared_pieces)
            reads += is_opaque(texture.colors) ? 1 : 2;
    if (first_image + reads <= units) return "";
    return fmt::format(
        "it reads {} images and large colour maps, and shaders of this OpenGL only {}", reads,
        units - first_image);
}

/// The texture of an image with all its MIP levels, uploaded at its first use.
const GlTexture& GlGraphPass::image_texture(const std::shared_ptr<const MipImage>& pixels) {
    for (const KeptImage& kept : images_)
        if (kept.pixels == pixels) return kept.texture;
    std::vector<Vec4f> texels;
    for (std::size_t k = 0; k < pixels->level_count(); ++k) {
        const GlSize size(int(pixels->width(k)), int(pixels->height(k)));
        texels.clear();
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const RgbF c = pixels->texel(k, std::size_t(x), std::size_t(y));
                texels.emplace_back(c.r, c.g, c.b, 1.0f);
            }
        if (k == 0)
            images_.push_back({pixels, make_texture<Vec4f>(*gl_, GL_RGBA32F, size,
                                                           std::span<const Vec4f>(texels))});
        else
            gl_->TexImage2D(GL_TEXTURE_2D, GLint(k), GL_RGBA32F, size.x, size.y, 0, GL_RGBA,
                            GL_FLOAT, texels.data());
    }
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, GLint(pixels->level_count()) - 1);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    check_gl(*gl_, "making an image's levels");
    return images_.back().texture;
}

void GlGraphPass::set_atlas(const SolidAtlas& solid, const Affine3& texture_from_atlas, int threads,
                            const Filter& filter) {
    if (solid_ != &solid) forget_atlas();
    if (texture_from_atlas != texture_from_atlas_) points_.forget_atlas();
    solid_ = &solid;
    texture_from_atlas_ = texture_from_atlas;
    threads_ = threads;
    filter_ = filter;
    points_.set_atlas(solid, std::nullopt, threads);
}

/// Makes the textures that texture_ reads.
void GlGraphPass::make_inputs() {
    for (const GlslImage& image : texture_.images) image_texture(image.pixels);
    tables_.clear();
    for (const GlslTable& table : texture_.tables) tables_.push_back(table_of(*gl_, table, real()));
}

template <class Pixel>
ShaderSource GlGraphPass::set(const SolidAtlas& solid, const TextureGraph& graph,
                              const Affine3& texture_from_atlas, int threads,
                              const Filter& filter) {
    set_atlas(solid, texture_from_atlas, threads, filter);
    texture_ = nodes_filter(filter.kind) ? glsl_filtered_graph(graph, filter, real())
                                         : glsl_graph(graph, real());
    make_inputs();
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        if (!codes8_) codes8_.emplace(srgb8_table(*gl_));
    auto [source, color] = shader_of(texture_, filter.kind, float64_);
    add_color_output<Pixel>(colors_, source, color.c_str());
    return std::move(source);
}

ShaderSource GlGraphPass::set_material(
    const SolidAtlas& solid, const TextureGraph& graph, const TextureGraph& height,
    const Affine3& texture_from_atlas, const Filter& filter,
    const std::function<std::string(const std::string&)>& outputs) {
    set_atlas(solid, texture_from_atlas, 0, filter);
    texture_ = nodes_filter(filter.kind) ? glsl_filtered_graph(graph, filter, real())
                                         : glsl_material(graph, height, real());
    make_inputs();
    if (!codes8_) codes8_.emplace(srgb8_table(*gl_));
    auto [source, color] = shader_of(texture_, filter.kind, float64_);
    add_srgb8(source);
    source.add("outputs", outputs(color));
    return std::move(source);
}

std::shared_ptr<const GlPointMap> GlGraphPass::set_tile(const GlTile& tile) {
    if (filter_.kind == FilterKind::none) return points_.points(texture_from_atlas_, false, tile);
    if (!lines_known_) lines_.set_atlas(*solid_, solid_->maps, threads_);
    lines_known_ = true;
    lines_.set_tile(tile);
    return nullptr;
}

template <class Pixel>
void GlGraphPass::bind(const GlProgram& program, const GlPointMap* points) {
    if constexpr (std::is_same_v<Pixel, Rgb8>) codes8_->bind(program, "srgb8_buckets", first_table);
    if constexpr (std::is_same_v<Pixel, Rgb16>) colors_.bind_srgb16(program, first_table);
    int unit = first_image;
    for (const GlslImage& image : texture_.images)
        bind_texture(*gl_, program, image.uniform.c_str(), unit++, image_texture(image.pixels));
    for (std::size_t i = 0; i < tables_.size(); ++i)
        tables_[i].bind(program, texture_.tables[i].name.c_str(), unit++);
    if (points != nullptr) {
        bind_texture(*gl_, program, "point_xy", 0, points->xy());
        bind_texture(*gl_, program, "point_z_owner", 1, points->z_owner());
        return;
    }
    lines_.bind(program, 0);
    const auto& [linear, offset] = texture_from_atlas_;
    program.set_reals("texture_from_atlas", std::array{linear[0], linear[1], linear[2], offset},
                      float64_);
    if (filter_.kind == FilterKind::supersample)
        bind_pattern(program, SamplePattern(filter_.samples));
}

void GlGraphPass::finish() {
    images_.clear();
    tables_.clear();
    points_.drop_unused();
}

void GlGraphPass::forget_atlas() {
    points_.forget_atlas();
    lines_.forget_atlas();
    lines_known_ = false;
    solid_ = nullptr;
}

template ShaderSource GlGraphPass::set<Rgb8>(const SolidAtlas&, const TextureGraph&, const Affine3&,
                                             int, const Filter&);
template void GlGraphPass::bind<Rgb8>(const GlProgram&, const GlPointMap*);
template ShaderSource GlGraphPass::set<Rgb16>(const SolidAtlas&, const TextureGraph&,
                                              const Affine3&, int, const Filter&);
template void GlGraphPass::bind<Rgb16>(const GlProgram&, const GlPointMap*);
template ShaderSource GlGraphPass::set<RgbF>(const SolidAtlas&, const TextureGraph&, const Affine3&,
                                             int, const Filter&);
template void GlGraphPass::bind<RgbF>(const GlProgram&, const GlPointMap*);

}  // namespace burl
