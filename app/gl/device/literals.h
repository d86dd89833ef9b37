#pragma once
// Float64 literals of shaders as their bits, since compilers may read decimals wrongly: NVIDIA's
// (580.159) reads 3.141592653589793lf as the number next to it.
#include <string>
#include <string_view>

namespace burl {

/// The text with every float64 literal (`0.1lf`, `0.1LF`) that float32 does not hold exactly as
/// `packDouble2x32(uvec2(LOW, HIGH))`, a constant expression of the nearest number. Comments are
/// treated like code; lines stay lines.
std::string with_exact_literals(std::string_view glsl);

}  // namespace burl
