#include "app/bench/synthesis.h"

#include <memory>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "app/bench/command.h"
#include "app/bench/meshes.h"
#include "app/options/command_options.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/images.h"
#include "app/recipe/lattice_check.h"
#include "procedural/color/srgb.h"
#include "procedural/color/table.h"
#include "procedural/graph/evaluator.h"
#include "procedural/model/octaves.h"

namespace burl {

namespace {

/// Channels of the texels that show the mesh, in linear light.
using Values = std::vector<double>;

template <class Visit>
void for_each_texel(const SolidAtlas& solid, std::uint32_t step, const Visit& visit) {
    for (std::uint32_t y = 0; y < solid.size; y += step)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                visit(solid.maps[span.map], x, y);
}

void append(const Vec3d& color, Values& values) {
    values.insert(values.end(), {color.x, color.y, color.z});
}

/// Returns the values of a graph in float64.
Values defined_graph(const SolidAtlas& solid, const Recipe& recipe, std::uint32_t step) {
    const GraphEvaluator evaluate(recipe.texture);
    GraphEvaluator::Scratch scratch = evaluate.make_scratch();
    const Affine3 from_solid = texture_from_solid(recipe);
    std::vector<Vec3d> points;
    Values values;
    const auto flush = [&] {
        std::vector<GraphSample> samples(points.size());
        evaluate(points, {}, scratch, samples);
        for (const GraphSample& sample : samples) append(sample.color(), values);
        points.clear();
    };
    for_each_texel(solid, step, [&](const TexelMap& texel, std::uint32_t x, std::uint32_t y) {
        points.push_back(from_solid(texel(x, y)));
        if (points.size() == graph_batch_size) flush();
    });
    flush();
    return values;
}

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

std::vector<double> color_values(const SolidAtlas& solid, const Image<Rgb8>& image,
                                 std::uint32_t step) {
    Values values;
    for_each_texel(solid, step, [&](const TexelMap&, std::uint32_t x, std::uint32_t y) {
        append(linear_light(image(x, y)), values);
    });
    return values;
}

std::vector<double> color_values(const SolidAtlas& solid, const Image<RgbF>& image,
                                 std::uint32_t step) {
    Values values;
    for_each_texel(solid, step, [&](const TexelMap&, std::uint32_t x, std::uint32_t y) {
        const RgbF& c = image(x, y);
        append({c.r, c.g, c.b}, values);
    });
    return values;
}

std::vector<double> defined_colors(const SolidAtlas& solid, const Recipe& recipe,
                                   std::uint32_t step) {
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture) return defined_graph(solid, recipe, step);
    const std::vector<Octave> octaves = expand_octaves(*texture);
    const PreparedColorMap map(texture->colors);
    const Affine3 from_solid = texture_from_solid(recipe);
    Values values;
    for_each_texel(solid, step, [&](const TexelMap& texel, std::uint32_t x, std::uint32_t y) {
        append(map(evaluate_field(texture->quadric, octaves, from_solid(texel(x, y)))), values);
    });
    return values;
}

Recipe sized_recipe(const std::string& name, std::size_t side, NamedFiles named) {
    RecipeImages images(ImageLimits{.named = named});
    return load_recipe(name, {fmt::format("atlas.size={}", side)}, images);
}

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
        const Recipe recipe = sized_recipe(name, side, subjects.named);
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

SynthesisSubjects subjects_of(const BenchCommand& command, std::size_t usual_side) {
    SynthesisSubjects subjects;
    if (!command.recipes.empty()) subjects.recipes = command.recipes;
    subjects.side = command.size_or(usual_side);
    subjects.named = command.named;
    if (!command.file.empty()) subjects.mesh = MeshOptions{}.load(command.file);
    return subjects;
}

void run_synthesis_bench(const BenchCommand& command) {
    report_results(command, bench_synthesis(command.repeats, subjects_of(command, 1024)));
}

}  // namespace burl
