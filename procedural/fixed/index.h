#pragma once
// The colour map's index of a 1999 texture (Hart et al. 1999, eq. 1 and 2) in 32-bit fixed point
// beside the octaves' float32 sums, for processors to whom float64 is dear: an index that repeats
// wraps around by itself, one that is clamped has room for what lies outside. It errs by little and
// by how much is known, so that colours it cannot decide can be told from the others.
#include <cstdint>
#include <optional>
#include <vector>

#include "procedural/field/octave_groups.h"

namespace burl {

/// A group adds (upper 32 bits of trunc(sum * whole) * factor) * 2^shift to the index.
struct FixedTerm {
    float whole = 1.0f;  ///< a power of two; |sum * whole| stays below 2^31
    std::int32_t factor = 0;
    int shift = 0;
};

struct FixedIndex {
    std::vector<OctaveGroup> groups;
    std::vector<FixedTerm> terms;        ///< of the groups
    std::uint32_t constant = 0;          ///< added to the index: all octaves' offsets
    bool repeats = true;                 ///< modulo 1; else clamped
    int fraction_bits = 32;              ///< index 1 is 2^fraction_bits
    double lowest = 0.0, highest = 0.0;  ///< quadrics beyond alone decide a clamped index
    double error = 0.0;                  ///< units by which an index is off at most
};

/// None for octaves without a hash of their cells (simplex noise, those without a stream kernel),
/// and where the error would be too large to be of use.
std::optional<FixedIndex> fixed_index(const Texture& texture);

/// The error in steps of 2^-step_bits, with what cutting off to whole steps adds.
std::uint32_t fixed_tolerance(const FixedIndex& field, int step_bits);

/// What a texel's index starts from, where no span shows anything.
inline constexpr std::uint32_t no_base = 0x80000000u;

/// The same of a texel where the quadric is q; none where fixed point would not hold it well.
std::optional<std::uint32_t> fixed_base(const FixedIndex& field, double q);

}  // namespace burl
