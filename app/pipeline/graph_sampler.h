#pragma once
// A texture graph as a function of one point, for callers on several threads.
#include <tbb/enumerable_thread_specific.h>

#include "procedural/graph/evaluator.h"
#include "procedural/graph/values.h"

namespace burl {

/// Keeps arrays for every thread: they are too large to make anew for every point.
class GraphSampler {
  public:
    /// `filter` as GraphEvaluator takes it.
    explicit GraphSampler(const TextureGraph& graph, const Filter& filter = {FilterKind::trapezoid})
        : evaluate_(graph, filter), scratch_([this] { return evaluate_.make_scratch(); }) {}

    /// Unfiltered where the footprint is 0. May be called from several threads at once.
    GraphSample operator()(const Vec3d& s, const Footprint& footprint = {}) {
        GraphSample sample;
        evaluate_({&s, 1}, {&footprint, 1}, scratch_.local(), {&sample, 1});
        return sample;
    }

  private:
    GraphEvaluator evaluate_;
    tbb::enumerable_thread_specific<GraphEvaluator::Scratch> scratch_;
};

/// The same in float32, colours alone.
class GraphColorSampler {
  public:
    explicit GraphColorSampler(const TextureGraph& graph)
        : values_(graph), scratch_([this] { return values_.make_scratch(); }) {}

    Vec3d operator()(const Vec3d& s) { return values_(s, scratch_.local()); }

  private:
    GraphValues values_;
    tbb::enumerable_thread_specific<GraphValues::Scratch> scratch_;
};

}  // namespace burl
