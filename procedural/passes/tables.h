#pragma once
// The random numbers of multipass noise that do not come from the lattice hash: tables looked up by
// coordinates ("Perlin Noise Pixel Shaders", section 4.3), and pairs of luminances that the bits of
// coordinates choose from (section 5.3), with the table that makes the latter's Gaussian numbers
// white.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burl {

/// Entries are those of 8-bit images.
inline constexpr std::size_t pass_table_size = 256;

/// The first three hold whole numbers 0..85, thirds of an image's range that add up to 255 at most;
/// the fourth every multiple of 2^-8 in [-1,1) that is odd in units of 2^-8, once, in random order:
/// so the numbers are as white as 256 of them can be.
using RandomTables = std::array<std::array<float, pass_table_size>, 4>;
RandomTables random_tables(std::uint32_t seed);

/// What a bit is replaced by: luminances 0..255 for 0 and 1.
struct BitColors {
    std::array<float, 2> luminance{};
};

/// Luminances of an octave: three for every bit of the coordinates, from the highest bit on, axis
/// by axis, then eight for those of the first result.
struct BitRandomizer {
    unsigned bits = 4;  ///< of each coordinate
    std::vector<BitColors> coordinates;
    std::array<BitColors, 8> result;

    /// The number of a lattice point, coordinates 0..2^bits - 1: 0..255.
    std::uint32_t operator()(const std::array<std::uint32_t, 3>& point) const;
};
BitRandomizer bit_randomizer(std::uint32_t seed, unsigned bits);

/// What blending starts from.
inline constexpr float blend_start = 128.0f;

/// 7/8 of `under` and 1/8 of `over`, rounded to the nearest, halves up.
constexpr std::uint32_t blended(std::uint32_t under, std::uint32_t over) {
    return (7 * under + over + 4) >> 3;
}

/// Maps each number to its rank among those of all lattice points, 0..255: histogram equalisation.
std::array<float, pass_table_size> equal_table(const BitRandomizer& randomizer);

}  // namespace burl
