#pragma once
// Shader text in plain GLSL, for people and for engines that do not have its parts: `real` becomes
// float, and unused definitions are left out.
#include <string>
#include <string_view>
#include <vector>

namespace burl {

/// Text that stood behind numbers/real.glsl, in float32 without its macros: `real` types become
/// float types, `exact` is removed, and of #if REAL_IS_DOUBLE the second branch stays.
std::string glsl_in_float(std::string_view text);

/// The top-level definitions that `roots`, names, need, in their order, each with the comment lines
/// right above it. A name counts as used wherever it stands in the code of a definition that is
/// kept; a root that the text does not define needs nothing.
std::string glsl_needed_by(const std::vector<std::string>& roots, std::string_view text);

}  // namespace burl
