#pragma once
// Evaluation of a texture graph in batches: the steps of its program (program.h) one after the
// other, each over the arrays of all points, with forward-mode derivatives. Everything is float64,
// which is the reference, or sums of noise are evaluated by the vectorised kernels in float32. A
// point's result does not depend on the other points of its batch.
#include <memory>
#include <span>
#include <vector>

#include "procedural/batch/precision.h"
#include "procedural/graph/duals.h"
#include "procedural/graph/planes.h"

namespace burl {

/// The result of a graph with its gradient with respect to the solid point: one channel for a
/// number; red, green, blue (linear light, multiplied by alpha) and alpha for a colour.
struct GraphSample {
    std::array<Dual, 4> channels;
    Wire wire = Wire::number;

    /// Linear light over black; a number is a grey.
    Vec3d color() const {
        if (wire == Wire::number) return Vec3d(channels[0].value);
        return {channels[0].value, channels[1].value, channels[2].value};
    }
};

class GraphEvaluator {
  public:
    /// The arrays of one thread, reusable for any number of batches.
    struct Scratch {
        std::vector<DualArray> arrays;
        MaskValues masks;  ///< values of the graph's masks at the points of the next call
        DualArray& operator[](std::size_t r) { return arrays[r]; }
    };

    /// The graph must be valid (graph_from_json makes only valid ones) and not empty. `filter`
    /// decides how color_map and field average over footprints (docs/reference/nodes.md).
    /// `precision`, float64 or float32, is that of sums of noise.
    explicit GraphEvaluator(const TextureGraph& graph,
                            const Filter& filter = {FilterKind::trapezoid},
                            PrecisionKind precision = PrecisionKind::float64,
                            GraphOutput output = GraphOutput::color);

    Scratch make_scratch() const;
    const TextureGraph& graph() const { return graph_; }

    /// samples[i] = the result at points[i] over footprints[i], or at points where no footprints
    /// are given; any number of points.
    void operator()(std::span<const Vec3d> points, std::span<const Footprint> footprints,
                    Scratch& scratch, std::span<GraphSample> samples) const;

    /// The planes (planes.h) at points; `output` must be GraphOutput::planes. At most
    /// graph_batch_size points.
    void planes(std::span<const Vec3d> points, std::span<const Footprint> footprints,
                Scratch& scratch, std::span<double* const> planes) const;

    /// The result at one point.
    GraphSample operator()(const Vec3d& point, const Footprint& footprint = {}) const;

  private:
    struct Step {
        DualFunction run;
        std::vector<Register> inputs, outputs;
    };
    static void run(const Step& step, std::span<const Footprint> footprints, std::size_t first,
                    Scratch& scratch);
    /// Runs all steps for at most graph_batch_size points, of which the first is number `first` of
    /// scratch.masks.
    void run_batch(std::span<const Vec3d> points, std::span<const Footprint> footprints,
                   std::size_t first, Scratch& scratch) const;

    TextureGraph graph_;
    std::vector<Step> steps_;
    std::size_t fixed_ = 0;  ///< number of leading steps that do not depend on the point
    std::vector<Register> results_;
    std::size_t channels_ = 0;
};

}  // namespace burl
