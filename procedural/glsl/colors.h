#pragma once
// The colour map of a texture (Hart et al. 1999, eq. 2) as tables that shaders read by index, for
// the looked-up colours of color_table.h and srgb.h, to the bit: 8-bit codes by their steps over
// the map's index, linear light by segments, 16-bit codes by the thresholds between them.
#include <cstdint>
#include <vector>

#include "procedural/color/table.h"

namespace burl {

/// Four 32-bit numbers of a table; a float64 takes two, the lower half first.
using TableTexel = glm::uvec4;

/// For color_codes.glsl. A code is r + 2^8 g + 2^16 b.
struct ColorSteps {
    /// Per entry of [0,1] cut into equal parts, and one for 1 itself: the code at its begin, the
    /// index of the next step, its code.
    std::vector<TableTexel> entries;
    std::uint32_t count = 0;  ///< of entries, without the last
    /// Steps in one entry at most, rounded up to a power of two: where there are two or more, a
    /// shader looks further from the entry's first on.
    std::uint32_t most = 1;
    std::vector<std::uint32_t> first;  ///< per entry: the number of the last step up to its begin
    std::vector<TableTexel> steps;     ///< index, code, 0; `most` and more at infinity end them
};
/// 2^14 to 2^16 entries, as many as lessen `most`.
ColorSteps color_steps(const ColorTable8& table);

/// For color_segments.glsl: four texels a segment, which hold where it begins, its colour there and
/// the colour's slope, x, y and z; 0 at the end.
std::vector<TableTexel> color_segments(const PreparedColorMap& map);

/// For color_table.glsl: two texels a colour, x, y and z; 0.
std::vector<TableTexel> color_texels(std::span<const Vec3d> colors);

/// For srgb16.glsl.
struct SrgbThresholds {
    static constexpr std::uint32_t buckets = 1u << 16;
    std::vector<std::uint32_t> first;    ///< per bucket of the square root: at most its least code
    std::vector<glm::uvec2> thresholds;  ///< from here on the code is higher; infinity at the end
};
SrgbThresholds srgb_thresholds();

}  // namespace burl
