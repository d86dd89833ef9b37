#pragma once
// Dead code elimination and register allocation for programs of texture graphs: lists of steps with
// numbered inputs and outputs.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace burl {

/// The number of an array of a program; 0, 1 and 2 are the points' coordinates.
using Register = std::uint32_t;

/// Drops dead code: steps whose outputs neither a result nor a later step reads.
template <class Step>
void drop_unread(std::vector<Step>& steps, std::span<const Register> results,
                 std::size_t registers) {
    std::vector<bool> read(registers, false);
    for (const Register r : results) read[r] = true;
    std::vector<Step> kept;
    for (std::size_t i = steps.size(); i-- > 0;) {
        Step& step = steps[i];
        if (std::ranges::none_of(step.outputs, [&](Register r) { return read[r]; })) continue;
        for (const Register r : step.inputs) read[r] = true;
        kept.push_back(std::move(step));
    }
    steps.assign(std::make_move_iterator(kept.rbegin()), std::make_move_iterator(kept.rend()));
}

/// The arrays that registers are assigned to.
struct SharedArrays {
    std::vector<Register> of_register;
    Register count = 3;  ///< number of arrays
};

/// Assigns registers to arrays, of which each is free after the last step that reads it, and writes
/// their numbers into the steps and results. The arrays of the points' coordinates, of results and
/// of the outputs of the first `fixed` steps are never free.
template <class Step>
SharedArrays share_arrays(std::vector<Step>& steps, std::size_t fixed, std::span<Register> results,
                          std::size_t registers) {
    constexpr auto always = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> last(registers, 0);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        for (const Register r : steps[i].outputs) last[r] = i < fixed ? always : i;
        for (const Register r : steps[i].inputs) last[r] = std::max(last[r], i);
    }
    for (const Register r : results) last[r] = always;
    last[0] = last[1] = last[2] = always;

    SharedArrays shared{std::vector<Register>(registers, 0)};
    std::vector<Register>& array = shared.of_register;
    array[1] = 1, array[2] = 2;
    std::vector<Register> free;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        for (const Register r : steps[i].outputs) {
            array[r] = free.empty() ? shared.count++ : free.back();
            if (!free.empty()) free.pop_back();
        }
        std::vector<Register> done = steps[i].inputs;
        done.insert(done.end(), steps[i].outputs.begin(), steps[i].outputs.end());
        std::ranges::sort(done);
        done.erase(std::unique(done.begin(), done.end()), done.end());
        for (const Register r : done)
            if (last[r] == i) free.push_back(array[r]);
        for (Register& r : steps[i].inputs) r = array[r];
        for (Register& r : steps[i].outputs) r = array[r];
    }
    for (Register& r : results) r = array[r];
    return shared;
}

}  // namespace burl
