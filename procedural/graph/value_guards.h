#pragma once
// Steps of a value program whose results a batch of points does not need: what is multiplied by 0
// at every point, as a layer under an opaque one, or the square of a checkerboard that the batch
// does not touch.
#include <cstdint>
#include <span>
#include <vector>

#include "procedural/graph/value_program.h"

namespace burl {

/// Coordinates up to this size are looked at.
inline constexpr double largest_guarded = 1e30;

/// Guards for steps [fixed, steps.size()), of which each writes arrays of its own, every one read
/// by another step or a result. Only steps that every factor makes finite numbers are left out, so
/// that what remains adds 0 (of either sign) as it would have otherwise. Puts the steps in an order
/// in which a guard's weight comes before what it guards.
ValueGuards find_guards(std::vector<ValueStep>& steps, std::size_t fixed, std::size_t arrays,
                        std::span<const Register> results);

}  // namespace burl
