#pragma once
// GLSL as text: numbers with all their digits, sums without redundant factors, and shaders as lists
// of parts, so that hand-written functions (shaders/*.glsl) are parts by name. Independent of
// OpenGL.
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "procedural/color/mip_image.h"
#include "procedural/glsl/noise.h"

namespace burl {

/// The type `real` of a shader (shaders/numbers/real.glsl).
enum class GlslReal { float64, float32 };

/// A uniform sampler2D of RGB texels in linear light, float32: level 0 of the image.
struct GlslImage {
    std::string uniform;
    std::shared_ptr<const MipImage> pixels;
};

/// Numbers that a shader reads by `real NAME_at(int i)`, which must follow numbers/real.glsl: by
/// glsl_buffer_tables, or by glsl_constant_tables for shaders without buffers.
struct GlslTable {
    std::string name;
    std::vector<double> numbers;
};

/// A shader's parts from numbers/real.glsl on; the last one defines `real3 texture_color(real3
/// solid)`, linear light at a point of solid space.
struct GlslTexture {
    std::vector<GlslPart> parts;
    std::vector<GlslImage> images;
    std::vector<GlslTable> tables{};
};

/// The functions of tables in buffers of the tables' names: a usamplerBuffer of halves of float64
/// numbers, the lower first, or a samplerBuffer of float32.
std::string glsl_buffer_tables(std::span<const GlslTable> tables, GlslReal real);
/// The functions of tables in constant arrays.
std::string glsl_constant_tables(std::span<const GlslTable> tables, GlslReal real);

/// A finite number with the digits that read it back unchanged, with a point or exponent; followed
/// by "lf" in float64.
std::string glsl_number(double value, GlslReal real);

/// The text of a constant array of numbers, or of vectors of three where `width` is 3, and of the
/// function `real NAME(int i)`, or real3, of its elements. Float64 numbers are kept as their bits:
/// NVIDIA's compiler (580.159) keeps arrays of float64 that a variable indexes in float32.
std::string glsl_array(std::string_view name, std::span<const double> numbers, std::size_t width,
                       GlslReal real);

/// `text` as an operand: in parentheses where it begins with a sign.
std::string glsl_operand(const std::string& text);

/// The sum of factors[i] * terms[i], from left to right, and `constant`, without parts that do not
/// change it (except for the sign of a zero). `terms` are operands.
std::string glsl_sum(const std::vector<double>& factors, const std::vector<std::string>& terms,
                     double constant, GlslReal real);

}  // namespace burl
