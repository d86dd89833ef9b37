#pragma once
// 8-bit colours of an index in fixed point (fixed_index.h), for shaders: [0,1] is cut into entries
// so short that a colour changes at most twice in nearly each, and an entry holds its three colours
// and the places of the two changes in a single texel. Places are cut off to steps of the index, so
// a reader must leave undecided what lies nearer to a change than the index is exact.
#include <optional>

#include "procedural/color/table.h"
#include "procedural/fixed/index.h"

namespace burl {

struct FixedColors {
    /// Two to the `bits` entries, and one for index 1: colours r + 2^8 g + 2^16 b before, between
    /// and after the changes, and the changes' places, the first in the lower 16 bits. Places are
    /// counted in 2^-15 of an entry, entries begin at `margin`. Colours of the few entries with
    /// more changes are `undecided_code`.
    std::vector<glm::uvec4> entries;
    int bits = 0;
    /// Places are whole steps: 2^-step_bits of the index.
    int step_bits() const { return bits + 15; }
    /// Steps on both sides of an entry within which it knows of changes, too: more than any
    /// tolerance.
    static constexpr std::uint32_t margin = 1024;
    static constexpr std::uint32_t no_change = 0xffff;  ///< a place that is far from all
};

/// What is added to a colour that stays open.
inline constexpr std::uint32_t undecided_code = 0xff000000u;

/// None where colours change so fast that entries would have to be too many.
std::optional<FixedColors> fixed_colors(const ColorTable8& table);

}  // namespace burl
