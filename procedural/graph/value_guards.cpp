#include "procedural/graph/value_guards.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "procedural/graph/value_ranges.h"

namespace burl {

namespace {

/// The largest number of guards: their set is a 64-bit word.
constexpr std::size_t most_guards = 64;

/// An input of a step that is multiplied by 0 where `weight` is `value`.
struct IdleInput {
    Register weight = 0;
    double value = 0.0;
    std::size_t step = 0, input = 0;
};

/// Appends the inputs of a step that a weight can make idle.
void find_idle(const ValueStep& step, std::size_t number, std::vector<IdleInput>& idle) {
    const auto* operation = std::get_if<ValueOperation>(&step.work);
    if (!operation) return;
    const auto add = [&](std::size_t weight, double value, std::size_t input) {
        if (step.inputs[weight] != step.inputs[input])
            idle.push_back({step.inputs[weight], value, number, input});
    };
    switch (operation->op) {
        case ValueOp::multiply:
            add(0, 0.0, 1);
            return add(1, 0.0, 0);
        case ValueOp::products:
            add(0, 0.0, 1);
            return add(2, 0.0, 3);
        case ValueOp::lerp:
            add(0, 1.0, 1);
            return add(0, 0.0, 2);
        default:
            return;
    }
}

/// Whether a step costs so much that testing a weight to skip it pays.
bool is_dear(const ValueStep& step) {
    return std::holds_alternative<NoiseSum>(step.work) ||
           std::holds_alternative<ImageLookup>(step.work) ||
           std::holds_alternative<GraphSlope>(step.work);
}

/// Finds the guards of a program and puts its steps in an order in which they work.
class GuardFinder {
  public:
    GuardFinder(std::vector<ValueStep>& steps, std::size_t fixed, std::size_t arrays,
                std::span<const Register> results)
        : steps_(steps), fixed_(fixed), arrays_(arrays), results_(results), order_(steps.size()) {
        std::iota(order_.begin(), order_.end(), std::size_t(0));
        guards_.of_step.assign(steps.size(), 0);
        constexpr ValueRange coordinate{-largest_guarded, largest_guarded};
        ranges_ = value_ranges(steps, arrays, {coordinate, coordinate, coordinate});
    }

    ValueGuards operator()() {
        std::vector<IdleInput> idle;
        for (std::size_t i = fixed_; i < steps_.size(); ++i) find_idle(steps_[i], i, idle);
        const auto before = [](const IdleInput& a, const IdleInput& b) {
            return std::pair(a.weight, a.value) < std::pair(b.weight, b.value);
        };
        std::ranges::stable_sort(idle, before);
        for (std::size_t i = 0, end = 0; i < idle.size(); i = end) {
            while (end < idle.size() && !before(idle[i], idle[end])) ++end;
            if (guards_.guards.size() < most_guards) consider({idle.data() + i, end - i});
        }
        put_in_order();
        return std::move(guards_);
    }

  private:
    /// The steps that are read, directly or not, by these inputs only.
    std::vector<bool> needed_only_by(std::span<const IdleInput> inputs) const {
        std::vector<bool> read(arrays_, false), idle(steps_.size(), false);
        for (const Register r : results_) read[r] = true;
        for (std::size_t i = steps_.size(); i-- > fixed_;) {
            const ValueStep& step = steps_[i];
            idle[i] = std::ranges::none_of(step.outputs, [&](Register r) { return read[r]; });
            if (idle[i]) continue;
            for (std::size_t k = 0; k < step.inputs.size(); ++k) {
                const bool counts = std::ranges::none_of(inputs, [&](const IdleInput& input) {
                    return input.step == i && input.input == k;
                });
                if (counts) read[step.inputs[k]] = true;
            }
        }
        return idle;
    }

