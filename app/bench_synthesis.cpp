#include "app/bench_synthesis.h"

#include <memory>
#include <numeric>

#include <fmt/format.h>

#include "app/bench_meshes.h"
#include "app/lattice_check.h"
#include "app/pipeline.h"
#include "procedural/color_table.h"
#include "procedural/graph_evaluator.h"
#include "procedural/octaves.h"
#include "procedural/srgb.h"

namespace burl {

namespace {

/// Channels of the texels that show the mesh, in linear light.
using Values = std::vector<double>;

template <class Visit>
void for_each_texel(const SolidAtlas& solid, const Visit& visit) {
    for (std::uint32_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                visit(solid.maps[span.map], x, y);
}

void append(const Vec3d& color, Values& values) {
    values.insert(values.end(), {color.x, color.y, color.z});
}

Values values_of(const SolidAtlas& solid, const Image<Rgb8>& image) {
    Values values;
    for_each_texel(solid, [&](const TexelMap&, std::uint32_t x, std::uint32_t y) {
        append(linear_light(image(x, y)), values);
    });
    return values;
}

Values values_of(const SolidAtlas& solid, const Image<RgbF>& image) {
    Values values;
    for_each_texel(solid, [&](const TexelMap&, std::uint32_t x, std::uint32_t y) {
        const RgbF& c = image(x, y);
        append({c.r, c.g, c.b}, values);
    });
    return values;
}

/// A graph's values in float64.
Values defined_graph(const SolidAtlas& solid, const Recipe& recipe) {
    const GraphEvaluator evaluate(recipe.graph);
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
    for_each_texel(solid, [&](const TexelMap& texel, std::uint32_t x, std::uint32_t y) {
        points.push_back(from_solid(texel(x, y)));
        if (points.size() == graph_batch_size) flush();
    });
    flush();
    return values;
}

/// The texture's definition, texel by texel in float64.
Values defined(const SolidAtlas& solid, const Recipe& recipe) {
    if (!recipe.graph.empty()) return defined_graph(solid, recipe);
    const std::vector<Octave> octaves = expand_octaves(recipe.texture);
    const PreparedColorMap map(recipe.texture.colors);
    const Affine3 from_solid = texture_from_solid(recipe);
    Values values;
    for_each_texel(solid, [&](const TexelMap& texel, std::uint32_t x, std::uint32_t y) {
        append(map(evaluate_field(recipe.texture.quadric, octaves, from_solid(texel(x, y)))),
               values);
    });
    return values;
}

/// A texture's cases and where each leaves what it computed.
struct Subject {
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
        results.push_back([p = pipeline, image] { return values_of(p->solid(), *image); });
    }

    void add_definition() {
        auto values = std::make_shared<Values>();
        const double texels = double(pipeline->solid().size) * pipeline->solid().size;
        cases.push_back({"float64 definition, 1 thread", texels, "texel",
                         [p = pipeline, values] { *values = defined(p->solid(), p->recipe()); },
                         group});
        results.push_back([values] { return *values; });
    }
};

/// Whether a bake is meant to give the texture's values at the texels' centres.
bool has_definition(const Recipe& recipe) {
    return recipe.filter == Filter{} && !recipe.precision.kind;
}

std::vector<BenchResult> bench_subject(const Subject& subject, int repeats) {
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
        Subject subject{pipeline, fmt::format("{}, {} x {}", name, side, side), {}, {}};
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
