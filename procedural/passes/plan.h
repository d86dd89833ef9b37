#pragma once
// Noise as a list of passes over whole images, each one simple operation per texel, because that is
// all that graphics hardware of 2001 could do (Carr & Hart, "Real-Time Solid Texturing", figure 9;
// Hart, "Perlin Noise Pixel Shaders", figure 3): coordinates are split into integers and weights,
// then each of the cell's eight corners is selected, randomised, weighted and accumulated. Who runs
// the list is another matter: the host (multipass_model.h) or OpenGL (app/gl/fill/multipass.h).
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "procedural/color/map.h"
#include "procedural/field/octave_groups.h"
#include "procedural/passes/tables.h"

namespace burl {

/// What the images hold between passes: RGBA32F, RGBA16F, or RGBA8, whole numbers 0..255.
enum class PassPrecision { float32, float16, fixed8 };

/// How a corner's integers become a random number: by the lattice hash; by a table for each
/// coordinate, their sum and a fourth table (the papers' PixelMap); or bit by bit, blending one of
/// two colours for every bit (the papers' register combiners).
enum class Randomizer { hash, table, bits };

struct MultipassOptions {
    PassPrecision precision = PassPrecision::float32;
    Randomizer randomizer = Randomizer::hash;
    bool equalize = false;  ///< of bits, whose numbers are Gaussian: make them white
};

/// Coordinates in 8 bits, b_i.b_f: cells count from `base`, modulo 2^integer.
struct LatticeBits {
    unsigned integer = 4;  ///< 1..7
    bool repeats = false;  ///< the cells are more than 2^integer
    std::array<std::uint32_t, 3> base{};
    unsigned fraction() const { return 8 - integer; }
    /// Of a corner's integers, which are one more than the last cell's at most.
    std::uint32_t mask() const { return repeats ? (1u << integer) - 1 : 255; }
};

/// What the lattice coordinates of a stream range over, before doublings.
struct LatticeBox {
    Vec3d low{0.0}, high{0.0};
};

/// As many integer bits as the cells need after doublings, but at least one bit for each part: a
/// range of more than 128 cells repeats. Randomizer::bits sees no more than these bits: there the
/// upper corners of the last of 2^integer cells are the first one's.
LatticeBits lattice_bits(const LatticeBox& box, int doublings);

/// One octave of value noise: + scale * n(2^doublings x), n in [-1,1), x of map number `stream`.
struct MultipassOctave {
    Fade fade = Fade::smooth;  ///< linear or smooth
    std::uint32_t seed = 0;
    std::size_t stream = 0;
    int doublings = 0;
    double scale = 0.0;
    LatticeBits bits{};  ///< of fixed8
};

/// Images that passes read and write. Those of integers are RGBA32UI but for fixed8.
enum class PassImage {
    none,
    solid,        ///< coordinates, b_i.b_f (fixed8)
    integers,     ///< of the cell's lowest corner
    integers_up,  ///< of its opposite corner
    shifted,      ///< integers at the top of their bytes (fixed8)
    shifted_up,   ///< the same of the opposite corner (bits)
    weights,      ///< fractions, faded
    ramp,         ///< for the S-curve
    cell,         ///< integers of one corner
    part_s,       ///< one coordinate's part of a random number
    part_t,
    part_r,
    mixed,   ///< what bits randomise first
    corner,  ///< random number of one corner, then its weighted one
    noise,
    sum,   ///< of octaves
    index  ///< into the colour map
};

/// Images x (first) and y (second); 1 is the largest number an image of fixed8 holds.
enum class PassKind {
    fill,         ///< bias everywhere; OpenGL clears, so this is no pass
    cells,        ///< integers of the lattice map after doublings
    places,       ///< and fractions, in [0,1]
    solid_map,    ///< both in 8 bits
    step,         ///< x + 1, of integers
    copy,         ///< x, of the channels in `mask`
    transfer,     ///< scale x + bias, modulo 256 where `wraps` (PixelTransfer)
    combine,      ///< x + (scale y + bias)
    multiply,     ///< x y
    isolate,      ///< channel `axis` of x
    shift_left,   ///< x without its highest bit, doubled
    blend_bit,    ///< 7/8 y + 1/8 of `colors` number 0 or 1, by the highest bit of x
    hash,         ///< random number of integers x
    axis_table,   ///< number `axis` of `table` at channel `axis` of x, one further where `upper`
    value_table,  ///< the fourth of `table` at x
    weigh,        ///< x times channel `axis` of y, or times 1 less that where not `upper`
    field_index   ///< the colour map's index of quadric + constant + x
};

struct Pass {
    PassKind kind = PassKind::fill;
    PassImage target = PassImage::none, first = PassImage::none, second = PassImage::none;
    std::size_t stream = 0;
    int doublings = 0;
    unsigned axis = 0;
    bool upper = false, wraps = false;
    std::array<bool, 3> mask{true, true, true};
    float scale = 1.0f, bias = 0.0f;  ///< of fixed8 in units of 1/255
    std::array<float, 2> colors{};
    std::uint32_t seed = 0;
    std::size_t table = 0;
    LatticeBits bits{};
};

struct MultipassPlan {
    MultipassOptions options;
    std::vector<Pass> passes;
    std::vector<RandomTables> tables;  ///< as the images hold them
    Wrap wrap = Wrap::repeat;
    double constant = 0.0;   ///< added to the quadric
    double amplitude = 1.0;  ///< what 255/2 units of the sum stand for (fixed8)
};

/// Why the papers' passes cannot express these octaves in that way, as the end of a sentence; empty
/// where they can.
std::string no_multipass_form(std::span<const Octave> octaves, const MultipassOptions& options);

/// Octaves that have a form, finest first within each group. `boxes`: of each group's stream, where
/// fixed8 needs them.
std::vector<MultipassOctave> multipass_octaves(std::span<const OctaveGroup> groups,
                                               std::span<const LatticeBox> boxes);

/// The passes from lattice maps to the colour map's index of the field.
MultipassPlan plan_multipass(const MultipassOptions& options,
                             std::span<const MultipassOctave> octaves, double constant, Wrap wrap);

/// Passes that draw.
std::size_t count_passes(std::span<const Pass> passes);
/// Those of one octave, up to its being added to the others.
std::size_t passes_of_octave(const MultipassOptions& options, const MultipassOctave& octave);

/// Whether the image is RGBA32UI.
bool holds_integers(PassImage image, PassPrecision precision);

}  // namespace burl
