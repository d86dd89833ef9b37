#include "app/gl/fill/synthesize.h"

#include <fmt/format.h>

namespace burl {

namespace {

int texture_units(const GladGLContext& gl) {
    GLint units = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    return units;
}

bool is_plain(const Filter& filter) {
    return filter.kind == FilterKind::none && !filter.band_limit;
}

/// The texture units of a field without filter: two per map, and those of the colours' tables.
int units_of(const FieldShape& shape) {
    return 2 * int(shape.maps() + shape.lone.size()) + output_units;
}

}  // namespace

GlWork& GlWork::operator+=(const GlWork& more) {
    passes += more.passes, maps += more.maps;
    map += more.map, compile += more.compile, colors += more.colors;
    draw += more.draw, gpu += more.gpu, transfer += more.transfer;
    return *this;
}

GlTileLoop::GlTileLoop(GlContext& context, const GlSynthesisLimits& limits)
    : context_(&context),
      limits_(limits),
      float64_(limits.float64 && has_float64(context.gl())),
      full_screen_(context.gl()),
      timer_(context.gl()) {}

const GlProgram& GlTileLoop::program(const std::string& name, const ShaderSource& fragment) {
    std::string text = fragment.text();
    if (const auto found = programs_.find(text); found != programs_.end()) return found->second;
    GlProgram program =
        timed(work_.compile, [&] { return make_full_screen_program(gl(), name, fragment); });
    return programs_.emplace(std::move(text), std::move(program)).first->second;
}

/// A target of at least this size, kept from tile to tile.
const GlTarget& GlTileLoop::target(GLenum internal, GlSize size) {
    const bool fits = target_ && target_->format().internal == internal &&
                      target_->size().x >= size.x && target_->size().y >= size.y;
    if (!fits) target_.emplace(gl(), size, std::initializer_list<GLenum>{internal});
    return *target_;
}

GlSynthesis::GlSynthesis(GlContext& context, const GlSynthesisLimits& limits)
    : tiles_(context, limits),
      gl_(&context.gl()),
      budget_(limits.map_budget),
      float64_(tiles_.float64() && gl_->Uniform1dv != nullptr),
      maps_(*gl_, budget_),
      colors_(*gl_),
      graph_(*gl_, float64_, budget_) {}

void GlSynthesis::forget_atlas() {
    maps_.forget_atlas();
    if (filter_) filter_->forget_atlas();
    graph_.forget_atlas();
}

std::string GlSynthesis::problem(const Texture& texture, const Filter& filter) const {
    const FieldShape shape = FieldOctaves(texture).shape();
    if (std::string why = no_filter_shader(filter, texture.colors); !why.empty()) return why;
    const int more = is_plain(filter) ? 0 : GlMapFilter::units(shape);
    if (units_of(shape) + more <= texture_units(*gl_)) return "";
    return fmt::format(
        "its octaves lie in {} different lattices, for whose maps this OpenGL has too few texture "
        "units",
        shape.groups.size() + shape.lone.size());
}

template <class Pixel>
GlSynthesis::Programs GlSynthesis::programs(const FieldShape& shape, bool filtered) {
    ShaderSource colors;
    colors.define_real(float64_);
    ShaderSource means = colors;
    Programs result;
    if (!filtered || filter_->has_colors()) {
        if (filtered)
            filter_->add_field(colors, shape);
        else
            add_parts(colors, glsl_field(shape));
        timed(tiles_.work().colors, [&] { add_output<Pixel>(colors_, colors); });
        result.colors = &tiles_.program("the single pass", colors);
    }
    if (!filtered || !filter_->has_means()) return result;
    filter_->add_means(means, shape);
    if constexpr (!std::is_same_v<Pixel, float>) {
        if (filter_->means_read_colors()) colors_.add_linear(means);
        add_color_output<Pixel>(colors_, means, "mean_color(texel)");
    }
    result.means = &tiles_.program("the single pass", means);
    return result;
}

/// The maps of a tile, one per group, with the quadric in the first; and those of octaves without a
/// stream kernel.
GlSynthesis::Maps GlSynthesis::maps_of(const FieldOctaves& octaves, const Quadric& quadric,
                                       const GlTile& tile) {
    Maps maps;
    if (octaves.groups.empty()) maps.lattices.push_back(maps_.map(std::nullopt, quadric, tile));
    for (const OctaveGroup& group : octaves.groups) {
        const bool first = maps.lattices.empty();
        maps.lattices.push_back(
            maps_.map(stream_key(group), first ? std::optional(quadric) : std::nullopt, tile));
    }
    for (const Octave& octave : octaves.lone)
        maps.points.push_back(maps_.points(octave.lattice_from_solid, true, tile));
    return maps;
}

/// Binds the maps from unit 0 on and returns the first free unit.
int GlSynthesis::bind_maps(const GlProgram& program, const Maps& maps) const {
    int unit = 0;
    const auto bind = [&](const char* name, std::size_t i, const GlTexture& texture) {
        bind_texture(*gl_, program, fmt::format("{}[{}]", name, i).c_str(), unit++, texture);
    };
    for (std::size_t i = 0; i < maps.lattices.size(); ++i) {
        bind("map_cells", i, maps.lattices[i]->cells());
        bind("map_places", i, maps.lattices[i]->places());
    }
    for (std::size_t i = 0; i < maps.points.size(); ++i) {
        bind("lone_xy", i, maps.points[i]->xy());
        bind("lone_z", i, maps.points[i]->z_owner());
    }
    return unit;
}

void GlSynthesis::set_field(const GlProgram& program, const FieldUniforms& uniforms) const {
    const auto set_float = [&](const char* name, const std::vector<float>& values) {
        gl_->Uniform1fv(program.uniform(name), GLsizei(values.size()), values.data());
    };
    program.set_reals("constant", std::span(&uniforms.constant, 1), float64_);
    if (!uniforms.seeds.empty()) {
        program.set_reals("scales", uniforms.scales, float64_);
        gl_->Uniform3uiv(program.uniform("seeds"), GLsizei(uniforms.seeds.size()),
                         uniforms.seeds[0].data());
        set_float("weights", uniforms.weights);
        set_float("radii", uniforms.radii);
    }
    if (uniforms.lone_seeds.empty()) return;
    gl_->Uniform1uiv(program.uniform("lone_seeds"), GLsizei(uniforms.lone_seeds.size()),
                     uniforms.lone_seeds.data());
    program.set_reals("lone_times", uniforms.lone_times, float64_);
    program.set_reals("lone_scales", uniforms.lone_scales, float64_);
}

/// Makes a program current and sets its textures and uniforms.
template <class Pixel>
void GlSynthesis::set_up(const FieldOctaves& octaves, const Maps& maps, const GlProgram& program,
                         bool filtered, bool means) {
    program.use();
    const int unit = bind_maps(program, maps);
    if (!means)
        bind_output<Pixel>(colors_, program, unit);
    else
        bind_color_output<Pixel>(colors_, program, unit, filter_->means_read_colors());
    if (filtered) filter_->bind(program, unit + output_units);
    program.set("map_scale", 1.0f / glm::vec2(maps.lattices[0]->size()));
    set_field(program, octaves.uniforms());
}

template <class Pixel>
void GlSynthesis::synthesize(const SolidAtlas& solid, const Texture& texture,
                             const Affine3& texture_from_atlas, int threads, Image<Pixel>& image,
                             const Filter& filter) {
    tiles_.begin([&] { return problem(texture, filter); });
    GlWork& work = tiles_.work();
    const FieldOctaves octaves(texture);
    const bool filtered = !is_plain(filter) && !std::is_same_v<Pixel, float>;
    maps_.set_atlas(solid, texture_from_atlas, threads);
    colors_.set_map(texture.colors);
    if (filtered) {
        if (!filter_) filter_.emplace(*gl_, float64_, budget_ / 2);
        filter_->set_atlas(solid, texture_from_atlas, threads);
        filter_->set_map(texture.colors, filter);
        timed(work.map, [&] { filter_->set_field(octaves, texture.quadric); });
    }
    const Programs programs = this->programs<Pixel>(octaves.shape(), filtered);
    const bool both = programs.colors && programs.means;
    const int made = maps_.made();
    const auto ready = [&](const GlTile& tile) {
        Maps maps = timed(work.map, [&] {
            if (filtered) filter_->set_tile(tile);
            return maps_of(octaves, texture.quadric, tile);
        });
        // Bindings come last, since creating a texture changes them.
        if (programs.means) set_up<Pixel>(octaves, maps, *programs.means, filtered, true);
        if (programs.colors) set_up<Pixel>(octaves, maps, *programs.colors, filtered, false);
        return maps;
    };
    const auto draw = [&](const Maps&, const GlTile&, const GlTarget& into) {
        if (both)
            filter_->draw(tiles_.full_screen(), into.size(), *programs.colors, *programs.means);
        else
            tiles_.full_screen().draw();
        return both ? 2 : 1;
    };
    tiles_.fill(solid, threads, image, ready, draw);
    maps_.drop_unused();
    work.maps = maps_.made() - made;
}

template <class Pixel>
void GlSynthesis::synthesize(const SolidAtlas& solid, const TextureGraph& graph,
                             const Affine3& texture_from_atlas, int threads, Image<Pixel>& image,
                             const Filter& filter) {
    tiles_.begin([&] { return problem(graph, filter); });
    GlWork& work = tiles_.work();
    const GlProgram& program = tiles_.program(
        "a graph", graph_.set<Pixel>(solid, graph, texture_from_atlas, threads, filter));
    const int made = graph_.made();
    const auto ready = [&](const GlTile& tile) {
        auto points = timed(work.map, [&] { return graph_.set_tile(tile); });
        program.use();
        graph_.bind<Pixel>(program, points.get());
        return points;
    };
    tiles_.fill(solid, threads, image, ready, [&](const auto&, const GlTile&, const GlTarget&) {
        tiles_.full_screen().draw();
        return 1;
    });
    graph_.finish();
    work.maps = graph_.made() - made;
}

template void GlSynthesis::synthesize(const SolidAtlas&, const Texture&, const Affine3&, int,
                                      Image<Rgb8>&, const Filter&);
template void GlSynthesis::synthesize(const SolidAtlas&, const Texture&, const Affine3&, int,
                                      Image<Rgb16>&, const Filter&);
template void GlSynthesis::synthesize(const SolidAtlas&, const Texture&, const Affine3&, int,
                                      Image<RgbF>&, const Filter&);
template void GlSynthesis::synthesize(const SolidAtlas&, const Texture&, const Affine3&, int,
                                      Image<float>&, const Filter&);
template void GlSynthesis::synthesize(const SolidAtlas&, const TextureGraph&, const Affine3&, int,
                                      Image<Rgb8>&, const Filter&);
template void GlSynthesis::synthesize(const SolidAtlas&, const TextureGraph&, const Affine3&, int,
                                      Image<Rgb16>&, const Filter&);
template void GlSynthesis::synthesize(const SolidAtlas&, const TextureGraph&, const Affine3&, int,
                                      Image<RgbF>&, const Filter&);

}  // namespace burl
