#include "app/bench/resynthesis.h"

#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "app/bench/meshes.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/lattice_check.h"
#include "atlas/base/error.h"
#include "procedural/fill/synthesize.h"
#include "procedural/kept/kept.h"

namespace burl {

namespace {

/// Replaces the first term by one term per octave, in the same order; returns their number.
std::size_t take_apart(Texture& texture) {
    NoiseTerm term = texture.noise.front();
    texture.noise.erase(texture.noise.begin());
    std::vector<NoiseTerm> terms;
    for (std::uint32_t k = std::exchange(term.octaves, 1); k-- > 0;) {
        terms.push_back(term);
        term.seed += 1;
        term.amplitude *= term.gain;
        term.frequency *= term.lacunarity;
    }
    texture.noise.insert(texture.noise.begin(), terms.begin(), terms.end());
    return terms.size();
}

/// A texture and the slider that edits it.
struct Edited {
    std::shared_ptr<Pipeline> pipeline;
    Affine3 map;
    Texture texture;
    KeptSynthesis kept;
    Image<Rgb8> image;
    std::size_t octave;  ///< index of the edited term

    explicit Edited(std::shared_ptr<Pipeline> p)
        : pipeline(std::move(p)),
          map(texture_from_solid(pipeline->recipe())),
          texture(*plain_texture(pipeline->recipe().texture)),
          kept(pipeline->solid(), map, std::numeric_limits<std::size_t>::max()),
          octave(take_apart(texture) - 1) {}

    NoiseTerm& term() { return texture.noise[octave]; }
    void update() { kept.synthesize(texture, 1, image); }
};

/// Returns a case per kind of edit; each has a texture of its own, as a slider is dragged for a
/// while.
std::vector<BenchCase> cases_of(const std::shared_ptr<Pipeline>& pipeline,
                                const std::string& group) {
    const double texels = double(pipeline->solid().size) * pipeline->solid().size;
    std::vector<BenchCase> cases;
    const auto add = [&](const std::string& name, auto edit) {
        const auto e = std::make_shared<Edited>(pipeline);
        e->update();
        cases.push_back({name, texels, "texel",
                         [e, edit] {
                             edit(*e);
                             e->update();
                         },
                         group});
    };
    cases.push_back({"from scratch", texels, "texel",
                     [pipeline] {
                         const Recipe& recipe = pipeline->recipe();
                         synthesize_rgb8(pipeline->solid(), *plain_texture(recipe.texture),
                                         texture_from_solid(recipe), 1);
                     },
                     group});
    add("after a change of colours", [](Edited& e) {
        std::swap(e.texture.colors.stops.front().color, e.texture.colors.stops.back().color);
        e.texture.colors.stops.front().color.r ^= 1;
    });
    // Changes alternate between two values, and neither lets octaves leave their common
    // coordinates.
    const auto swap = [](double& x, double a, double b) { x = x == a ? b : a; };
    add("after a change of one octave's amplitude",
        [swap, first = Edited(pipeline).term().amplitude](Edited& e) {
            swap(e.term().amplitude, 0.9 * first, 0.8 * first);
        });
    add("after a change of the quadric", [swap, j = Edited(pipeline).texture.quadric.j](Edited& e) {
        swap(e.texture.quadric.j, j + 0.125, j);
    });
    add("after a change of one octave's frequency",
        [swap, first = Edited(pipeline).term().frequency.x](Edited& e) {
            swap(e.term().frequency.x, 1.01 * first, 1.02 * first);
        });
    return cases;
}

Recipe load_plain(const std::string& name, std::size_t side) {
    const Recipe recipe = load_recipe(name, {fmt::format("atlas.size={}", side)});
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture || texture->noise.empty() || texture->colors.stops.empty() ||
        recipe.filter != Filter{} || recipe.precision.kind)
        throw Error(ExitCode::usage,
                    fmt::format("bench resynthesis: {} must be a colour map over a field with "
                                "noise, without filter or precision",
                                name));
    return recipe;
}

}  // namespace

std::vector<BenchResult> bench_resynthesis(int repeats, SynthesisSubjects subjects) {
    const auto pipeline =
        std::make_shared<Pipeline>(subjects.mesh ? std::move(*subjects.mesh) : torus(6000));
    std::vector<BenchResult> all;
    for (const std::string& name : subjects.recipes) {
        const Recipe recipe = load_plain(name, subjects.side);
        check_lattice(recipe, pipeline->mesh());
        pipeline->set_recipe(recipe);
        const std::string group = fmt::format("{}, {} x {}", name, subjects.side, subjects.side);
        for (const BenchRow& row : run_paired(cases_of(pipeline, group), repeats))
            all.push_back({row});
    }
    return all;
}

}  // namespace burl
