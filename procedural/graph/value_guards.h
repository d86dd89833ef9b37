#pragma once
// Steps of a value program whose results a batch of points does not need, because they are
// multiplied by 0 at every point: a layer under an opaque one, or the square of a checkerboard that
// the batch does not touch.
#include <cstdint>
#include <span>
#include <vector>

#include "procedural/graph/value_program.h"

namespace burl {

/// The largest size of coordinates for which guards hold; batches with larger ones skip nothing.
inline constexpr double largest_guarded = 1e30;

/// The guards for steps [fixed, steps.size()). Each step must write arrays of its own, every one
/// read by another step or a result. A step is skipped only where interval arithmetic proves its
/// results finite, so that it would have added 0 (of either sign). Reorders the steps so that a
/// guard's weight comes before the steps that it guards.
ValueGuards find_guards(std::vector<ValueStep>& steps, std::size_t fixed, std::size_t arrays,
                        std::span<const Register> results);

}  // namespace burl
