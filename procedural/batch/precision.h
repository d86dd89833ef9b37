#pragma once
// The arithmetic in which a texture is computed: the precision tests of Hart et al. 1999 (section
// 4.3, figure 10) ask how many bits a texture coordinate needs. A plain comparable value, part of
// the recipe.
#include <optional>

#include "atlas/base/enum_names.h"

namespace burl {

enum class PrecisionKind { float32, float64, fixed };
template <>
inline constexpr auto enum_names<PrecisionKind> = enum_words("float32", "float64", "fixed");

/// The fixed-point format I.F: two's complement numbers of I + F bits, F of them after the point,
/// from -2^(I-1) up to 2^(I-1) in steps of 2^-F.
struct FixedFormat {
    unsigned integer_bits = 8;   ///< I, 1 to 16
    unsigned fraction_bits = 8;  ///< F, 2 to 16
    bool operator==(const FixedFormat&) const = default;
};

struct Precision {
    /// The arithmetic; where absent, float32 for bakes and float64 for pictures of the exact
    /// texture.
    std::optional<PrecisionKind> kind{};
    FixedFormat format;  ///< the format of `fixed`
    bool operator==(const Precision&) const = default;
};

}  // namespace burl