    /// Adds a guard for inputs of one weight and value, if all are finite and it skips costly
    /// steps.
    void consider(std::span<const IdleInput> inputs) {
        const bool all_finite = std::ranges::all_of(inputs, [&](const IdleInput& input) {
            return ranges_[steps_[input.step].inputs[input.input]].finite();
        });
        if (!all_finite) return;
        const std::vector<bool> idle = needed_only_by(inputs);
        bool dear = false;
        for (std::size_t i = fixed_; i < steps_.size(); ++i)
            dear = dear || (idle[i] && is_dear(steps_[i]));
        if (!dear || !nests(inputs.front().weight, idle)) return;
        // Guarded steps come just before the first step that reads them, and so after the weight.
        const auto reader = std::ranges::find_if(order_, [&](std::size_t step) {
            return std::ranges::find(inputs, step, &IdleInput::step) != inputs.end();
        });
        std::stable_partition(order_.begin() + std::ptrdiff_t(fixed_), reader,
                              [&](std::size_t step) { return !idle[step]; });
        const std::uint64_t bit = std::uint64_t(1) << guards_.guards.size();
        for (std::size_t i = fixed_; i < steps_.size(); ++i)
            if (idle[i]) guards_.of_step[i] |= bit;
        guards_.guards.push_back({inputs.front().weight, inputs.front().value, 0});
    }

    bool writes(std::size_t step, Register r) const {
        return std::ranges::find(steps_[step].outputs, r) != steps_[step].outputs.end();
    }

    /// Whether a guard is compatible with those before it: a weight that is guarded itself may
    /// guard only steps that its own guard guards, too.
    bool nests(Register weight, const std::vector<bool>& idle) const {
        std::uint64_t guards_of_weight = 0;
        std::vector<Register> written;
        for (std::size_t i = fixed_; i < steps_.size(); ++i) {
            if (writes(i, weight)) guards_of_weight = guards_.of_step[i];
            if (idle[i])
                written.insert(written.end(), steps_[i].outputs.begin(), steps_[i].outputs.end());
        }
        for (std::size_t g = 0; g < guards_.guards.size(); ++g) {
            const std::uint64_t bit = std::uint64_t(1) << g;
            const bool guards_weight = (guards_of_weight & bit) != 0;
            const bool has_weight =
                std::ranges::find(written, guards_.guards[g].weight) != written.end();
            for (std::size_t i = fixed_; i < steps_.size(); ++i) {
                const bool of_guard = (guards_.of_step[i] & bit) != 0;
                if (guards_weight && idle[i] && !of_guard) return false;
                if (has_weight && of_guard && !idle[i]) return false;
            }
        }
        return true;
    }

    /// Applies the order to the steps, and sorts guards by their first step.
    void put_in_order() {
        std::vector<ValueStep> steps;
        std::vector<std::uint64_t> of_step;
        for (const std::size_t i : order_) {
            steps.push_back(std::move(steps_[i]));
            of_step.push_back(guards_.of_step[i]);
        }
        steps_ = std::move(steps);
        guards_.of_step = std::move(of_step);
        for (std::size_t g = 0; g < guards_.guards.size(); ++g)
            guards_.guards[g].first_step = std::size_t(
                std::ranges::find_if(guards_.of_step,
                                     [&](std::uint64_t bits) { return (bits >> g & 1) != 0; }) -
                guards_.of_step.begin());
        guards_.by_step.resize(guards_.guards.size());
        std::iota(guards_.by_step.begin(), guards_.by_step.end(), std::size_t(0));
        std::ranges::stable_sort(guards_.by_step, {},
                                 [&](std::size_t g) { return guards_.guards[g].first_step; });
    }

    std::vector<ValueStep>& steps_;
    std::size_t fixed_, arrays_;
    std::span<const Register> results_;
    std::vector<std::size_t> order_;  ///< numbers of the steps before reordering
    std::vector<ValueRange> ranges_;
    ValueGuards guards_;
};

}  // namespace

ValueGuards find_guards(std::vector<ValueStep>& steps, std::size_t fixed, std::size_t arrays,
                        std::span<const Register> results) {
    return GuardFinder(steps, fixed, arrays, results)();
}

}  // namespace burl
