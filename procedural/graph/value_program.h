#pragma once
// A texture graph's values as a straight list of operations on arrays (value_kernels.h,
// noise_sum.h) for batches of points: equal operations once, what does not depend on the point
// ahead of all batches, what nobody reads not at all. It knows no gradients, so it serves point
// samples.
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "procedural/batch/economy.h"
#include "procedural/graph/evaluator.h"
#include "procedural/graph/value_kernels.h"
#include "procedural/kernels/noise_sum.h"

namespace burl {

/// Points of a batch: few enough that all arrays of a graph fit the L2 cache.
inline constexpr std::size_t value_batch = 256;

/// Number of an array; 0, 1 and 2 are the points' coordinates.
using Register = std::uint32_t;

/// Weight of disk `inside` of the node `dots` at a point's first two coordinates.
struct DotsWeight {
    std::uint32_t seed = 0, period_u = 0, period_v = 0;
    double radius = 0.0;
    bool operator==(const DotsWeight&) const = default;
};

/// Colour of an image at a point's first two coordinates: bilinear, for there is no footprint.
struct ImageLookup {
    std::shared_ptr<const MipImage> pixels;
    ImageWrap wrap = ImageWrap::repeat;  ///< that of `pixels`
    bool operator==(const ImageLookup&) const = default;
};

/// How fast a graph grows along a direction: by its evaluator, gradients and all.
struct GraphSlope {
    std::shared_ptr<const GraphEvaluator> graph;
    Vec3d direction{0.0};
    bool operator==(const GraphSlope&) const = default;
};

using ValueWork =
    std::variant<ValueOperation, NoiseSum, ColorPieces, DotsWeight, ImageLookup, GraphSlope>;

struct ValueStep {
    ValueWork work;
    std::vector<Register> inputs;
    std::vector<Register> outputs;
    std::uint32_t node = 0;  ///< of the graph, for which it was added first
    bool operator==(const ValueStep&) const = default;
};

/// Where `weight` is `value` at every point of a batch, steps are left out.
struct ValueGuard {
    Register weight = 0;
    double value = 0.0;
    std::size_t first_step = 0;  ///< before which the weight is looked at
};

struct ValueGuards {
    std::vector<ValueGuard> guards;
    std::vector<std::size_t> by_step;    ///< their numbers, by first_step
    std::vector<std::uint64_t> of_step;  ///< per step: bit g is set where guard g guards it
};

class ValueProgram {
  public:
    /// Whether a batch looks at what it may leave out (value_guards.h) is said by `skips`, and
    /// whether constants and equal work are; null: it does not, and they are.
    explicit ValueProgram(const Skips* skips = nullptr);

    /// Arrays of one thread.
    struct Scratch {
        struct alignas(64) Array {
            double values[value_batch + batch_padding] = {};
        };
        std::vector<Array> arrays;
        std::vector<GraphEvaluator::Scratch> graphs;
        SynthesisWork work;  ///< octaves of all runs with it
        double* operator[](Register r) { return arrays[r].values; }
    };

    /// What is added from now on belongs to this node of the graph.
    void begin_node(std::uint32_t node) { node_ = node; }
    /// What `work` gives of the inputs, `count` arrays. Work that was added before is not added
    /// again.
    std::vector<Register> add(ValueWork work, std::vector<Register> inputs, std::size_t count = 1);
    Register add(ValueOp op, std::vector<Register> inputs, const std::array<double, 4>& p = {});
    Register constant(double value) { return add(ValueOp::constant, {}, {value}); }
    /// Whether two registers hold the same numbers by the same work.
    bool same(Register a, Register b) const { return original_[a] == original_[b]; }
    /// The number that a register always holds, if it is a constant.
    const double* constant_of(Register r) const;

    /// Ends the program: what `results` do not need is dropped, and arrays are used again. Returns
    /// the results' arrays; other registers mean nothing any more, and nothing can be added.
    std::vector<Register> finish(std::vector<Register> results);

    Scratch make_scratch() const;
    /// Fills the results from scratch[0], [1] and [2]; at most value_batch points.
    void run(std::size_t count, Scratch& scratch) const;

    const std::vector<ValueStep>& steps() const { return steps_; }
    /// Octaves of noise that a point takes.
    std::size_t octaves() const;

  private:
    void drop_unread(const std::vector<Register>& results);
    void put_fixed_first();
    void share_arrays(std::vector<Register>& results);

    std::size_t octaves_of_shared() const;

    std::vector<ValueStep> steps_;
    std::vector<Register> original_{0, 1, 2};  ///< of equal work: what the first of it fills
    std::vector<Register> shared_;             ///< what was asked for again
    bool share_ = true, fix_ = true, guard_ = false;
    ValueGuards guards_;
    std::size_t shared_octaves_ = 0;
    std::uint32_t node_ = 0;
    Register registers_ = 3;
    std::size_t fixed_steps_ = 0;  ///< the first ones do not depend on the point
};

}  // namespace burl
