#pragma once
// The last steps of an 8-bit texture, vectorised as in texel_batch.h: codes from a table, and
// pixels of three bytes from codes of four.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "atlas/base/image.h"
#include "procedural/color/map.h"

namespace burl {

/// entries[j] = floor(map_index(wrap, f[j]) * entry_count), computed up to the end of a vector of
/// floats.
void index_colors(Wrap wrap, const double* f, std::size_t count, std::uint32_t entry_count,
                  std::int32_t* entries);

/// An entry of a table of colours: the final sRGB code where `uniform`, otherwise a number.
struct ColorCode {
    Rgb8 color;
    bool uniform = false;
};
/// A non-uniform entry that holds `number` in its three bytes; numbers above 2^24 - 1 count as 2^24
/// - 1.
constexpr ColorCode numbered(std::size_t number) {
    const auto n = std::uint32_t(std::min<std::size_t>(number, (1u << 24) - 1));
    return {{std::uint8_t(n), std::uint8_t(n >> 8), std::uint8_t(n >> 16)}, false};
}
/// The number that a non-uniform entry holds.
constexpr std::uint32_t number_of(const ColorCode& code) {
    return code.color.r | std::uint32_t(code.color.g) << 8 | std::uint32_t(code.color.b) << 16;
}

/// The bits of a place below those that are the number of its table entry.
inline constexpr int place_bits = 16;

/// codes[j] = table[places[j] >> place_bits]. later[0..result) are the j whose code is not uniform,
/// ascending. Works on whole vectors: `places` and `codes` are aligned to 64 bytes and hold
/// batch_padding elements more than `count`, `later` 2 batch_padding more, and the padding of
/// `places` must name entries of the table, too.
std::size_t look_up_codes(const ColorCode* table, const std::int32_t* places, std::size_t count,
                          ColorCode* codes, std::uint32_t* later);

/// pixels[j] = codes[j].color for j < count; no byte beyond is written.
void pack_pixels(const ColorCode* codes, std::size_t count, Rgb8* pixels);

}  // namespace burl
