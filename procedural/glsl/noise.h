#pragma once
// Noises as GLSL functions: which files of shaders/ hold what a noise needs, and the function that
// ties them together for its kind, fade, feature, periods and time. With float64 in shaders and
// IEEE arithmetic (software OpenGL) they have the host's bits, but for the sign of a zero.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "procedural/noise/fractal_sum.h"
#include "procedural/noise/spec.h"

namespace burl {

/// A part of a shader: a file of shaders/, or text of a name for a compiler's messages.
struct GlslPart {
    std::string name;
    std::string text{};  ///< empty: the file of that name
    bool operator==(const GlslPart&) const = default;
};

/// What stands before the noises' functions, in order: numbers/real.glsl, noise/lattice.glsl and,
/// once each, the kinds' own.
std::vector<GlslPart> glsl_noise_parts(std::span<const NoiseSpec> noises);

/// What noises with gradients (`..._sample`) need besides, behind all of those.
std::vector<GlslPart> glsl_gradient_parts(std::span<const NoiseSpec> noises);

/// `float NAME(uint seed, uvec3 cell, vec3 place)` for a noise with has_point_kernel: the bits of
/// point_noise-inl.h times its unit. The cell counts modulo 2^32, the place from its middle.
std::string glsl_split_noise(const NoiseSpec& noise, std::string_view name);

/// `vec4 NAME(uint seed, uvec3 cell, vec3 place)`: the noise and its derivatives along x, y and z,
/// with the bits of point_noise-inl.h's Sample times its unit.
std::string glsl_split_sample(const NoiseSpec& noise, std::string_view name);

/// `float NAME(uint seed, real3 p, real time)` for every noise: the bits of noise_value<float, 3>
/// at p, with that seed and, if the noise has a time, that one.
std::string glsl_site_noise(const NoiseSpec& noise, std::string_view name);

/// `vec4 NAME(uint seed, real3 p, real time)`: the same with its gradient, as sample_noise<float,
/// 3> has it.
std::string glsl_site_sample(const NoiseSpec& noise, std::string_view name);

/// `float NAME(float n)`: n, |n| or (1 - |n|)^2.
std::string glsl_octave_shape(OctaveShape shape, std::string_view name);

}  // namespace burl
