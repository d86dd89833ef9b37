#include "app/bench/economy.h"

#include <limits>
#include <memory>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "app/bench/meshes.h"
#include "app/pipeline/pipeline.h"
#include "app/surface/sample_meshes.h"

namespace burl {

namespace {

Recipe recipe_of(const std::string& name, std::uint32_t size) {
    return load_recipe(name, {fmt::format("atlas.size={}", size)});
}

/// Marble with its octaves as separate terms, which can be edited one by one.
Recipe four_terms(std::uint32_t size) {
    Recipe recipe = recipe_of("marble", size);
    std::vector<NoiseTerm>& noise = plain_texture(recipe.texture)->noise;
    NoiseTerm term = std::exchange(noise, {}).front();
    for (std::uint32_t k = std::exchange(term.octaves, 1); k-- > 0; ++term.seed) {
        noise.push_back(term);
        term.amplitude *= term.gain;
        term.frequency *= term.lacunarity;
    }
    return recipe;
}

/// A texture as an editor shows it, and the recipe set by the sliders.
struct Shown {
    Pipeline pipeline{torus(6000)};
    Recipe recipe;

    explicit Shown(std::uint32_t size) : recipe(four_terms(size)) {
        pipeline.set_cache(std::numeric_limits<std::size_t>::max());
        show();
    }
    void show() {
        pipeline.set_recipe(recipe);
        pipeline.picture<Rgb8>();
    }
};

struct Edit {
    std::string name;
    std::function<void(Recipe&)> move;
};

/// The edits; each undoes at every second call what it did at the call before.
std::vector<Edit> edits() {
    return {{"colour",
             [](Recipe& r) {
                 auto& stops = plain_texture(r.texture)->colors.stops;
                 std::swap(stops[1].color, stops[2].color);
             }},
            {"amplitude of 1 of 4 terms",
             [](Recipe& r) {
                 double& a = plain_texture(r.texture)->noise[3].amplitude;
                 a = a == 0.05 ? 0.0625 : 0.05;
             }},
            {"phase of 1 of 4 terms",
             [](Recipe& r) {
                 double& x = plain_texture(r.texture)->noise[3].phase.x;
                 // This octave never shares its coordinates with another.
                 x = x == 0.5 ? 0.25 : 0.5;
             }},
            {"camera", [](Recipe&) {}}};
}

/// Returns the work of the synthesis since `runs_before`; none where it did not run.
SynthesisWork work_since(const Pipeline& pipeline, std::uint64_t runs_before) {
    const StageRecord& record = pipeline.records()[Stage::synthesis];
    return record.runs == runs_before ? SynthesisWork{} : record.last.work;
}

}  // namespace

std::vector<EditBench> bench_edits(int repeats, std::uint32_t size) {
    const auto plain = std::make_shared<Pipeline>(torus(6000));
    plain->set_recipe(four_terms(size));
    plain->solid();
    const double texels = double(size) * double(size);
    auto work = std::make_shared<std::vector<SynthesisWork>>();
    std::vector<BenchCase> cases;
    const auto add = [&](const std::string& name, auto run) {
        const std::size_t k = cases.size();
        work->emplace_back();
        cases.push_back({name, texels, "texel", [run, work, k] { (*work)[k] = run(); }, "edits"});
    };
    add("whole texture", [plain] {
        plain->synthesize<Rgb8>();
        return plain->records()[Stage::synthesis].last.work;
    });
    for (const Edit& edit : edits()) {
        const auto shown = std::make_shared<Shown>(size);  // every case drags one slider only
        add(edit.name, [shown, move = edit.move] {
            const std::uint64_t runs = shown->pipeline.records()[Stage::synthesis].runs;
            move(shown->recipe);
            shown->show();
            return work_since(shown->pipeline, runs);
        });
    }
    std::vector<EditBench> rows;
    for (const BenchRow& row : run_paired(cases, repeats)) rows.push_back({row, {}});
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].work = (*work)[k];
    return rows;
}

double SparedOctaves::share(Skip skip) const {
    const std::uint64_t all =
        std::accumulate(work.octaves_skipped.begin(), work.octaves_skipped.end(), work.octaves);
    return all == 0 ? 0.0 : double(work.octaves_skipped[unsigned(skip)]) / double(all);
}

SparedOctaves spared_by_band_limit(const std::string& name, std::uint32_t size,
                                   std::uint32_t level) {
    Recipe recipe = recipe_of(name, size);
    recipe.filter.band_limit = true;
    Pipeline pipeline(sample_mesh("sample:teapot"));
    pipeline.set_recipe(recipe);
    SparedOctaves result{name, level};
    fill_texture<Rgb8>(pipeline.solid(level), recipe, {}, {{}, &result.work});
    return result;
}

}  // namespace burl
