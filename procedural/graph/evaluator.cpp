#include "procedural/graph/evaluator.h"

#include <algorithm>

namespace burl {

namespace {

/// The footprints of point samples.
constexpr std::array<Footprint, graph_batch_size> no_footprints{};

}  // namespace

GraphEvaluator::GraphEvaluator(const TextureGraph& graph, const Filter& filter,
                               PrecisionKind precision, GraphOutput output)
    : graph_(graph) {
    GraphProgram program = program_of(graph_);
    if (output == GraphOutput::planes) program.results = plane_registers(program);
    drop_unread(program.steps, std::span<const Register>(program.results), program.registers);
    const auto rest = std::ranges::stable_partition(
        program.steps, [](const GraphStep& step) { return step.inputs.empty(); });
    fixed_ = program.steps.size() - rest.size();
    channels_ =
        share_arrays(program.steps, fixed_, std::span<Register>(program.results), program.registers)
            .count;
    results_ = std::move(program.results);
    const DualSettings settings{filter, precision == PrecisionKind::float32};
    for (GraphStep& step : program.steps)
        steps_.push_back(
            {std::visit([&](const auto& work) { return dual_function(work, settings); }, step.work),
             std::move(step.inputs), std::move(step.outputs)});
}

void GraphEvaluator::run(const Step& step, std::span<const Footprint> footprints, std::size_t first,
                         Scratch& scratch) {
    DualCall call;
    for (std::size_t k = 0; k < step.inputs.size(); ++k) call.inputs[k] = &scratch[step.inputs[k]];
    for (std::size_t k = 0; k < step.outputs.size(); ++k)
        call.outputs[k] = &scratch[step.outputs[k]];
    call.footprints = footprints;
    call.masks = &scratch.masks;
    call.first = first;
    step.run(call);
}

GraphEvaluator::Scratch GraphEvaluator::make_scratch() const {
    Scratch scratch{std::vector<DualArray>(channels_), {}};
    for (std::size_t i = 0; i < fixed_; ++i) run(steps_[i], no_footprints, 0, scratch);
    return scratch;
}

void GraphEvaluator::run_batch(std::span<const Vec3d> points, std::span<const Footprint> footprints,
                               std::size_t first, Scratch& scratch) const {
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            Vec3d slope(0.0);
            slope[axis] = 1.0;
            scratch[std::size_t(axis)].set(i, {points[i][axis], slope});
        }
    const auto covered = footprints.empty()
                             ? std::span<const Footprint>(no_footprints).first(points.size())
                             : footprints;
    for (std::size_t i = fixed_; i < steps_.size(); ++i) run(steps_[i], covered, first, scratch);
}

void GraphEvaluator::operator()(std::span<const Vec3d> points,
                                std::span<const Footprint> footprints, Scratch& scratch,
                                std::span<GraphSample> samples) const {
    for (std::size_t begin = 0; begin < points.size(); begin += graph_batch_size) {
        const std::size_t count = std::min(graph_batch_size, points.size() - begin);
        run_batch(points.subspan(begin, count),
                  footprints.empty() ? footprints : footprints.subspan(begin, count), begin,
                  scratch);
        for (std::size_t i = 0; i < count; ++i) {
            samples[begin + i].wire = graph_.nodes[graph_.result].wire;
            for (std::size_t c = 0; c < results_.size(); ++c)
                samples[begin + i].channels[c] = scratch[results_[c]].get(i);
        }
    }
}

void GraphEvaluator::planes(std::span<const Vec3d> points, std::span<const Footprint> footprints,
                            Scratch& scratch, std::span<double* const> planes) const {
    run_batch(points, footprints, 0, scratch);
    for (std::size_t p = 0; p < planes.size(); ++p)
        for (std::size_t i = 0; i < points.size(); ++i)
            planes[p][i] = scratch[results_[p]].get(i).value;
}

GraphSample GraphEvaluator::operator()(const Vec3d& point, const Footprint& footprint) const {
    Scratch scratch = make_scratch();
    GraphSample sample;
    (*this)({&point, 1}, {&footprint, 1}, scratch, {&sample, 1});
    return sample;
}

}  // namespace burl
