#include "app/gl_graph.h"

#include "app/gl_source.h"
#include "app/stopwatch.h"

namespace burl {

namespace {

constexpr int first_table = 2, first_image = 4;  // texture units, after the point map's

}  // namespace

GlGraphSynthesis::GlGraphSynthesis(GlContext& context, const GlSynthesisLimits& limits)
    : context_(&context),
      gl_(&context.gl()),
      limits_(limits),
      float64_(limits.float64 && has_float64(*gl_)),
      full_screen_(*gl_),
      timer_(*gl_),
      colors_(*gl_),
      reals_(*gl_, float64_) {}

std::string GlGraphSynthesis::problem(const TextureGraph& graph, const Filter& filter) const {
    if (filter.kind != FilterKind::none && filter.kind != FilterKind::supersample)
        return "of the filters OpenGL has supersample alone for graphs";
    if (std::string why = no_graph_shader(graph); !why.empty()) return why;
    GLint units = 0;
    gl_->GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    if (first_image + int(graph.images.size()) <= units) return "";
    return fmt::format("it reads {} images, and shaders of this OpenGL only {}",
                       graph.images.size(), units - first_image);
}

template <class Pixel>
const GlProgram& GlGraphSynthesis::program(const GlslTexture& texture, bool supersampled) {
    constexpr std::size_t most_programs = 64;
    ShaderSource source;
    source.define_real(float64_);
    add_parts(source, texture.parts);
    source.add("real_bits.glsl");
    if (supersampled)
        source.add("texel_line.glsl").add("supersample.glsl").add("graph_samples.glsl");
    else
        source.add("point_texel.glsl");
    add_color_output<Pixel>(
        colors_, source, supersampled ? "mean_color(texel)" : "texture_color(solid_point(texel))");
    std::string text = source.text();
    if (const auto found = programs_.find(text); found != programs_.end()) return found->second;
    if (programs_.size() == most_programs) programs_.clear();
    GlProgram made =
        timed(work_.compile, [&] { return make_full_screen_program(*gl_, "a graph", source); });
    return programs_.emplace(std::move(text), std::move(made)).first->second;
}

/// The image's finest level, whose rows lie without gaps.
const GlTexture& GlGraphSynthesis::image_texture(const std::shared_ptr<const MipImage>& pixels) {
    for (const KeptImage& kept : images_)
        if (kept.pixels == pixels) return kept.texture;
    const Image<RgbF>& level = pixels->levels()[0];
    std::vector<Vec4f> texels;
    texels.reserve(level.pixels().size());
    for (const RgbF& c : level.pixels()) texels.emplace_back(c.r, c.g, c.b, 1.0f);
    images_.push_back(
        {pixels, make_texture<Vec4f>(*gl_, GL_RGBA32F, {int(level.width()), int(level.height())},
                                     std::span<const Vec4f>(texels))});
    return images_.back().texture;
}

template <class Pixel>
void GlGraphSynthesis::bind_inputs(const GlProgram& program, const GlslTexture& texture) {
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

/// For samples beside the texels' centres.
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

void GlGraphSynthesis::bind_samples(const GlProgram& program, int samples) const {
    lines_->bind(program, 0);
    const auto& [linear, offset] = texture_from_atlas_;
    reals_.set(program, "texture_from_atlas", std::array{linear[0], linear[1], linear[2], offset});
    bind_pattern(program, SamplePattern(samples));
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
    const bool supersampled = filter.kind == FilterKind::supersample;
    const GlslTexture texture = glsl_graph(graph, float64_ ? GlslReal::float64 : GlslReal::float32);
    const GlProgram& program = this->program<Pixel>(texture, supersampled);
    set_atlas(solid, texture_from_atlas, threads);
    // Before anything is bound: making a texture changes the bindings of a unit.
    for (const GlslImage& one : texture.images) image_texture(one.pixels);
    for_tiles({int(solid.size), int(solid.size)}, limits_.tile, [&](const GlTile& tile) {
        // Bindings last: whatever makes a texture changes them.
        const GlPointMap* map = supersampled ? nullptr : &points(tile);
        if (supersampled) set_lines(tile, threads);
        const GlTarget target(*gl_, tile.size, {GlOutput<Pixel>::internal});
        program.use();
        bind_inputs<Pixel>(program, texture);
        if (map)
            bind_points(program, *map);
        else
            bind_samples(program, filter.samples);
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
