#pragma once
// Tables over a colour map's index that hold the final code wherever it is the same over a whole
// entry, and elsewhere where in the list of steps to look.
#include <cstdint>
#include <span>

#include "procedural/color_table.h"

namespace burl {

/// The entries of steps that end at infinity: entry i is of [i, i + 1) of as many parts of the
/// index as there are entries but one, a power of two, and the last is index 1. `first_step` is the
/// last step up to an entry's begin, whose colour it has.
void fill_color_entries(std::span<const ColorTable8::Step> steps, std::span<ColorCode> entries,
                        std::span<std::uint32_t> first_step);

}  // namespace burl
