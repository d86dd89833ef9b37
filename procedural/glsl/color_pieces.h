#pragma once
// Piecewise polynomial colours (graph/value_kernels.h) as GLSL functions: few pieces are found by
// comparisons with constants, many by bisection in a table.
#include <optional>
#include <string>
#include <string_view>

#include "procedural/glsl/text.h"
#include "procedural/graph/value_kernels.h"

namespace burl {

/// The largest number of pieces that are found by comparisons, each of which costs every texel
/// time.
inline constexpr std::size_t most_compared_pieces = 256;

/// A function `real3 NAME(real x)` and the table that it reads.
struct GlslColorPieces {
    std::string text;
    std::optional<GlslTable> table{};
};
GlslColorPieces glsl_color_pieces(const std::string& name, const ColorPieces& pieces,
                                  GlslReal real);

}  // namespace burl
