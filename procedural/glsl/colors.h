#pragma once
// The colour map of a texture (Hart et al. 1999, eq. 2) as tables that shaders read by index and
// that give the colours of color/table.h and color/srgb.h to the bit: 8-bit codes by their steps
// over the map's index, linear light by segments, 16-bit codes by the thresholds between them.
#include <cstdint>
#include <vector>

#include "procedural/color/table.h"

namespace burl {

/// Four 32-bit numbers of a table; a float64 takes two of them, the lower half first.
using TableTexel = glm::uvec4;

/// The tables of shaders/color/codes.glsl. A code is r + 2^8 g + 2^16 b.
struct ColorSteps {
    /// Entries for `count` equal parts of [0, 1] and one for 1 itself: the code at the part's
    /// begin, the index of the next step, and that step's code.
    std::vector<TableTexel> entries;
    std::uint32_t count = 0;  ///< number of entries less 1
    /// The largest number of steps in one entry, rounded up to a power of two: where it is two or
    /// more, a shader searches `steps` from `first` of the entry on.
    std::uint32_t most = 1;
    /// The numbers of the last steps at or before the entries' begins.
    std::vector<std::uint32_t> first;
    /// The steps: index, code and 0; `most` or more steps at infinity end them.
    std::vector<TableTexel> steps;
};
/// The steps of a table, with 2^14 to 2^16 entries: more only where that lessens `most`.
ColorSteps color_steps(const ColorTable8& table);

/// The segments of a map for shaders/color/segments.glsl: four texels a segment, which hold where
/// it begins, its colour there and the colour's slope (each x, y and z), and 0.
std::vector<TableTexel> color_segments(const PreparedColorMap& map);

/// Colours for shaders/color/table.glsl: two texels a colour, which hold x, y, z and 0.
std::vector<TableTexel> color_texels(std::span<const Vec3d> colors);

/// The tables of shaders/color/srgb16.glsl.
struct SrgbThresholds {
    static constexpr std::uint32_t buckets = 1u << 16;
    std::vector<std::uint32_t> first;  ///< codes to search from, by bucket of the root
    /// The least linear light of the code after each; infinity for the last.
    std::vector<glm::uvec2> thresholds;
};
SrgbThresholds srgb_thresholds();

}  // namespace burl
