#pragma once
// The last steps of an 8-bit texture, vectorised as in texel_batch.h: codes from a table, pixels
// of three bytes from codes of four.
#include <cstddef>
#include <cstdint>

#include "atlas/image.h"
#include "procedural/color_map.h"

namespace burl {

/// entries[j] = floor(map_index(wrap, f[j]) * entry_count), up to the end of a vector of floats.
void index_colors(Wrap wrap, const double* f, std::size_t count, std::uint32_t entry_count,
                  std::int32_t* entries);

/// Whether a code of a table of colours is final is said by its last byte.
struct ColorCode {
    Rgb8 color;
    bool uniform = false;
};

/// codes[j] = table[entries[j]]. later[0..result) = the numbers of those that are not uniform, in
/// order. Works on whole vectors: the arrays hold batch_padding elements more than `count`, aligned
/// to 64, and those of `entries` beyond the last lie in the table, too.
std::size_t look_up_codes(const ColorCode* table, const std::int32_t* entries, std::size_t count,
                          ColorCode* codes, std::uint32_t* later);

/// pixels[j] = codes[j].color, and nothing beyond.
void pack_pixels(const ColorCode* codes, std::size_t count, Rgb8* pixels);

}  // namespace burl
