#pragma once
// Shader text in plain GLSL, for people and for engines that do not have its parts: `real` becomes
// float, and unused definitions are left out.
#include <string>
#include <string_view>

namespace burl {

/// Text that stood behind numbers/real.glsl, in float32 without its macros: `real` types become
/// float types, `exact` is removed, and of #if REAL_IS_DOUBLE the second branch stays.
std::string glsl_in_float(std::string_view text);

/// The top-level definitions that `root`, a name, needs, in their order, each with the comment
/// lines right above it. A name counts as used wherever it stands in the code of a definition that
/// is kept.
std::string glsl_needed_by(std::string_view root, std::string_view text);

}  // namespace burl
