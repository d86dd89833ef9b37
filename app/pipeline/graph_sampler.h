#pragma once
// Texture graphs as functions of one point, for callers on several threads.
#include <tbb/enumerable_thread_specific.h>

#include "procedural/graph/evaluator.h"
#include "procedural/graph/values.h"

namespace burl {

/// A texture graph in float64 with gradients. Every thread has scratch arrays, which are too large
/// to be allocated for every point.
class GraphSampler {
  public:
    /// Takes the graph, and a filter as GraphEvaluator does.
    explicit GraphSampler(const TextureGraph& graph, const Filter& filter = {FilterKind::trapezoid})
        : evaluate_(graph, filter), scratch_([this] { return evaluate_.make_scratch(); }) {}

    /// The graph's value at s, filtered over the footprint; a footprint of 0 gives the unfiltered
    /// value. May be called from several threads at once.
    GraphSample operator()(const Vec3d& s, const Footprint& footprint = {}) {
        GraphSample sample;
        evaluate_({&s, 1}, {&footprint, 1}, scratch_.local(), {&sample, 1});
        return sample;
    }

  private:
    GraphEvaluator evaluate_;
    tbb::enumerable_thread_specific<GraphEvaluator::Scratch> scratch_;
};

/// A texture graph in float32, unfiltered, as colours in linear light. Every thread has scratch
/// arrays.
class GraphColorSampler {
  public:
    explicit GraphColorSampler(const TextureGraph& graph)
        : values_(graph), scratch_([this] { return values_.make_scratch(); }) {}

    /// The colour at s. May be called from several threads at once.
    Vec3d operator()(const Vec3d& s) { return values_(s, scratch_.local()); }

  private:
    GraphValues values_;
    tbb::enumerable_thread_specific<GraphValues::Scratch> scratch_;
};

}  // namespace burl
