#pragma once
// Piecewise polynomial colours (value_kernels.h) as GLSL functions: few pieces are told apart by
// comparisons with constants, many are found in a table by halving.
#include <optional>
#include <string>
#include <string_view>

#include "procedural/glsl/text.h"
#include "procedural/graph/value_kernels.h"

namespace burl {

/// Pieces that are told apart by comparisons, each of which costs every texel its time.
inline constexpr std::size_t most_compared_pieces = 256;

/// `real3 NAME(real x)` and the table that it reads.
struct GlslColorPieces {
    std::string text;
    std::optional<GlslTable> table{};
};
GlslColorPieces glsl_color_pieces(const std::string& name, const ColorPieces& pieces,
                                  GlslReal real);

}  // namespace burl
