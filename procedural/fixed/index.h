#pragma once
// The colour map's index of a 1999 texture (Hart et al. 1999, eq. 1 and 2) in 32-bit fixed point
// beside the octaves' float32 sums, for processors on which float64 is slow: an index that repeats
// wraps around by itself, one that is clamped has room for values outside [0, 1]. A bound of its
// error is known, so that colours it cannot decide can be told from the others.
#include <cstdint>
#include <optional>
#include <vector>

#include "procedural/field/octave_groups.h"

namespace burl {

/// The term of a group: it adds (upper 32 bits of trunc(sum * whole) * factor) * 2^shift to the
/// index.
struct FixedTerm {
    float whole = 1.0f;  ///< a power of two; |sum * whole| stays below 2^31
    std::int32_t factor = 0;
    int shift = 0;
};

/// The fixed-point index of a texture.
struct FixedIndex {
    std::vector<OctaveGroup> groups;
    std::vector<FixedTerm> terms;  ///< one per group
    std::uint32_t constant = 0;    ///< sum of all octaves' offsets, added to the index
    bool repeats = true;           ///< whether the index is modulo 1; otherwise it is clamped
    int fraction_bits = 32;        ///< the index 1 is 2^fraction_bits
    /// Range to which quadrics are clamped; beyond it they alone decide a clamped index.
    double lowest = 0.0, highest = 0.0;
    double error = 0.0;  ///< bound of the error of an index, in units
};

/// The fixed-point index of a texture. None if it has octaves without a hash of their cells
/// (simplex noise, octaves without a stream kernel), or where the error would be too large to be of
/// use.
std::optional<FixedIndex> fixed_index(const Texture& texture);

/// The error bound in steps of 2^-step_bits, including the rounding to whole steps.
std::uint32_t fixed_tolerance(const FixedIndex& field, int step_bits);

/// The value in place of a base where no span shows anything.
inline constexpr std::uint32_t no_base = 0x80000000u;

/// The base of a texel, from which its index starts, where the quadric is q; none where fixed point
/// would not hold it well.
std::optional<std::uint32_t> fixed_base(const FixedIndex& field, double q);

}  // namespace burl
