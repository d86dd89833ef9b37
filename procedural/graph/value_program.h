#pragma once
// A texture graph's values as a list of operations on arrays (value_kernels.h, kernels/noise_sum.h)
// for batches of points. Common subexpressions are evaluated once, operations that do not depend on
// the point once per thread, and dead code is dropped. A program has no gradients, so it serves
// point samples.
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "procedural/batch/economy.h"
#include "procedural/graph/evaluator.h"
#include "procedural/graph/program.h"

namespace burl {

/// The largest number of points in a batch: few enough that all arrays of a graph fit the L2 cache.
inline constexpr std::size_t value_batch = 256;

/// The colour of an image at a point's first two coordinates: bilinear, for there is no footprint.
struct ImageLookup {
    std::shared_ptr<const MipImage> pixels;
    ImageWrap wrap = ImageWrap::repeat;  ///< wrap of `pixels`
    bool operator==(const ImageLookup&) const = default;
};

/// The derivative of a graph's number along a direction, by an evaluator with gradients.
struct GraphSlope {
    std::shared_ptr<const GraphEvaluator> graph;
    Vec3d direction{0.0};
    bool operator==(const GraphSlope&) const = default;
};

/// The work of a step.
using ValueWork = std::variant<ValueOperation, NoiseSum, SimplexOctaves, CurlOctaves, ColorPieces,
                               DotsWeight, CellNumber, CellFeature, ScatteredShapes, ImageLookup,
                               GraphSlope, MaskRead, PointFunction>;

/// A step of a program: work with the arrays that it reads and writes.
struct ValueStep {
    ValueWork work;
    std::vector<Register> inputs;
    std::vector<Register> outputs;
    std::uint32_t node = 0;  ///< node of the graph for which the step was first added
    bool operator==(const ValueStep&) const = default;
};

/// A list of steps that computes registers from the coordinates of a batch of points.
class ValueProgram {
  public:
    /// `skips` decides whether common subexpressions are evaluated once, and whether constants
    /// are. Null: both are.
    explicit ValueProgram(const Skips* skips = nullptr);

    /// The arrays of one thread.
    struct Scratch {
        struct alignas(64) Array {
            double values[value_batch + batch_padding] = {};
        };
        std::vector<Array> arrays;
        /// Values of the graph's masks (masks.h) at the batch's points, by number; 0 at first.
        std::vector<Array> masks;
        /// The masks' gradients with respect to the solid point; empty where no step reads them.
        std::vector<std::array<Array, 3>> mask_slopes;
        std::vector<GraphEvaluator::Scratch> graphs;
        SynthesisWork work;  ///< octaves of all runs with these arrays
        double* operator[](Register r) { return arrays[r].values; }
    };

    /// Makes steps added from now on belong to this node of the graph.
    void begin_node(std::uint32_t node) { node_ = node; }
    /// Adds a step and returns its `count` results; work that was added before with the same inputs
    /// is not added again.
    std::vector<Register> add(ValueWork work, std::vector<Register> inputs, std::size_t count = 1);
    Register add(ValueOp op, std::vector<Register> inputs, const std::array<double, 4>& p = {});
    Register constant(double value) { return add(ValueOp::constant, {}, {value}); }
    /// Whether two registers hold the same numbers, by the same work.
    bool same(Register a, Register b) const { return original_[a] == original_[b]; }
    /// The number that a register always holds; null if it is no constant.
    const double* constant_of(Register r) const;

    /// Ends the program: drops dead code and lets registers share arrays. Returns the arrays of
    /// `results`; other registers become invalid, and nothing can be added.
    std::vector<Register> finish(std::vector<Register> results);

    Scratch make_scratch() const;
    /// Computes the results from scratch[0], [1] and [2]; at most value_batch points.
    void run(std::size_t count, Scratch& scratch) const;

    /// The number of the last mask that a step reads, plus 1.
    std::size_t masks() const;
    /// Whether a step reads gradients of masks.
    bool reads_mask_slopes() const;
    const std::vector<ValueStep>& steps() const { return steps_; }
    /// The octaves of noise that a point takes.
    std::size_t octaves() const;

  private:
    void put_fixed_first();
    std::size_t octaves_of_shared() const;

    std::vector<ValueStep> steps_;
    std::vector<Register> original_{0, 1, 2};  ///< first registers that equal work fills
    std::vector<Register> shared_;             ///< results of common subexpressions, once per reuse
    bool share_ = true, fix_ = true;
    std::size_t shared_octaves_ = 0;
    std::uint32_t node_ = 0;
    Register registers_ = 3;
    std::size_t fixed_steps_ = 0;  ///< number of leading steps that do not depend on the point
};

}  // namespace burl
