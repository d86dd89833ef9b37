#pragma once
// Sums of simplex noises as calls of GLSL functions: shaders/noise/simplex_signal.glsl and, with
// gradients, shaders/graph/dual_simplex.glsl.
#include "procedural/glsl/functions.h"
#include "procedural/graph/program.h"

namespace burl {

/// The expression, of type real, of a sum of octaves; `inputs` are its coordinates.
std::string glsl_simplex_sum(const SimplexOctaves& octaves, const std::vector<std::string>& inputs,
                             GlslFunctions& functions);
/// The expression, of type real3, of a field's sum of octaves at the point of three inputs.
std::string glsl_curl_sum(const CurlOctaves& octaves, const std::vector<std::string>& inputs,
                          GlslFunctions& functions);

/// The expression, of type real4, of a sum of octaves with its gradient, over the footprint of two
/// steps, which are expressions of type real3.
std::string glsl_dual_simplex_sum(const SimplexOctaves& octaves,
                                  const std::vector<std::string>& inputs,
                                  const std::array<std::string, 2>& steps,
                                  GlslFunctions& functions);
/// The expression, of type DualVector, of a field's sum of octaves with the gradients.
std::string glsl_dual_curl_sum(const CurlOctaves& octaves, const std::vector<std::string>& inputs,
                               const std::array<std::string, 2>& steps, GlslFunctions& functions);

}  // namespace burl
