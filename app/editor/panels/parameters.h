#pragma once
// The panel of parameters (parameters_panel of panels.h): a slider, box or list for each parameter
// of the table. Ctrl-click to type a value, double-click for the default, Shift to drag at a tenth
// of the speed.
#include <cstdint>

#include "app/recipe/leaves.h"

namespace burl {

/// The range of a parameter's slider: the table's range if it is narrow, otherwise 40 steps to both
/// sides of the default; widened to contain `value`.
struct SliderRange {
    double low = 0.0, high = 1.0;
};
SliderRange slider_range(const Parameter& parameter, double value);

/// Returns the random seed that a button puts in place of `seed`, the same in every run, so that
/// scripts repeat: the next one of a linear congruential generator with the full period 2^16.
/// Successive seeds are far apart, because octave k of a noise uses seed + k and neighbouring seeds
/// would share most octaves.
inline std::uint32_t next_seed(std::uint64_t seed) {
    return std::uint32_t((seed % 65536U) * 25173U + 13849U) % 65536U;
}

}  // namespace burl
