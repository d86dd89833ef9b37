#include "app/gl/fill/graph.h"

#include <algorithm>

#include "app/base/stopwatch.h"
#include "app/gl/device/objects.h"
#include "procedural/glsl/color_pieces.h"

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

}  // namespace

GlGraphSynthesis::GlGraphSynthesis(GlContext& context, const GlSynthesisLimits& limits)
    : context_(&context),
      gl_(&context.gl()),
      limits_(limits),
      float64_(limits.float64 && has_float64(*gl_)),
      full_screen_(*gl_),
      timer_(*gl_),
      colors_(*gl_) {}

std::string GlGraphSynthesis::problem(const TextureGraph& graph, const Filter& filter) const {
    std::string why =
        nodes_filter(filter.kind) ? no_filtered_shader(graph, filter) : no_graph_shader(graph);
    if (!why.empty()) return why;
    GLint units = 0;
    gl_->GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    const auto has_table = [](const Texture& texture) {
        return texture.colors.stops.size() + 2 > most_compared_pieces;
    };
    const auto reads = std::ssize(graph.images) + std::ranges::count_if(graph.textures, has_table);
    if (first_image + reads <= units) return "";
    return fmt::format(
        "it reads {} images and large colour maps, and shaders of this OpenGL only {}", reads,
        units - first_image);
}

template <class Pixel>
const GlProgram& GlGraphSynthesis::program(const GlslTexture& texture, FilterKind kind) {
    constexpr std::size_t most_programs = 64;
    ShaderSource source;
    source.define_real(float64_);
    const std::span parts(texture.parts);
    add_parts(source, parts.first(1));  // numbers/real.glsl
    source.add("tables", glsl_buffer_tables(texture.tables, real()));
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
    add_color_output<Pixel>(colors_, source, color);
    std::string text = source.text();
    if (const auto found = programs_.find(text); found != programs_.end()) return found->second;
    if (programs_.size() == most_programs) programs_.clear();
    GlProgram made =
        timed(work_.compile, [&] { return make_full_screen_program(*gl_, "a graph", source); });
    return programs_.emplace(std::move(text), std::move(made)).first->second;
}

/// The texture of an image with all its MIP levels, uploaded at its first use.
const GlTexture& GlGraphSynthesis::image_texture(const std::shared_ptr<const MipImage>& pixels) {
    for (const KeptImage& kept : images_)
        if (kept.pixels == pixels) return kept.texture;
    const std::vector<Image<RgbF>>& levels = pixels->levels();
    std::vector<Vec4f> texels;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        texels.clear();
        for (const RgbF& c : levels[k].pixels()) texels.emplace_back(c.r, c.g, c.b, 1.0f);
        const GlSize size(int(levels[k].width()), int(levels[k].height()));
        if (k == 0)
            images_.push_back({pixels, make_texture<Vec4f>(*gl_, GL_RGBA32F, size,
                                                           std::span<const Vec4f>(texels))});
        else
            gl_->TexImage2D(GL_TEXTURE_2D, GLint(k), GL_RGBA32F, size.x, size.y, 0, GL_RGBA,
                            GL_FLOAT, texels.data());
    }
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, GLint(levels.size()) - 1);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    check_gl(*gl_, "making an image's levels");
    return images_.back().texture;
}

template <class Pixel>
void GlGraphSynthesis::bind_inputs(const GlProgram& program, const GlslTexture& texture,
                                   std::span<const GlBufferTexture> tables) {
    if constexpr (std::is_same_v<Pixel, Rgb8>) {
        if (!codes8_) codes8_.emplace(srgb8_table(*gl_));
        codes8_->bind(first_table);
        program.set("srgb8_buckets", first_table);
    }
    if constexpr (std::is_same_v<Pixel, Rgb16>) colors_.bind_srgb16(program, first_table);
    for (std::size_t i = 0; i < texture.images.size(); ++i) {
        const int unit = first_image + int(i);
        bind_texture(*gl_, unit, image_texture(texture.images[i].pixels));
        program.set(texture.images[i].uniform.c_str(), unit);
    }
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const int unit = first_image + int(texture.images.size() + i);
        tables[i].bind(unit);
        program.set(texture.tables[i].name.c_str(), unit);
    }
}

void GlGraphSynthesis::forget_atlas() {
    points_.clear();
    lines_.reset();
    mapper_.reset();
    solid_ = nullptr;
}

