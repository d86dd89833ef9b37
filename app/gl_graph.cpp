#include "app/gl_graph.h"

#include "app/gl_source.h"
#include "app/stopwatch.h"
#include "procedural/srgb_kernels.h"

namespace burl {

namespace {

/// The last part of the shader; targets and pixels are those of GlOutput.
template <class Pixel>
constexpr const char* graph_main = "";

template <>
constexpr const char* graph_main<Rgb8> =
    "layout(location = 0) out uint codes;  // r + 2^8 g + 2^16 b\n"
    "void main() {\n"
    "    real3 c = texture_color(solid_point(ivec2(gl_FragCoord.xy)));\n"
    "    codes = srgb8(c.r) | srgb8(c.g) << 8 | srgb8(c.b) << 16;\n"
    "}\n";

template <>
constexpr const char* graph_main<Rgb16> =
    "layout(location = 0) out uvec2 codes;  // r + 2^16 g, b\n"
    "void main() {\n"
    "    real3 c = texture_color(solid_point(ivec2(gl_FragCoord.xy)));\n"
    "    codes = uvec2(srgb16(c.r) | srgb16(c.g) << 16, srgb16(c.b));\n"
    "}\n";

template <>
constexpr const char* graph_main<RgbF> =
    "layout(location = 0) out vec4 color;  // linear light\n"
    "void main() {\n"
    "    color = vec4(vec3(texture_color(solid_point(ivec2(gl_FragCoord.xy)))), 1.0);\n"
    "}\n";

constexpr int first_table = 2, first_image = 4;  // texture units, after the point map's

}  // namespace

GlGraphSynthesis::GlGraphSynthesis(GlContext& context, const GlSynthesisLimits& limits)
    : context_(&context),
      gl_(&context.gl()),
      limits_(limits),
      float64_(limits.float64 && has_float64(*gl_)),
      full_screen_(*gl_),
      timer_(*gl_),
      colors_(*gl_) {}

std::string GlGraphSynthesis::problem(const TextureGraph& graph) const {
    if (std::string why = no_graph_shader(graph); !why.empty()) return why;
    GLint units = 0;
    gl_->GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    if (first_image + int(graph.images.size()) <= units) return "";
    return fmt::format("it reads {} images, and shaders of this OpenGL only {}",
                       graph.images.size(), units - first_image);
}

template <class Pixel>
const GlProgram& GlGraphSynthesis::program(const GlslTexture& texture) {
    constexpr std::size_t most_programs = 64;
    ShaderSource source;
    source.define_real(float64_);
    for (const GlslPart& part : texture.parts) {
        if (part.text.empty())
            source.add(part.name);
        else
            source.add(part.name, part.text);
    }
    source.add("real_bits.glsl").add("point_texel.glsl");
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        source.define("SRGB8_BUCKETS", fmt::format("{}.0", SrgbStreamEncoder::bucket_count))
            .add("srgb8.glsl");
    if constexpr (std::is_same_v<Pixel, Rgb16>) colors_.add_srgb16(source);
    source.add("main", graph_main<Pixel>);
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
    for (const RgbF& c : level.pixels()) texels.emplace_back(c.r, c.g, c.b, 1.0f);
    images_.push_back(
        {pixels, make_texture<Vec4f>(*gl_, GL_RGBA32F, {int(level.width()), int(level.height())},
                                     std::span<const Vec4f>(texels))});
    return images_.back().texture;
}

template <class Pixel>
void GlGraphSynthesis::bind_inputs(const GlProgram& program, const GlslTexture& texture) {
    program.set("point_xy", 0);
    program.set("point_z_owner", 1);
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
        if (kept.tile.origin == tile.origin && kept.tile.size == tile.size) return kept.points;
        bytes +=
            2 * sizeof(MapTexel) * std::size_t(kept.tile.size.x) * std::size_t(kept.tile.size.y);
    }
    if (bytes >= limits_.map_budget) points_.pop_back();
    ++work_.maps;
    points_.push_back({tile, timed(work_.map, [&] {
                           return mapper_->make_points(texture_from_atlas_, false, tile);
                       })});
    return points_.back().points;
}

template <class Pixel>
void GlGraphSynthesis::synthesize(const SolidAtlas& solid, const TextureGraph& graph,
                                  const Affine3& texture_from_atlas, int threads,
                                  Image<Pixel>& image) {
    context_->make_current();
    if (const std::string why = problem(graph); !why.empty())
        throw Error(ExitCode::unsupported, why);
    work_ = {};
    if (image.width() != solid.size || image.height() != solid.size)
        image = Image<Pixel>::unset(solid.size, solid.size);
    const GlslTexture texture = glsl_graph(graph, float64_ ? GlslReal::float64 : GlslReal::float32);
    const GlProgram& program = this->program<Pixel>(texture);
    set_atlas(solid, texture_from_atlas, threads);
    for_tiles({int(solid.size), int(solid.size)}, limits_.tile, [&](const GlTile& tile) {
        const GlPointMap& map = points(tile);
        const GlTarget target(*gl_, tile.size, {GlOutput<Pixel>::internal});
        program.use();
        bind_inputs<Pixel>(program, texture);
        bind_texture(*gl_, 0, map.xy());
        bind_texture(*gl_, 1, map.z_owner());
        target.bind();
        timer_.start();
        full_screen_.draw();
        const GlSeconds drawn = timer_.stop();
        work_.draw += drawn.wall;
        work_.gpu += drawn.gpu;
        ++work_.passes;
        timed(work_.transfer, [&] {
            read_back_.read(target, tile, threads, image);
            return true;
        });
    });
    images_.clear();
}

template void GlGraphSynthesis::synthesize(const SolidAtlas&, const TextureGraph&, const Affine3&,
                                           int, Image<Rgb8>&);
template void GlGraphSynthesis::synthesize(const SolidAtlas&, const TextureGraph&, const Affine3&,
                                           int, Image<Rgb16>&);
template void GlGraphSynthesis::synthesize(const SolidAtlas&, const TextureGraph&, const Affine3&,
                                           int, Image<RgbF>&);

}  // namespace burl
