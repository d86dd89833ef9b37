#pragma once
// Noises as GLSL functions: the files of shaders/ that a noise needs, and the function that
// combines them for its kind, fade, feature, periods and time. With float64 in shaders and IEEE
// arithmetic (software OpenGL) they have the host's bits, except for the sign of a zero.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "procedural/noise/fractal_sum.h"
#include "procedural/noise/spec.h"

namespace burl {

/// A part of a shader: a file of shaders/, or text with a name for a compiler's messages.
struct GlslPart {
    std::string name;
    std::string text{};  ///< the text; empty for the file of that name
    bool operator==(const GlslPart&) const = default;
};

/// The parts that must precede the noises' functions, in order: numbers/real.glsl,
/// noise/lattice.glsl and, once each, the kinds' own.
std::vector<GlslPart> glsl_noise_parts(std::span<const NoiseSpec> noises);

/// The further parts of noises with gradients (`..._sample`); they follow those of
/// glsl_noise_parts.
std::vector<GlslPart> glsl_gradient_parts(std::span<const NoiseSpec> noises);

/// The function `float NAME(uint seed, uvec3 cell, vec3 place)` of a noise with has_point_kernel:
/// the bits of kernels/point_noise-inl.h times its unit. The cell counts modulo 2^32, the place
/// from its middle. A `sloped` function gives a vec4, the noise and its derivatives along x, y and
/// z, with the bits of Sample.
std::string glsl_split_noise(const NoiseSpec& noise, std::string_view name, bool sloped = false);

/// The function `float NAME(uint seed, real3 p, real time)` of any noise: the bits of
/// noise_value<float, 3> at p with this seed and, if the noise has a time, this time. A `sloped`
/// function gives a vec4 of the noise and its gradient: the bits of sample_noise<float, 3>.
std::string glsl_site_noise(const NoiseSpec& noise, std::string_view name, bool sloped = false);

/// The names that shaders' functions have for a fade and for a shape.
std::string_view glsl_fade_name(Fade fade);
std::string_view glsl_shape_name(OctaveShape shape);

/// The function `float NAME(float n)` of a shape: n, |n| or (1 - |n|)^2.
std::string glsl_octave_shape(OctaveShape shape, std::string_view name);

}  // namespace burl
