#pragma once
// Noise as a list of passes over whole images, each one simple operation per texel, because that is
// all that graphics hardware of 2001 could do (Carr & Hart, "Real-Time Solid Texturing", figure 9;
// Hart, "Perlin Noise Pixel Shaders", figure 3): coordinates are split into integers and weights,
// then each of the cell's eight corners is selected, randomised, weighted and accumulated. The host
// (model.h) and OpenGL (app/gl/fill/multipass.h) can run such a list.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "atlas/base/enum_names.h"
#include "procedural/color/map.h"
#include "procedural/field/octave_groups.h"
#include "procedural/passes/tables.h"

namespace burl {

/// The format of images between passes: RGBA32F, RGBA16F, or RGBA8 with whole numbers 0..255.
enum class PassPrecision { float32, float16, fixed8 };

/// The way a corner's integers become a random number: by the lattice hash; by a table for each
/// coordinate, their sum and a fourth table (the papers' PixelMap); or bit by bit, blending one of
/// two colours for every bit (the papers' register combiners).
enum class Randomizer { hash, table, bits };

/// Options of multipass noise.
struct MultipassOptions {
    PassPrecision precision = PassPrecision::float32;
    Randomizer randomizer = Randomizer::hash;
    bool equalize = false;  ///< makes the numbers of `bits`, which are Gaussian, white
};

/// The split of a coordinate's 8 bits, b_i.b_f: cells count from `base`, modulo 2^integer.
struct LatticeBits {
    unsigned integer = 4;  ///< 1 to 7
    bool repeats = false;  ///< whether the lattice has more than 2^integer cells
    std::array<std::uint32_t, 3> base{};
    unsigned fraction() const { return 8 - integer; }
    /// The mask of a corner's integers, which are at most one more than the last cell's.
    std::uint32_t mask() const { return repeats ? (1u << integer) - 1 : 255; }
};

/// The range of the lattice coordinates of a stream, before doublings.
struct LatticeBox {
    Vec3d low{0.0}, high{0.0};
};

/// The split for the cells of a box after doublings: as many integer bits as the cells need, but at
/// least one bit for each part; a range of more than 128 cells repeats. Randomizer::bits has no
/// more than these bits: with it the upper corners of the last of 2^integer cells are the first
/// one's.
LatticeBits lattice_bits(const LatticeBox& box, int doublings);

/// An octave of value noise: it adds scale * n(2^doublings x), n in [-1, 1), where x comes from
/// lattice map number `stream`.
struct MultipassOctave {
    Fade fade = Fade::smooth;  ///< linear or smooth
    std::uint32_t seed = 0;
    std::size_t stream = 0;
    int doublings = 0;
    double scale = 0.0;
    LatticeBits bits{};  ///< split of the coordinates, for fixed8
};

/// Images that passes read and write. Images of integers are RGBA32UI, except with fixed8.
enum class PassImage {
    none,
    solid,        ///< coordinates, b_i.b_f (fixed8)
    integers,     ///< integers of the cell's lowest corner
    integers_up,  ///< integers of the cell's opposite corner
    shifted,      ///< `integers` at the top of their bytes (fixed8)
    shifted_up,   ///< `integers_up` at the top of their bytes (bits)
    weights,      ///< fractions, later faded
    ramp,         ///< intermediate result of the S-curve
    cell,         ///< integers of one corner
    part_s,       ///< part of a random number by one coordinate
    part_t,
    part_r,
    mixed,   ///< first of the two results of bits
    corner,  ///< random number of one corner, later weighted
    noise,
    sum,   ///< sum of octaves
    index  ///< index into the colour map
};

/// Operations on the images x (first) and y (second); 1 is the largest number of a fixed8 image.
enum class PassKind {
    fill,         ///< bias everywhere; OpenGL clears, so this is no pass
    cells,        ///< integers of the lattice map after doublings
    places,       ///< fractions of the lattice map after doublings, in [0, 1]
    solid_map,    ///< integers and fractions of the lattice map in 8 bits
    step,         ///< x + 1 for integers x
    copy,         ///< x in the channels of `mask`
    transfer,     ///< scale x + bias, modulo 256 where `wraps` (PixelTransfer)
    combine,      ///< x + (scale y + bias)
    multiply,     ///< x y
    isolate,      ///< channel `axis` of x
    shift_left,   ///< x without its highest bit, doubled
    blend_bit,    ///< 7/8 y + 1/8 of colors[0] or colors[1], by the highest bit of x
    hash,         ///< random number of integers x
    axis_table,   ///< table number `axis` at channel `axis` of x, one further where `upper`
    value_table,  ///< the fourth table at x
    weigh,        ///< x times channel `axis` of y where `upper`, else times 1 less that
    field_index   ///< the colour map's index of quadric + constant + x
};

template <>
inline constexpr auto enum_names<PassImage> = enum_words("none", "solid", "integers", "integers_up",
                                                         "shifted", "shifted_up", "weights", "ramp",
                                                         "cell", "part_s", "part_t", "part_r",
                                                         "mixed", "corner", "noise", "sum",
                                                         "index");
template <>
inline constexpr auto enum_names<PassKind> = enum_words("fill", "cells", "places", "solid_map",
                                                        "step", "copy", "transfer", "combine",
                                                        "multiply", "isolate", "shift_left",
                                                        "blend_bit", "hash", "axis_table",
                                                        "value_table", "weigh", "field_index");

/// A pass over an image; each kind reads some of the members.
struct Pass {
    PassKind kind = PassKind::fill;
    PassImage target = PassImage::none, first = PassImage::none, second = PassImage::none;
    std::size_t stream = 0;
    int doublings = 0;
    unsigned axis = 0;
    bool upper = false, wraps = false;
    std::array<bool, 3> mask{true, true, true};
    float scale = 1.0f, bias = 0.0f;  ///< factor and summand, in units of 1/255 with fixed8
    std::array<float, 2> colors{};
    std::uint32_t seed = 0;
    std::size_t table = 0;
    LatticeBits bits{};
};

/// The passes of a texture with their tables and constants.
struct MultipassPlan {
    MultipassOptions options;
    std::vector<Pass> passes;
    std::vector<RandomTables> tables;  ///< tables in the form that images hold
    Wrap wrap = Wrap::repeat;
    double constant = 0.0;   ///< added to the quadric
    double amplitude = 1.0;  ///< noise for 255/2 units of the sum (fixed8)
};

/// The reason why the papers' passes cannot express the octaves with these options, as the end of a
/// sentence; empty where they can.
std::string no_multipass_form(std::span<const Octave> octaves, const MultipassOptions& options);

/// The octaves of groups, finest first within each group; no_multipass_form must be empty. `boxes`
/// are the boxes of the groups' streams, which fixed8 needs.
std::vector<MultipassOctave> multipass_octaves(std::span<const OctaveGroup> groups,
                                               std::span<const LatticeBox> boxes);

/// The passes from lattice maps to the colour map's index of the field.
MultipassPlan plan_multipass(const MultipassOptions& options,
                             std::span<const MultipassOctave> octaves, double constant, Wrap wrap);

/// The number of passes that draw.
std::size_t count_passes(std::span<const Pass> passes);
/// The number of passes of one octave, including that which adds it to the others.
std::size_t passes_of_octave(const MultipassOptions& options, const MultipassOctave& octave);

/// A pass in words, such as "weigh: corner": what it does and the image that it makes.
std::string words_of(const Pass& pass);

/// Whether the image is RGBA32UI.
bool holds_integers(PassImage image, PassPrecision precision);

}  // namespace burl
