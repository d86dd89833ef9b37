#include "procedural/graph/value_program.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "procedural/noise/lattice_site.h"
#include "procedural/noise/simplex_curl.h"
#include "procedural/noise/value_noise.h"

namespace burl {

namespace {

/// The input and output arrays of a step.
struct StepArrays {
    std::array<const double*, most_step_inputs> inputs{};
    std::array<double*, 3> outputs{};
    std::size_t count = 0;
    std::span<const ValueProgram::Scratch::Array> masks{};
    std::span<const std::array<ValueProgram::Scratch::Array, 3>> mask_slopes{};
};

void run_work(const ValueOperation& work, const StepArrays& arrays, GraphEvaluator::Scratch&) {
    const auto& in = arrays.inputs;
    apply(work, {in[0], in[1], in[2], in[3]}, arrays.count, arrays.outputs[0]);
}

void run_work(const NoiseSum& work, const StepArrays& arrays, GraphEvaluator::Scratch&) {
    add_up(work, {arrays.inputs[0], arrays.inputs[1], arrays.inputs[2]}, arrays.count,
           arrays.outputs[0]);
}

void run_work(const ColorPieces& work, const StepArrays& arrays, GraphEvaluator::Scratch&) {
    look_up(work, arrays.inputs[0], arrays.count, arrays.outputs);
}

/// Calls visit(seed, frequency, weight) for the octaves from the coarsest on, weights times
/// `amplitude`.
template <class Visit>
void for_octaves(const OctaveLadder& ladder, double amplitude, Visit&& visit) {
    double frequency = 1.0, weight = amplitude;
    for (std::uint32_t k = 0; k < std::uint32_t(ladder.octaves); ++k) {
        visit(ladder.seed + k, frequency, weight);
        frequency *= ladder.lacunarity;
        weight *= ladder.gain;
    }
}

void run_work(const SimplexOctaves& work, const StepArrays& arrays, GraphEvaluator::Scratch&) {
    std::fill_n(arrays.outputs[0], arrays.count, 0.0);
    const auto add = [&](std::uint32_t seed, double frequency, double weight) {
        for (std::size_t j = 0; j < arrays.count; ++j) {
            Point<most_simplex_dimensions> p{};
            for (std::size_t i = 0; i < work.noise.dimensions; ++i)
                p[i] = (i < 3 ? frequency : 1.0) * arrays.inputs[i][j];
            arrays.outputs[0][j] += weight * sample_simplex<float>(work.noise, seed, p).value;
        }
    };
    for_octaves(work.octaves, work.noise.amplitude(), add);
}

void run_work(const CurlOctaves& work, const StepArrays& arrays, GraphEvaluator::Scratch&) {
    for (double* out : arrays.outputs) std::fill_n(out, arrays.count, 0.0);
    const auto add = [&](std::uint32_t seed, double frequency, double weight) {
        for (std::size_t j = 0; j < arrays.count; ++j) {
            Point<3> p;
            for (std::size_t i = 0; i < 3; ++i) p[i] = frequency * arrays.inputs[i][j];
            const FieldVector<double> field = sample_curl<float>(seed, p, work.time);
            for (std::size_t a = 0; a < 3; ++a) arrays.outputs[a][j] += weight * field.value[a];
        }
    };
    for_octaves(work.octaves, simplex_curl_amplitude(work.time ? 4 : 3), add);
}

/// The node `dots` without a footprint: square (i, j) has three numbers of `cell` noise.
void run_work(const DotsWeight& work, const StepArrays& arrays, GraphEvaluator::Scratch&) {
    const Period<2> period{work.period_u, work.period_v};
    const double shift = 0.5 - work.radius;
    for (std::size_t j = 0; j < arrays.count; ++j) {
        const double x = arrays.inputs[0][j], y = arrays.inputs[1][j];
        const auto square = lattice_site<double, 2>({x + 0.5, y + 0.5}, period);
        const auto random = [&](int across, int down) {
            return shift *
                   lattice_value(square.index(0, across), square.index(1, down), 0, work.seed);
        };
        double& weight = arrays.outputs[0][j];
        weight = 0.0;
        if (!(random(0, 0) >= 0.0)) continue;
        const double dx = x - (std::floor(x + 0.5) + random(1, 2));
        const double dy = y - (std::floor(y + 0.5) + random(4, 9));
        weight = work.radius - std::sqrt(dx * dx + dy * dy) >= 0.0 ? 1.0 : 0.0;
    }
}

void run_work(const CellNumber& work, const StepArrays& arrays, GraphEvaluator::Scratch&) {
    for (std::size_t j = 0; j < arrays.count; ++j) {
        const auto axis = [&](std::size_t k) {
            return arrays.inputs[k] ? arrays.inputs[k][j] : 0.0;
        };
        arrays.outputs[0][j] = cell_number({axis(0), axis(1), axis(2)}, work.seed);
    }
}

void run_work(const CellFeature& work, const StepArrays& arrays, GraphEvaluator::Scratch&) {
    const double *x = arrays.inputs[0], *y = arrays.inputs[1], *z = arrays.inputs[2];
    for (std::size_t j = 0; j < arrays.count; ++j)
        arrays.outputs[0][j] = cell_feature({x[j], y[j], z[j]}, work.points, work.gives).value;
}

void run_work(const ScatteredShapes& work, const StepArrays& arrays, GraphEvaluator::Scratch&) {
    for (std::size_t j = 0; j < arrays.count; ++j)
        arrays.outputs[0][j] = scattered_at(work, arrays.inputs[0][j], arrays.inputs[1][j]).value;
}

void run_work(const ImageLookup& work, const StepArrays& arrays, GraphEvaluator::Scratch&) {
    for (std::size_t j = 0; j < arrays.count; ++j) {
        const double s = arrays.inputs[0][j], t = arrays.inputs[1][j];
        const Vec3d color = work.pixels->bilinear(0, s, t).color;
        for (int c = 0; c < 3; ++c) arrays.outputs[std::size_t(c)][j] = color[c];
    }
}

void run_work(const MaskRead& work, const StepArrays& arrays, GraphEvaluator::Scratch&) {
    std::copy_n(arrays.masks[work.mask].values, arrays.count, arrays.outputs[0]);
}

void run_work(const GraphSlope& work, const StepArrays& arrays, GraphEvaluator::Scratch& scratch) {
    scratch.masks.resize(arrays.mask_slopes.size());
    for (std::size_t m = 0; m < arrays.mask_slopes.size(); ++m) {
        const auto& [x, y, z] = arrays.mask_slopes[m];
        scratch.masks[m].resize(arrays.count);
        for (std::size_t j = 0; j < arrays.count; ++j)
            scratch.masks[m][j] = {arrays.masks[m].values[j],
                                   {x.values[j], y.values[j], z.values[j]}};
    }
    std::array<Vec3d, value_batch> points;
    std::array<GraphSample, value_batch> samples;
    for (std::size_t j = 0; j < arrays.count; ++j)
        points[j] = {arrays.inputs[0][j], arrays.inputs[1][j], arrays.inputs[2][j]};
    (*work.graph)({points.data(), arrays.count}, {}, scratch, {samples.data(), arrays.count});
    for (std::size_t j = 0; j < arrays.count; ++j)
        arrays.outputs[0][j] = glm::dot(work.direction, samples[j].channels[0].slope);
}

void run_work(const PointFunction& work, const StepArrays& arrays, GraphEvaluator::Scratch&) {
    const std::size_t count = std::ranges::find(arrays.inputs, nullptr) - arrays.inputs.begin();
    std::array<double, most_step_inputs> in{};
    for (std::size_t j = 0; j < arrays.count; ++j) {
        for (std::size_t k = 0; k < count; ++k) in[k] = arrays.inputs[k][j];
        const auto out = point_value<double>(work, {in.data(), count});
        for (std::size_t c = 0; c < 3 && arrays.outputs[c]; ++c) arrays.outputs[c][j] = out[c];
    }
}

std::size_t octaves_of(const ValueStep& step) {
    if (const auto* sum = std::get_if<NoiseSum>(&step.work)) return sum->octaves.size();
    if (const auto* sum = std::get_if<SimplexOctaves>(&step.work))
        return std::size_t(sum->octaves.octaves);
    const auto* field = std::get_if<CurlOctaves>(&step.work);
    return field ? std::size_t(field->octaves.octaves) : 0;
}

void run_step(const ValueStep& step, std::size_t count, ValueProgram::Scratch& scratch,
              GraphEvaluator::Scratch& graph) {
    StepArrays arrays;
    arrays.count = count;
    arrays.masks = scratch.masks;
    arrays.mask_slopes = scratch.mask_slopes;
    for (std::size_t k = 0; k < step.inputs.size(); ++k) arrays.inputs[k] = scratch[step.inputs[k]];
    for (std::size_t k = 0; k < step.outputs.size(); ++k)
        arrays.outputs[k] = scratch[step.outputs[k]];
    std::visit([&](const auto& work) { run_work(work, arrays, graph); }, step.work);
}

}  // namespace

ValueProgram::ValueProgram(const Skips* skips)
    : share_(!skips || skips->allows(Skip::subtrees)),
      fix_(!skips || skips->allows(Skip::constants)) {}

std::vector<Register> ValueProgram::add(ValueWork work, std::vector<Register> inputs,
                                        std::size_t count) {
    ValueStep step{std::move(work), std::move(inputs), {}, node_};
    const auto known = std::ranges::find_if(steps_, [&](const ValueStep& before) {
        return before.work == step.work &&
               std::ranges::equal(before.inputs, step.inputs,
                                  [&](Register a, Register b) { return same(a, b); });
    });
    if (known != steps_.end() && share_) {
        shared_.push_back(known->outputs.front());
        return known->outputs;
    }
    for (std::size_t i = 0; i < count; ++i) {
        step.outputs.push_back(registers_++);
        const Register first = known == steps_.end() ? step.outputs[i] : known->outputs[i];
        original_.push_back(original_.size() > first ? original_[first] : first);
    }
    return steps_.emplace_back(std::move(step)).outputs;
}

Register ValueProgram::add(ValueOp op, std::vector<Register> inputs,
                           const std::array<double, 4>& p) {
    return add(ValueOperation{op, p}, std::move(inputs)).front();
}

const double* ValueProgram::constant_of(Register r) const {
    for (const ValueStep& step : steps_) {
        const auto* operation = std::get_if<ValueOperation>(&step.work);
        if (step.outputs.front() == r && operation && operation->op == ValueOp::constant)
            return &operation->parameters[0];
    }
    return nullptr;
}

void ValueProgram::put_fixed_first() {
    std::vector<bool> varies(registers_, false);
    varies[0] = varies[1] = varies[2] = true;
    for (const ValueStep& step : steps_)
        if (std::any_of(step.inputs.begin(), step.inputs.end(),
                        [&](Register r) { return varies[r]; }))
            for (const Register r : step.outputs) varies[r] = true;
    const auto rest = std::stable_partition(steps_.begin(), steps_.end(), [&](const ValueStep& s) {
        return !varies[s.outputs.front()];
    });
    fixed_steps_ = fix_ ? std::size_t(rest - steps_.begin()) : 0;
}

std::vector<Register> ValueProgram::finish(std::vector<Register> results) {
    drop_unread(steps_, std::span<const Register>(results), registers_);
    put_fixed_first();
    shared_octaves_ = octaves_of_shared();
    registers_ = share_arrays(steps_, fixed_steps_, std::span<Register>(results), registers_).count;
    return results;
}

std::size_t ValueProgram::masks() const {
    std::size_t count = 0;
    for (const ValueStep& step : steps_) {
        if (const auto* read = std::get_if<MaskRead>(&step.work))
            count = std::max(count, read->mask + 1);
        if (const auto* slope = std::get_if<GraphSlope>(&step.work))
            count = std::max(count, graph_masks(slope->graph->graph()).size());
    }
    return count;
}

bool ValueProgram::reads_mask_slopes() const {
    return std::ranges::any_of(steps_, [](const ValueStep& step) {
        const auto* slope = std::get_if<GraphSlope>(&step.work);
        return slope && !graph_masks(slope->graph->graph()).empty();
    });
}

std::size_t ValueProgram::octaves() const {
    std::size_t count = 0;
    for (std::size_t i = fixed_steps_; i < steps_.size(); ++i) count += octaves_of(steps_[i]);
    return count;
}

/// The octaves that a point would take besides if common subexpressions were evaluated again.
std::size_t ValueProgram::octaves_of_shared() const {
    std::size_t count = 0;
    for (std::size_t i = fixed_steps_; i < steps_.size(); ++i)
        count += octaves_of(steps_[i]) *
                 std::size_t(std::ranges::count(shared_, steps_[i].outputs.front()));
    return count;
}

ValueProgram::Scratch ValueProgram::make_scratch() const {
    Scratch scratch;
    scratch.arrays.resize(registers_);
    scratch.masks.resize(masks());
    if (reads_mask_slopes()) scratch.mask_slopes.resize(scratch.masks.size());
    scratch.graphs.resize(steps_.size());
    for (std::size_t i = 0; i < steps_.size(); ++i)
        if (const auto* slope = std::get_if<GraphSlope>(&steps_[i].work))
            scratch.graphs[i] = slope->graph->make_scratch();
    for (std::size_t i = 0; i < fixed_steps_; ++i)
        run_step(steps_[i], value_batch, scratch, scratch.graphs[i]);
    return scratch;
}

void ValueProgram::run(std::size_t count, Scratch& scratch) const {
    SynthesisWork& work = scratch.work;
    for (std::size_t i = 0; i < fixed_steps_; ++i)
        work.skip_octaves(Skip::constants, octaves_of(steps_[i]) * count);
    work.skip_octaves(Skip::subtrees, shared_octaves_ * count);
    for (std::size_t i = fixed_steps_; i < steps_.size(); ++i) {
        work.octaves += octaves_of(steps_[i]) * count;
        run_step(steps_[i], count, scratch, scratch.graphs[i]);
    }
}

}  // namespace burl
