#include "app/gl/fill/multipass_synthesize.h"

#include "app/base/stopwatch.h"
#include "procedural/maps/lattice_box.h"

namespace burl {

GlMultipassSynthesis::GlMultipassSynthesis(GlContext& context, const MultipassOptions& options,
                                           const GlSynthesisLimits& limits)
    : context_(&context),
      gl_(&context.gl()),
      options_(options),
      limits_(limits),
      float64_(limits.float64 && has_float64(*gl_)),
      full_screen_(*gl_),
      timer_(*gl_),
      maps_(*gl_, limits.map_budget),
      colors_(*gl_),
      passes_(*gl_, float64_) {}

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
void GlMultipassSynthesis::compile() {
    ShaderSource source = passes_.source();
    source.add("passes/field.glsl");
    add_output<Pixel>(colors_, source);
    std::string text = source.text();
    auto found = programs_.find(text);
    if (found == programs_.end())
        found =
            programs_
                .emplace(std::move(text), make_full_screen_program(*gl_, "the colour pass", source))
                .first;
    color_program_ = &found->second;
    passes_.compile();
}

template <class Pixel>
void GlMultipassSynthesis::draw_colors(const GlTile& tile) {
    const GlProgram& program = *color_program_;
    program.use();
    program.set("first", 0);
    bind_output<Pixel>(colors_, program, 1);
    bind_texture(*gl_, 0, passes_.image(PassImage::index).texture());
    target_->bind({{0, 0}, tile.size});
    full_screen_.draw();
}

/// Draws a tile of the texture into target_.
template <class Pixel>
void GlMultipassSynthesis::draw(const Quadric& quadric, const GlTile& tile) {
    const Maps maps = timed(work_.map, [&] { return maps_of(quadric, tile); });
    std::vector<const GlLatticeMap*> sources;
    for (const auto& map : maps) sources.push_back(map.get());
    passes_.set_plan(plan_, tile.size);
    timed(work_.compile, [&] { compile<Pixel>(); });
    const GLenum internal = GlOutput<Pixel>::internal;
    if (!target_ || target_->format().internal != internal || target_->size() != tile.size)
        target_.emplace(GlTarget(*gl_, tile.size, {internal}));
    timer_.start();
    passes_.run(sources, plan_.passes);
    draw_colors<Pixel>(tile);
    const GlSeconds seconds = timer_.stop();
    work_.draw += seconds.wall;
    work_.gpu += seconds.gpu;
    work_.passes += int(count_passes(plan_.passes)) + 1;
}

template <class Pixel>
void GlMultipassSynthesis::synthesize(const SolidAtlas& solid, const Texture& texture,
                                      const Affine3& texture_from_atlas, int threads,
                                      Image<Pixel>& image) {
    if (const std::string why = problem(texture); !why.empty())
        throw Error(ExitCode::unsupported, why);
    context_->make_current();
    work_ = {};
    if (image.width() != solid.size || image.height() != solid.size)
        image = Image<Pixel>::unset(solid.size, solid.size);
    make_plan(solid, texture, texture_from_atlas);
    maps_.set_atlas(solid, texture_from_atlas, threads);
    colors_.set_map(texture.colors);
    const int made = maps_.made();
    for_tiles({int(solid.size), int(solid.size)}, limits_.tile, [&](const GlTile& tile) {
        draw<Pixel>(texture.quadric, tile);
        timed(work_.transfer, [&] { read_back_.read(*target_, tile, threads, image); });
    });
    maps_.drop_unused();
    work_.maps = maps_.made() - made;
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
