// The suite `burl bench resynthesis`: the time of the next texture after an edit, with intermediate
// values cached, beside a synthesis from scratch.
#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "app/bench/command.h"
#include "app/bench/meshes.h"
#include "app/bench/synthesis.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/lattice_check.h"
#include "atlas/base/error.h"
#include "procedural/cache/synthesis.h"
#include "procedural/fill/synthesize.h"

namespace burl {

namespace {

/// A texture and the slider that edits it.
struct Edited {
    std::shared_ptr<Pipeline> pipeline;
    Affine3 map;
    Texture texture;
    CachedSynthesis kept;
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
                         synthesize_model<Rgb8>(pipeline->solid(), *plain_texture(recipe.texture),
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

Recipe load_plain(const std::string& name, const SynthesisSubjects& subjects) {
    Recipe recipe = sized_recipe(name, subjects.side, subjects.named);
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture || texture->noise.empty() || texture->colors.stops.empty() ||
        recipe.filter != Filter{} || recipe.precision.kind)
        throw Error(ExitCode::usage,
                    fmt::format("bench resynthesis: {} must be a colour map over a field with "
                                "noise, without filter or precision",
                                name));
    return recipe;
}

/// Measures textures on one thread in 8 bits; mesh, layout and spans are not timed. In every round
/// a case makes one edit of its kind to the texture of its round before, in which the recipe's
/// first noise term is split into one term per octave, and the last of these is edited. "From
/// scratch" is the recipe itself. Throws Error for recipes that cannot be read, and for graphs,
/// filters and precisions, for which nothing is cached.
std::vector<BenchResult> bench_resynthesis(int repeats, SynthesisSubjects subjects) {
    const auto pipeline =
        std::make_shared<Pipeline>(subjects.mesh ? std::move(*subjects.mesh) : torus(6000));
    std::vector<BenchResult> all;
    for (const std::string& name : subjects.recipes) {
        const Recipe recipe = load_plain(name, subjects);
        check_lattice(recipe, pipeline->mesh());
        pipeline->set_recipe(recipe);
        const std::string group = fmt::format("{}, {} x {}", name, subjects.side, subjects.side);
        for (const BenchRow& row : run_paired(cases_of(pipeline, group), repeats))
            all.push_back({row});
    }
    return all;
}

}  // namespace

void run_resynthesis_bench(const BenchCommand& command) {
    report_results(command, bench_resynthesis(command.repeats, subjects_of(command, 1024)));
}

}  // namespace burl
