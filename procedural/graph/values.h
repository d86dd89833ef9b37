#pragma once
// The values of a texture graph at points, without gradients and with noise in float32: bakes and
// pictures in precision float32 use them where the filter needs no footprints. Everything else is
// float64, so that jumps (docs/reference/nodes.md) lie where the float64 evaluation has them, up to
// the noise's error.
#include "procedural/graph/planes.h"
#include "procedural/graph/value_program.h"

namespace burl {

class GraphValues {
  public:
    using Scratch = ValueProgram::Scratch;

    /// The graph must be valid (graph_from_json makes only valid ones) and not empty. `skips` is
    /// passed to ValueProgram.
    explicit GraphValues(const TextureGraph& graph, const Skips* skips = nullptr,
                         GraphOutput output = GraphOutput::color);

    Scratch make_scratch() const { return program_.make_scratch(); }

    /// The channels of GraphSample::color() at the points whose coordinates lie in scratch[0], [1]
    /// and [2]; `count` is at most value_batch. A point's bits do not depend on the other points of
    /// its batch.
    std::array<const double*, 3> operator()(std::size_t count, Scratch& scratch) const;

    /// The colour at one point.
    Vec3d operator()(const Vec3d& point, Scratch& scratch) const;

    const ValueProgram& program() const { return program_; }
    /// The program's arrays that hold red, green and blue, or, for GraphOutput::planes, all planes.
    const std::vector<Register>& results() const { return results_; }

  private:
    ValueProgram program_;
    std::vector<Register> results_;
};

}  // namespace burl
