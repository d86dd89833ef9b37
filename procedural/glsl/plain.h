#pragma once
// Shader text made plain, for people and for engines that know nothing of its parts: `real` becomes
// float, and what a shader does not use is left out.
#include <string>
#include <string_view>

namespace burl {

/// Text that stood behind numbers/real.glsl, in float32 without its macros: `real` types are float
/// types, `exact` goes, of #if REAL_IS_DOUBLE the second branch stays.
std::string glsl_in_float(std::string_view text);

/// The top-level definitions that `root`, a name, needs, in their order, each with the comment
/// lines right above it. Names count as used wherever they stand in the text of what is kept.
std::string glsl_needed_by(std::string_view root, std::string_view text);

}  // namespace burl
