#include "app/gl/fill/multipass.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "procedural/maps/lattice_box.h"

namespace burl {

namespace {

GLenum format_of_images(PassPrecision precision) {
    if (precision == PassPrecision::float16) return GL_RGBA16F;
    return precision == PassPrecision::fixed8 ? GL_RGBA8 : GL_RGBA32F;
}

/// The pass as a function NAME_pass() of shaders/passes.
std::string name_of(PassKind kind, bool integers) {
    if (kind == PassKind::copy && integers) return "copy_integers";
    return std::string(to_string(kind));
}

glm::uvec2 words_of(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return {std::uint32_t(bits), std::uint32_t(bits >> 32)};
}

glm::uvec3 vector_of(const std::array<std::uint32_t, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// How numbers of an image become codes from 0 to 1.
struct Shown {
    float scale = 1.0f, bias = 0.0f;
};

/// Images of signed numbers are shown about 1/2; the bytes of fixed8 hold them so already.
Shown shown_as(PassImage image, PassPrecision precision) {
    const bool is_signed = image == PassImage::corner || image == PassImage::noise ||
                           image == PassImage::sum || image == PassImage::mixed;
    return is_signed && precision != PassPrecision::fixed8 ? Shown{0.5f, 0.5f} : Shown{};
}

/// The passes up to the one that draws as number `count`, from 1 on; all where there are fewer.
std::span<const Pass> first_passes(std::span<const Pass> passes, std::size_t count) {
    std::size_t drawn = 0, end = 0;
    while (end < passes.size() && drawn < count)
        drawn += passes[end++].kind != PassKind::fill ? 1 : 0;
    return passes.first(end);
}

enum Unit { first_unit, second_unit, cells_unit, places_unit, tables_unit };

}  // namespace

GlMultipass::GlMultipass(const GladGLContext& gl, bool float64)
    : gl_(&gl), float64_(float64), full_screen_(gl) {}

void GlMultipass::set_plan(const MultipassPlan& plan, GlSize size) {
    plan_ = &plan;
    if (size != size_ || plan.options.precision != precision_) {
        images_.clear();
        spares_.clear();
    }
    size_ = size;
    precision_ = plan.options.precision;
    upload_tables();
}

/// Uploads each set of four tables as the channels of one row of texels.
void GlMultipass::upload_tables() {
    tables_.clear();
    for (const RandomTables& tables : plan_->tables) {
        std::array<Vec4f, pass_table_size> texels;
        for (std::size_t i = 0; i < pass_table_size; ++i)
            texels[i] = {tables[0][i], tables[1][i], tables[2][i], tables[3][i]};
        tables_.push_back(make_texture(*gl_, GL_RGBA32F, {int(pass_table_size), 1},
                                       std::span<const Vec4f>(texels)));
    }
}

ShaderSource GlMultipass::source() const {
    ShaderSource source;
    source.define_real(float64_)
        .define("FIXED8", precision_ == PassPrecision::fixed8 ? "1" : "0")
        .define("COLOR_REPEATS", plan_->wrap == Wrap::repeat ? "1" : "0");
    for (const char* part :
         {"numbers/real.glsl", "numbers/real_bits.glsl", "passes/multipass.glsl"})
        source.add(part);
    return source;
}

ShaderSource GlMultipass::pass_source(const std::string& name, bool integers) const {
    ShaderSource parts = source();
    if (name == "hash")
        parts.add("noise/lattice.glsl").add("passes/hash.glsl");
    else if (name == "field_index")
        parts.add("color/index.glsl").add("passes/field_index.glsl");
    else
        parts.add("passes/images.glsl");
    const std::string value = name + "_pass()";
    return parts.add(name, integers ? fmt::format("out uvec4 integers;\n"
                                                  "void main() {{ integers = {}; }}\n",
                                                  value)
                                    : fmt::format("out vec4 color;\n"
                                                  "void main() {{ color = stored({}); }}\n",
                                                  value));
}

void GlMultipass::compile() {
    for (const Pass& pass : plan_->passes)
        if (pass.kind != PassKind::fill)
            program(pass.kind, holds_integers(pass.target, precision_));
}

const GlProgram& GlMultipass::program(PassKind kind, bool integers) {
    const std::string name = name_of(kind, integers);
    std::string key = fmt::format("{} {} {}", name, int(precision_), int(plan_->wrap));
    auto found = programs_.find(key);
    if (found == programs_.end())
        found = programs_
                    .emplace(std::move(key), make_full_screen_program(*gl_, "the pass " + name,
                                                                      pass_source(name, integers)))
                    .first;
    return found->second;
}

GlTarget& GlMultipass::target(PassImage image) {
    const auto found = images_.find(image);
    if (found != images_.end()) return found->second;
    const GLenum format =
        holds_integers(image, precision_) ? GL_RGBA32UI : format_of_images(precision_);
    return images_.emplace(image, GlTarget(*gl_, size_, {format})).first->second;
}

GlTarget& GlMultipass::spare(bool integers) {
    const auto found = spares_.find(integers);
    if (found != spares_.end()) return found->second;
    const GLenum format = integers ? GL_RGBA32UI : format_of_images(precision_);
    return spares_.emplace(integers, GlTarget(*gl_, size_, {format})).first->second;
}

void GlMultipass::set_uniforms(const GlProgram& program, const Pass& pass) const {
    program.set("doublings", pass.doublings);
    program.set("axis", int(pass.axis));
    program.set("upper", int(pass.upper));
    program.set("wraps", int(pass.wraps));
    program.set("scale", pass.scale);
    program.set("bias", pass.bias);
    program.set("colors", glm::vec2(pass.colors[0], pass.colors[1]));
    program.set("seed", pass.seed);
    program.set("base_cell", vector_of(pass.bits.base));
    program.set("integer_bits", std::uint32_t(pass.bits.integer));
    program.set("cell_mask", pass.bits.mask());
    const glm::uvec2 constant = words_of(plan_->constant), amplitude = words_of(plan_->amplitude);
    gl_->Uniform2ui(program.uniform("constant"), constant.x, constant.y);
    gl_->Uniform2ui(program.uniform("amplitude"), amplitude.x, amplitude.y);
}

void GlMultipass::bind_sources(const GlProgram& program, const GlLatticeMap& map,
                               const Pass& pass) {
    program.set("first", first_unit);
    program.set("first_integers", first_unit);
    program.set("second", second_unit);
    program.set("map_cells", cells_unit);
    program.set("map_places", places_unit);
    program.set("tables", tables_unit);
    if (pass.first != PassImage::none) bind_texture(*gl_, first_unit, target(pass.first).texture());
    if (pass.second != PassImage::none)
        bind_texture(*gl_, second_unit, target(pass.second).texture());
    bind_texture(*gl_, cells_unit, map.cells());
    bind_texture(*gl_, places_unit, map.places());
    if (pass.table < tables_.size()) bind_texture(*gl_, tables_unit, tables_[pass.table]);
}

/// Runs a pass into a spare image, which then replaces the target, since a pass may read the image
/// it writes. A copy under a mask is drawn into the target itself and keeps its other channels.
void GlMultipass::run(std::span<const GlLatticeMap* const> maps, const Pass& pass) {
    const bool integers = holds_integers(pass.target, precision_);
    // Creating an image binds textures.
    GlTarget &drawn = target(pass.target), &free = spare(integers);
    if (pass.kind == PassKind::fill) {
        const float one = precision_ == PassPrecision::fixed8 ? 255.0f : 1.0f;
        return drawn.clear(0, Vec4f(pass.bias / one));
    }
    const GlProgram& draw = program(pass.kind, integers);
    draw.use();
    set_uniforms(draw, pass);
    bind_sources(draw, *maps[pass.stream], pass);
    if (pass.kind == PassKind::copy) {
        drawn.bind();
        gl_->ColorMask(pass.mask[0], pass.mask[1], pass.mask[2], GL_TRUE);
        full_screen_.draw();
        return gl_->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
    free.bind();
    full_screen_.draw();
    std::swap(drawn, free);
}

void GlMultipass::run(std::span<const GlLatticeMap* const> maps, std::span<const Pass> passes) {
    gl_->Disable(GL_BLEND);
    gl_->Disable(GL_DEPTH_TEST);
    for (const Pass& pass : passes) run(maps, pass);
    check_gl(*gl_, "drawing the passes of noise");
}

GlMultipassSynthesis::GlMultipassSynthesis(GlContext& context, const MultipassOptions& options,
                                           const GlSynthesisLimits& limits)
    : tiles_(context, limits),
      options_(options),
      maps_(context.gl(), limits.map_budget),
      colors_(context.gl()),
      passes_(context.gl(), tiles_.float64()) {}

std::string GlMultipassSynthesis::problem(const Texture& texture) const {
    return no_multipass_form(expand_octaves(texture), options_);
}

void GlMultipassSynthesis::make_plan(const SolidAtlas& solid, const Texture& texture,
                                     const Affine3& texture_from_atlas) {
    const std::vector<Octave> octaves = expand_octaves(texture);
    groups_ = group_octaves(octaves);
    std::vector<LatticeBox> boxes;
    if (options_.precision == PassPrecision::fixed8)
        for (const OctaveGroup& group : groups_)
            boxes.push_back(lattice_box(solid, group.lattice_from_solid.after(texture_from_atlas)));
    octaves_ = multipass_octaves(groups_, boxes);
    double constant = 0.0;
    for (const Octave& octave : octaves) constant += octave.offset;
    plan_ = plan_multipass(options_, octaves_, constant, texture.colors.wrap);
}

/// The lattice maps of a tile, one per group, with the quadric in the first.
GlMultipassSynthesis::Maps GlMultipassSynthesis::maps_of(const Quadric& quadric,
                                                         const GlTile& tile) {
    Maps maps;
    if (groups_.empty()) maps.push_back(maps_.map(std::nullopt, quadric, tile));
    for (const OctaveGroup& group : groups_)
        maps.push_back(maps_.map(stream_key(group),
                                 maps.empty() ? std::optional(quadric) : std::nullopt, tile));
    return maps;
}

template <class Pixel>
void GlMultipassSynthesis::synthesize(const SolidAtlas& solid, const Texture& texture,
                                      const Affine3& texture_from_atlas, int threads,
                                      Image<Pixel>& image) {
    tiles_.begin([&] { return problem(texture); });
    GlWork& work = tiles_.work();
    make_plan(solid, texture, texture_from_atlas);
    maps_.set_atlas(solid, texture_from_atlas, threads);
    colors_.set_map(texture.colors);
    const int made = maps_.made();
    const GlProgram* color_pass = nullptr;
    const auto ready = [&](const GlTile& tile) {
        Maps maps = timed(work.map, [&] { return maps_of(texture.quadric, tile); });
        passes_.set_plan(plan_, tile.size);
        timed(work.compile, [&] { passes_.compile(); });
        ShaderSource source = passes_.source();
        source.add("passes/field.glsl");
        add_output<Pixel>(colors_, source);
        color_pass = &tiles_.program("the colour pass", source);
        return maps;
    };
    const auto draw = [&](const Maps& maps, const GlTile& tile, const GlTarget& into) {
        std::vector<const GlLatticeMap*> sources;
        for (const auto& map : maps) sources.push_back(map.get());
        passes_.run(sources, plan_.passes);
        color_pass->use();
        bind_output<Pixel>(colors_, *color_pass, 1);
        bind_texture(tiles_.gl(), *color_pass, "first", 0,
                     passes_.image(PassImage::index).texture());
        into.bind({{0, 0}, tile.size});
        tiles_.full_screen().draw();
        return int(count_passes(plan_.passes)) + 1;
    };
    tiles_.fill(solid, threads, image, ready, draw);
    maps_.drop_unused();
    work.maps = maps_.made() - made;
}

/// Draws the image that a pass made.
void GlMultipassSynthesis::draw_image(const Pass& pass, const std::function<void()>& begin) {
    const bool integers = holds_integers(pass.target, options_.precision);
    ShaderSource source;
    source.define("INTEGERS", integers ? "1" : "0").add("passes/show.frag");
    const GlProgram& program = tiles_.program("the view of a pass", source);
    const Shown shown = shown_as(pass.target, options_.precision);
    bind_texture(tiles_.gl(), 0, passes_.image(pass.target).texture());
    begin();
    program.use();
    program.set("first", 0);
    program.set("scale", shown.scale);
    program.set("bias", shown.bias);
    tiles_.full_screen().draw();
}

/// Draws the colours of the index.
void GlMultipassSynthesis::draw_colors(const std::function<void()>& begin) {
    ShaderSource source = passes_.source();
    source.add("passes/field.glsl");
    colors_.add_codes(source);
    source.add("output",
               "layout(location = 0) out vec4 color;\n"
               "void main() {\n"
               "    uint code = color_code(field(ivec2(gl_FragCoord.xy)));\n"
               "    color = vec4(uvec4(code, code >> 8, code >> 16, 255u) & 255u) / 255.0;\n"
               "}\n");
    const GlProgram& program = tiles_.program("the colour pass", source);
    begin();
    program.use();
    colors_.bind_codes(program, 1);
    bind_texture(tiles_.gl(), program, "first", 0, passes_.image(PassImage::index).texture());
    tiles_.full_screen().draw();
}

std::optional<Pass> GlMultipassSynthesis::show(const SolidAtlas& solid, const Texture& texture,
                                               const Affine3& texture_from_atlas, std::size_t count,
                                               const std::function<void()>& begin) {
    tiles_.begin([&] { return problem(texture); });
    make_plan(solid, texture, texture_from_atlas);
    maps_.set_atlas(solid, texture_from_atlas, 0);
    colors_.set_map(texture.colors);
    const GlTile whole{{0, 0}, GlSize(int(solid.size))};
    const Maps maps = maps_of(texture.quadric, whole);
    std::vector<const GlLatticeMap*> sources;
    for (const auto& map : maps) sources.push_back(map.get());
    passes_.set_plan(plan_, whole.size);
    const std::span<const Pass> run = first_passes(plan_.passes, count);
    passes_.run(sources, run);
    maps_.drop_unused();
    const bool all = count > count_passes(plan_.passes);
    if (all)
        draw_colors(begin);
    else
        draw_image(run.back(), begin);
    check_gl(tiles_.gl(), "showing a pass");
    return all ? std::nullopt : std::optional(run.back());
}

template void GlMultipassSynthesis::synthesize(const SolidAtlas&, const Texture&, const Affine3&,
                                               int, Image<Rgb8>&);
template void GlMultipassSynthesis::synthesize(const SolidAtlas&, const Texture&, const Affine3&,
                                               int, Image<Rgb16>&);
template void GlMultipassSynthesis::synthesize(const SolidAtlas&, const Texture&, const Affine3&,
                                               int, Image<RgbF>&);
template void GlMultipassSynthesis::synthesize(const SolidAtlas&, const Texture&, const Affine3&,
                                               int, Image<float>&);

}  // namespace burl