void GlGraphSynthesis::set_atlas(const SolidAtlas& solid, const Affine3& texture_from_atlas,
                                 int threads) {
    if (solid_ != &solid) {
        forget_atlas();
        mapper_.emplace(*gl_, solid, solid.maps, threads);
        solid_ = &solid;
    } else if (texture_from_atlas != texture_from_atlas_) {
        points_.clear();
    }
    texture_from_atlas_ = texture_from_atlas;
}

const GlPointMap& GlGraphSynthesis::points(const GlTile& tile) {
    std::size_t bytes = 0;
    for (const KeptPoints& kept : points_) {
        if (kept.tile == tile) return kept.points;
        bytes += 2 * sizeof(MapTexel) * kept.tile.texels();
    }
    if (!points_.empty() && bytes >= limits_.map_budget) points_.pop_back();
    ++work_.maps;
    points_.push_back({tile, timed(work_.map, [&] {
                           return mapper_->make_points(texture_from_atlas_, false, tile);
                       })});
    return points_.back().points;
}

/// Sets the tile of the spans that samples beside the texels' centres, and footprints, are computed
/// from.
void GlGraphSynthesis::set_lines(const GlTile& tile, int threads) {
    timed(work_.map, [&] {
        if (!lines_) {
            lines_.emplace(*gl_, limits_.map_budget);
            lines_->set_atlas(*solid_, solid_->maps, threads);
        }
        lines_->set_tile(tile);
    });
}

void GlGraphSynthesis::bind_points(const GlProgram& program, const GlPointMap& map) const {
    program.set("point_xy", 0);
    program.set("point_z_owner", 1);
    bind_texture(*gl_, 0, map.xy());
    bind_texture(*gl_, 1, map.z_owner());
}

void GlGraphSynthesis::bind_lines(const GlProgram& program, const Filter& filter) const {
    lines_->bind(program, 0);
    const auto& [linear, offset] = texture_from_atlas_;
    program.set_reals("texture_from_atlas", std::array{linear[0], linear[1], linear[2], offset},
                      float64_);
    if (filter.kind == FilterKind::supersample)
        bind_pattern(program, SamplePattern(filter.samples));
}

template <class Pixel>
void GlGraphSynthesis::synthesize(const SolidAtlas& solid, const TextureGraph& graph,
                                  const Affine3& texture_from_atlas, int threads,
                                  Image<Pixel>& image, const Filter& filter) {
    context_->make_current();
    if (const std::string why = problem(graph, filter); !why.empty())
        throw Error(ExitCode::unsupported, why);
    work_ = {};
    if (image.width() != solid.size || image.height() != solid.size)
        image = Image<Pixel>::unset(solid.size, solid.size);
    const bool points_only = filter.kind == FilterKind::none;
    const GlslTexture texture = nodes_filter(filter.kind)
                                    ? glsl_filtered_graph(graph, filter, real())
                                    : glsl_graph(graph, real());
    const GlProgram& program = this->program<Pixel>(texture, filter.kind);
    set_atlas(solid, texture_from_atlas, threads);
    // Textures are created before any is bound, since creating one changes the bindings of a unit.
    for (const GlslImage& one : texture.images) image_texture(one.pixels);
    std::vector<GlBufferTexture> tables;
    for (const GlslTable& table : texture.tables) tables.push_back(table_of(*gl_, table, real()));
    for_tiles({int(solid.size), int(solid.size)}, limits_.tile, [&](const GlTile& tile) {
        // Bindings come last, since creating a texture changes them.
        const GlPointMap* map = points_only ? &points(tile) : nullptr;
        if (!map) set_lines(tile, threads);
        const GlTarget target(*gl_, tile.size, {GlOutput<Pixel>::internal});
        program.use();
        bind_inputs<Pixel>(program, texture, tables);
        if (map)
            bind_points(program, *map);
        else
            bind_lines(program, filter);
        target.bind();
        timer_.start();
        full_screen_.draw();
        const GlSeconds drawn = timer_.stop();
        work_.draw += drawn.wall;
        work_.gpu += drawn.gpu;
        ++work_.passes;
        timed(work_.transfer, [&] { read_back_.read(target, tile, threads, image); });
    });
    images_.clear();
}

template void GlGraphSynthesis::synthesize(const SolidAtlas&, const TextureGraph&, const Affine3&,
                                           int, Image<Rgb8>&, const Filter&);
template void GlGraphSynthesis::synthesize(const SolidAtlas&, const TextureGraph&, const Affine3&,
                                           int, Image<Rgb16>&, const Filter&);
template void GlGraphSynthesis::synthesize(const SolidAtlas&, const TextureGraph&, const Affine3&,
                                           int, Image<RgbF>&, const Filter&);

}  // namespace burl
