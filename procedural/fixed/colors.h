#pragma once
// 8-bit colours of an index in fixed point (index.h), for shaders: [0, 1] is cut into entries so
// short that nearly each has at most two changes of the colour, and an entry holds its three
// colours and the places of the two changes in a single texel. Places are rounded down to steps of
// the index, so a reader must treat an index as undecided that is nearer to a change than its
// error.
#include <optional>

#include "procedural/color/table.h"
#include "procedural/fixed/index.h"

namespace burl {

/// A table of 8-bit colours by the index.
struct FixedColors {
    /// 2^bits entries, and one for index 1: the colours r + 2^8 g + 2^16 b before, between and
    /// after the changes, and the changes' places, the first in the lower 16 bits. Places are
    /// counted in 2^-15 of an entry from `margin` before the entry on. Entries with more changes
    /// have `undecided_code` in their colours.
    std::vector<glm::uvec4> entries;
    int bits = 0;
    /// The binary logarithm of the number of places in [0, 1]: a place is 2^-step_bits of the
    /// index.
    int step_bits() const { return bits + 15; }
    /// The steps on both sides of an entry within which it knows of changes, too: more than any
    /// tolerance.
    static constexpr std::uint32_t margin = 1024;
    static constexpr std::uint32_t no_change = 0xffff;  ///< the place that stands for no change
};

/// The bits that mark a colour as undecided.
inline constexpr std::uint32_t undecided_code = 0xff000000u;

/// The table of a map's colours; none where colours change so fast that it would be too long.
std::optional<FixedColors> fixed_colors(const ColorTable8& table);

}  // namespace burl
