#include "app/bench/synthesis.h"

#include <memory>
#include <numeric>

#include <fmt/format.h>

#include "app/bench/meshes.h"
#include "app/bench/values.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/lattice_check.h"

namespace burl {

namespace {

/// Channels of the texels that show the mesh, in linear light.
using Values = std::vector<double>;

/// A texture's cases and access to their results.
struct SynthesisSubject {
    std::shared_ptr<Pipeline> pipeline;
    std::string group;
    std::vector<BenchCase> cases;
    std::vector<std::function<Values()>> results;

    template <class Pixel>
    void add(const std::string& name, int threads) {
        auto image = std::make_shared<Image<Pixel>>();
        const double texels = double(pipeline->solid().size) * pipeline->solid().size;
        cases.push_back({name, texels, "texel",
                         [p = pipeline, image, threads] {
                             p->set_threads(threads);
                             *image = p->synthesize<Pixel>();
                         },
                         group});
        results.push_back([p = pipeline, image] { return color_values(p->solid(), *image); });
    }

    void add_definition() {
        auto values = std::make_shared<Values>();
        const double texels = double(pipeline->solid().size) * pipeline->solid().size;
        cases.push_back(
            {"float64 definition, 1 thread", texels, "texel",
             [p = pipeline, values] { *values = defined_colors(p->solid(), p->recipe()); }, group});
        results.push_back([values] { return *values; });
    }
};

/// Whether a bake should reproduce the texture's values at the texels' centres.
bool has_definition(const Recipe& recipe) {
    return recipe.filter == Filter{} && !recipe.precision.kind;
}

std::vector<BenchResult> bench_subject(const SynthesisSubject& subject, int repeats) {
    const std::vector<BenchRow> times = run_paired(subject.cases, repeats);
    const bool defined = has_definition(subject.pipeline->recipe());
    const Values reference = defined ? subject.results.back()() : Values();
    std::vector<BenchResult> results;
    for (std::size_t i = 0; i < times.size(); ++i) {
        results.push_back({times[i]});
        results.back().texels_per_span = mean_span(subject.pipeline->solid());
        if (defined) results.back().error = BenchError::of(subject.results[i](), reference);
    }
    return results;
}

}  // namespace

double mean_span(const SolidAtlas& solid) {
    const std::size_t texels =
        std::accumulate(solid.spans.begin(), solid.spans.end(), std::size_t{0},
                        [](std::size_t sum, const Span& span) { return sum + span.count; });
    return double(texels) / double(solid.spans.size());
}

std::vector<BenchResult> bench_synthesis(int repeats, SynthesisSubjects subjects) {
    const std::size_t side = subjects.side;
    const auto pipeline =
        std::make_shared<Pipeline>(subjects.mesh ? std::move(*subjects.mesh) : torus(6000));
    std::vector<BenchResult> all;
    for (const std::string& name : subjects.recipes) {
        const Recipe recipe = load_recipe(name, {fmt::format("atlas.size={}", side)});
        check_lattice(recipe, pipeline->mesh());
        pipeline->set_recipe(recipe);
        pipeline->solid();
        SynthesisSubject subject{pipeline, fmt::format("{}, {} x {}", name, side, side), {}, {}};
        subject.add<Rgb8>("sRGB 8 bits, 1 thread", 1);
        subject.add<Rgb8>("sRGB 8 bits, all threads", 0);
        subject.add<RgbF>("linear float, 1 thread", 1);
        if (has_definition(recipe)) subject.add_definition();
        const std::vector<BenchResult> results = bench_subject(subject, repeats);
        all.insert(all.end(), results.begin(), results.end());
    }
    return all;
}

}  // namespace burl
