#include "app/texture_color.h"

#include <memory>
#include <utility>

#include <tbb/enumerable_thread_specific.h>

#include "procedural/graph_evaluator.h"
#include "procedural/octaves.h"

namespace burl {

namespace {

/// Arrays of each thread for the evaluator, which are too large to make anew for every point.
struct GraphColor {
    explicit GraphColor(const TextureGraph& graph)
        : evaluate(graph), scratch([this] { return evaluate.make_scratch(); }) {}

    GraphEvaluator evaluate;
    tbb::enumerable_thread_specific<GraphEvaluator::Scratch> scratch;
};

}  // namespace

TextureColor texture_color(const Recipe& recipe) {
    if (!recipe.graph.empty()) {
        return [graph = std::make_shared<GraphColor>(recipe.graph)](const Vec3d& s) {
            GraphSample sample;
            graph->evaluate({&s, 1}, {}, graph->scratch.local(), {&sample, 1});
            return sample.color();
        };
    }
    return [octaves = expand_octaves(recipe.texture), quadric = recipe.texture.quadric,
            colors = recipe.texture.colors](const Vec3d& s) {
        return evaluate_color(colors, evaluate_field(quadric, octaves, s));
    };
}

}  // namespace burl
