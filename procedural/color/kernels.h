#pragma once
// The last steps of an 8-bit texture, vectorised as in texel_batch.h: codes from a table, pixels
// of three bytes from codes of four.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "atlas/base/image.h"
#include "procedural/color/map.h"

namespace burl {

/// entries[j] = floor(map_index(wrap, f[j]) * entry_count), up to the end of a vector of floats.
void index_colors(Wrap wrap, const double* f, std::size_t count, std::uint32_t entry_count,
                  std::int32_t* entries);

/// Whether a code of a table of colours is final is said by its last byte.
struct ColorCode {
    Rgb8 color;
    bool uniform = false;
};
/// A code that is not final has room for a number instead, up to 2^24 - 1, as which larger ones
/// count.
constexpr ColorCode numbered(std::size_t number) {
    const auto n = std::uint32_t(std::min<std::size_t>(number, (1u << 24) - 1));
    return {{std::uint8_t(n), std::uint8_t(n >> 8), std::uint8_t(n >> 16)}, false};
}
constexpr std::uint32_t number_of(const ColorCode& code) {
    return code.color.r | std::uint32_t(code.color.g) << 8 | std::uint32_t(code.color.b) << 16;
}

/// Bits of a place below those that number its entry of a table.
inline constexpr int place_bits = 16;

/// codes[j] = table[places[j] >> place_bits]. later[0..result) = the numbers of those that are not
/// uniform, in order. Works on whole vectors: the arrays hold batch_padding elements more than
/// `count`, `later` twice that, aligned to 64 but for `later`, and places beyond the last lie in
/// the table, too.
std::size_t look_up_codes(const ColorCode* table, const std::int32_t* places, std::size_t count,
                          ColorCode* codes, std::uint32_t* later);

/// pixels[j] = codes[j].color, and nothing beyond.
void pack_pixels(const ColorCode* codes, std::size_t count, Rgb8* pixels);

}  // namespace burl
