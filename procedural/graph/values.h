#pragma once
// A texture graph at points, without gradients and with noise in float32: what bakes and pictures
// in precision float32 take where no filter wants footprints. Everything else is float64, so that
// what jumps (docs/reference/nodes.md) jumps where the float64 evaluation has it, up to the noise's
// error.
#include "procedural/graph/value_program.h"

namespace burl {

class GraphValues {
  public:
    using Scratch = ValueProgram::Scratch;

    /// The graph must be valid (graph_from_json makes only such) and not empty. `skips` as a
    /// ValueProgram takes them.
    explicit GraphValues(const TextureGraph& graph, const Skips* skips = nullptr);

    Scratch make_scratch() const { return program_.make_scratch(); }

    /// GraphSample::color()'s channels at the points whose coordinates lie in scratch[0], [1] and
    /// [2]; `count` up to value_batch. A point's bits do not depend on what else is in its batch.
    std::array<const double*, 3> operator()(std::size_t count, Scratch& scratch) const;

    /// One point.
    Vec3d operator()(const Vec3d& point, Scratch& scratch) const;

    const ValueProgram& program() const { return program_; }
    /// The program's arrays that hold red, green and blue.
    const std::vector<Register>& results() const { return results_; }

  private:
    ValueProgram program_;
    std::vector<Register> results_;
};

}  // namespace burl
