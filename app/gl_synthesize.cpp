#include "app/gl_synthesize.h"

#include <chrono>

#include <fmt/format.h>

#include "app/gl_source.h"
#include "procedural/row_tasks.h"

namespace burl {

namespace {

/// What a kind of picture is drawn as: the target's format, the host's type of a texel, and the
/// shader's last part.
template <class Pixel>
struct Output;

template <>
struct Output<Rgb8> {
    static constexpr GLenum internal = GL_R32UI;
    using Component = std::uint32_t;
    static constexpr std::size_t components = 1;
    static constexpr const char* text =
        "layout(location = 0) out uint code;  // r + 2^8 g + 2^16 b\n"
        "void main() { code = color_code(field(ivec2(gl_FragCoord.xy))); }\n";
    static Rgb8 pixel(const Component* c) {
        return {std::uint8_t(*c), std::uint8_t(*c >> 8), std::uint8_t(*c >> 16)};
    }
};

template <>
struct Output<Rgb16> {
    static constexpr GLenum internal = GL_RG32UI;
    using Component = std::uint32_t;
    static constexpr std::size_t components = 2;
    static constexpr const char* text =
        "layout(location = 0) out uvec2 codes;  // r + 2^16 g, b\n"
        "void main() {\n"
        "    real3 c = linear_color(field(ivec2(gl_FragCoord.xy)));\n"
        "    codes = uvec2(srgb16(c.x) | srgb16(c.y) << 16, srgb16(c.z));\n"
        "}\n";
    static Rgb16 pixel(const Component* c) {
        return {std::uint16_t(c[0]), std::uint16_t(c[0] >> 16), std::uint16_t(c[1])};
    }
};

template <>
struct Output<RgbF> {
    static constexpr GLenum internal = GL_RGBA32F;
    using Component = float;
    static constexpr std::size_t components = 4;
    static constexpr const char* text =
        "layout(location = 0) out vec4 color;  // linear light\n"
        "void main() {\n"
        "    color = vec4(vec3(linear_color(field(ivec2(gl_FragCoord.xy)))), 1.0);\n"
        "}\n";
    static RgbF pixel(const Component* c) { return {c[0], c[1], c[2]}; }
};

template <>
struct Output<float> {
    static constexpr GLenum internal = GL_R32F;
    using Component = float;
    static constexpr std::size_t components = 1;
    static constexpr const char* text =
        "layout(location = 0) out float value;\n"
        "void main() {\n"
        "    real f = field(ivec2(gl_FragCoord.xy));\n"
        "    value = isnan(f) ? 0.0 : float(f);\n"
        "}\n";
    static float pixel(const Component* c) { return *c; }
};

/// Adds the seconds it lives to a sum.
class Stopwatch {
  public:
    explicit Stopwatch(double& sum) : sum_(sum) {}
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() {
        sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    double& sum_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <class Work>
auto timed(double& sum, const Work& work) {
    const Stopwatch stopwatch(sum);
    return work();
}

int texture_units(const GladGLContext& gl) {
    GLint units = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    return units;
}

/// Two maps a group, and the colours' tables.
int units_of(std::size_t groups) {
    return 2 * std::max(int(groups), 1) + 3;
}

}  // namespace

GlSynthesis::GlSynthesis(GlContext& context, const GlSynthesisLimits& limits)
    : context_(&context),
      gl_(&context.gl()),
      limits_(limits),
      float64_(limits.float64 && has_float64(*gl_) && gl_->Uniform1dv != nullptr),
      full_screen_(*gl_),
      timer_(*gl_),
      maps_(*gl_, limits.map_budget),
      colors_(*gl_) {}

std::string GlSynthesis::problem(const Texture& texture) const {
    const std::vector<Octave> octaves = expand_octaves(texture);
    if (std::string why = no_field_shader(octaves); !why.empty()) return why;
    const std::size_t groups = group_octaves(octaves).size();
    if (units_of(groups) <= texture_units(*gl_)) return "";
    return fmt::format(
        "its octaves lie in {} different lattices, for whose maps this OpenGL has too few texture "
        "units",
        groups);
}

const GlProgram& GlSynthesis::compiled(const ShaderSource& source) {
    constexpr std::size_t most_programs = 64;
    std::string text = source.text();
    if (const auto found = programs_.find(text); found != programs_.end()) return found->second;
    if (programs_.size() == most_programs) programs_.clear();
    GlProgram program = timed(
        work_.compile, [&] { return make_full_screen_program(*gl_, "the single pass", source); });
    return programs_.emplace(std::move(text), std::move(program)).first->second;
}

template <class Pixel>
const GlProgram& GlSynthesis::program(const FieldShape& shape) {
    ShaderSource source;
    source.define("BURL_FLOAT64", float64_ ? "1" : "0");
    for (const char* part :
         {"real.glsl", "noise_lattice.glsl", "real_bits.glsl", "stream_noise.glsl"})
        source.add(part);
    source.add("field", glsl_field(shape));
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        colors_.add_codes(source);
    else if constexpr (!std::is_same_v<Pixel, float>)
        colors_.add_linear(source);
    if constexpr (std::is_same_v<Pixel, Rgb16>) GlColorTables::add_srgb16(source);
    return compiled(source.add("main", Output<Pixel>::text));
}

template <class Pixel>
void GlSynthesis::bind_colors(const GlProgram& program, int first_unit) {
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        colors_.bind_codes(program, first_unit);
    else if constexpr (!std::is_same_v<Pixel, float>)
        colors_.bind_linear(program, first_unit);
    if constexpr (std::is_same_v<Pixel, Rgb16>) colors_.bind_srgb16(program, first_unit + 1);
}

const GlTarget& GlSynthesis::target(GLenum internal, GlSize size) {
    const bool fits = target_ && target_->format().internal == internal &&
                      target_->size().x >= size.x && target_->size().y >= size.y;
    if (!fits) target_.emplace(*gl_, size, {internal});
    return *target_;
}

/// A map for each group, the quadric in the first.
GlSynthesis::Maps GlSynthesis::maps_of(const Field& field, const GlTile& tile) {
    Maps maps;
    if (field.groups.empty()) maps.push_back(maps_.map(std::nullopt, field.quadric, tile));
    for (const OctaveGroup& group : field.groups) {
        const bool first = maps.empty();
        maps.push_back(maps_.map(stream_key(group),
                                 first ? std::optional(field.quadric) : std::nullopt, tile));
    }
    return maps;
}

void GlSynthesis::set_field(const GlProgram& program, const FieldUniforms& uniforms) const {
    const auto count = GLsizei(uniforms.seeds.size()), groups = GLsizei(uniforms.scales.size());
    const auto set_real = [&](const char* name, GLsizei n, const double* values) {
        const std::vector<float> floats(values, values + n);
        if (float64_)
            gl_->Uniform1dv(program.uniform(name), n, values);
        else
            gl_->Uniform1fv(program.uniform(name), n, floats.data());
    };
    set_real("constant", 1, &uniforms.constant);
    if (groups == 0) return;
    set_real("scales", groups, uniforms.scales.data());
    gl_->Uniform3uiv(program.uniform("seeds"), count, uniforms.seeds[0].data());
    gl_->Uniform1fv(program.uniform("weights"), count, uniforms.weights.data());
    gl_->Uniform1fv(program.uniform("radii"), groups, uniforms.radii.data());
}

template <class Pixel>
void GlSynthesis::read(const GlTarget& target, const GlTile& tile, int threads,
                       Image<Pixel>& image) {
    using Out = Output<Pixel>;
    using Component = typename Out::Component;
    const auto width = std::size_t(tile.size.x), height = std::size_t(tile.size.y);
    read_back_.resize(
        std::max(read_back_.size(), width * height * Out::components * sizeof(Component)));
    auto* texels = reinterpret_cast<Component*>(read_back_.data());
    target.read(std::span(texels, width * height * Out::components), {{0, 0}, tile.size});
    for_row_ranges(height, std::size_t(1) << 16, threads, [&](const RowRange& rows) {
        for (std::size_t y = rows.begin(); y != rows.end(); ++y) {
            Pixel* out = &image(std::size_t(tile.origin.x), std::size_t(tile.origin.y) + y);
            const Component* row = texels + y * width * Out::components;
            for (std::size_t x = 0; x < width; ++x) out[x] = Out::pixel(row + x * Out::components);
        }
    });
}

/// A tile of the picture, into target().
template <class Pixel>
void GlSynthesis::draw(const Field& field, const GlProgram& program, const GlTile& tile) {
    const Maps maps = timed(work_.map, [&] { return maps_of(field, tile); });
    program.use();
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const int unit = 2 * int(i);
        bind_texture(*gl_, unit, maps[i]->cells());
        bind_texture(*gl_, unit + 1, maps[i]->places());
        program.set(fmt::format("map_cells[{}]", i).c_str(), unit);
        program.set(fmt::format("map_places[{}]", i).c_str(), unit + 1);
    }
    bind_colors<Pixel>(program, 2 * int(maps.size()));
    set_field(program, field.uniforms);
    target(Output<Pixel>::internal, tile.size).bind({{0, 0}, tile.size});
    timer_.start();
    full_screen_.draw();
    const GlSeconds seconds = timer_.stop();
    work_.draw += seconds.wall;
    work_.gpu += seconds.gpu;
    ++work_.passes;
}

template <class Pixel>
void GlSynthesis::synthesize(const SolidAtlas& solid, const Texture& texture,
                             const Affine3& texture_from_atlas, int threads, Image<Pixel>& image) {
    if (const std::string why = problem(texture); !why.empty())
        throw Error(ExitCode::unsupported, why);
    context_->make_current();
    work_ = {};
    if (image.width() != solid.size || image.height() != solid.size)
        image = Image<Pixel>::unset(solid.size, solid.size);
    const std::vector<Octave> octaves = expand_octaves(texture);
    const std::vector<OctaveGroup> groups = group_octaves(octaves);
    const Field field{texture.quadric, groups, field_uniforms(groups, octaves)};
    maps_.set_atlas(solid, texture_from_atlas, threads);
    colors_.set_map(texture.colors);
    const GlProgram& program = this->program<Pixel>(field_shape(groups));
    const int made = maps_.made();
    for_tiles({int(solid.size), int(solid.size)}, limits_.tile, [&](const GlTile& tile) {
        draw<Pixel>(field, program, tile);
        timed(work_.transfer, [&] { return read(*target_, tile, threads, image); });
    });
    maps_.drop_unused();
    work_.maps = maps_.made() - made;
}

template void GlSynthesis::synthesize(const SolidAtlas&, const Texture&, const Affine3&, int,
                                      Image<Rgb8>&);
template void GlSynthesis::synthesize(const SolidAtlas&, const Texture&, const Affine3&, int,
                                      Image<Rgb16>&);
template void GlSynthesis::synthesize(const SolidAtlas&, const Texture&, const Affine3&, int,
                                      Image<RgbF>&);
template void GlSynthesis::synthesize(const SolidAtlas&, const Texture&, const Affine3&, int,
                                      Image<float>&);

}  // namespace burl
