#pragma once
// The random numbers of multipass noise that do not come from the lattice hash: tables looked up by
// coordinates ("Perlin Noise Pixel Shaders", section 4.3), and pairs of luminances that the bits of
// coordinates choose from (section 5.3), with the table that makes the Gaussian numbers of the
// latter white.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burl {

/// The number of entries of a table: the numbers of an 8-bit image.
inline constexpr std::size_t pass_table_size = 256;

/// Four tables. The first three hold whole numbers 0..85, thirds of an image's range that add up to
/// 255 at most; the fourth holds every odd multiple of 2^-8 in [-1, 1) once, in random order, so
/// that the numbers are as white as 256 of them can be.
using RandomTables = std::array<std::array<float, pass_table_size>, 4>;
RandomTables random_tables(std::uint32_t seed);

/// The luminances, 0..255, that replace a bit of 0 and of 1.
struct BitColors {
    std::array<float, 2> luminance{};
};

/// The luminances of an octave: three pairs for every bit of the coordinates, from the highest bit
/// on, axis by axis, then eight pairs for the bits of the first result.
struct BitRandomizer {
    unsigned bits = 4;  ///< number of bits of each coordinate
    std::vector<BitColors> coordinates;
    std::array<BitColors, 8> result;

    /// The first result, 0..255, of a lattice point with coordinates 0..2^bits - 1: luminances
    /// blended by the coordinates' bits.
    std::uint32_t mixed(const std::array<std::uint32_t, 3>& point) const;
    /// The number, 0..255, of the lattice point: luminances blended by the bits of mixed().
    std::uint32_t operator()(const std::array<std::uint32_t, 3>& point) const;
};
BitRandomizer bit_randomizer(std::uint32_t seed, unsigned bits);

/// The luminance from which blending starts.
inline constexpr float blend_start = 128.0f;

/// 7/8 of `under` and 1/8 of `over`, rounded to the nearest, halves up.
constexpr std::uint32_t blended(std::uint32_t under, std::uint32_t over) {
    return (7 * under + over + 4) >> 3;
}

/// Histogram equalisation: the table maps each number to its rank, 0..255, among the numbers of all
/// lattice points.
std::array<float, pass_table_size> equal_table(const BitRandomizer& randomizer);

}  // namespace burl
