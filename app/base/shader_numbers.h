#pragma once
// A shader's text cut at its floating-point numbers, so that texts can be told to differ by numbers
// alone, and numbers be replaced by expressions.
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burl {

/// The number as a shader in float32 has it.
std::string shader_number(double x);

/// A floating-point number in a text; whole numbers are part of the text around.
struct ShaderNumber {
    std::string spelt;   ///< the number as it stands there, with its sign
    double value = 0.0;  ///< the float32 that it is read as
    bool added = false;  ///< whether its sign is that of a sum or difference, as in "x - 0.5"
};

struct ShaderNumbers {
    std::vector<std::string> around;  ///< the text before each number, and after the last
    std::vector<ShaderNumber> numbers;
};

/// The text cut at its numbers, but for those of comments. A sign belongs to its number, so that
/// "x + 0.5" and "x - 0.5" differ by a number, as do "0.5 * x" and "-0.5 * x".
ShaderNumbers shader_numbers(std::string_view text);

/// Whether the texts differ by numbers alone.
bool same_structure(const ShaderNumbers& a, const ShaderNumbers& b);

/// The text with an expression in the place of each number for which it is not empty. Constants
/// whose definitions get one become variables.
std::string with_expressions(const ShaderNumbers& text, std::span<const std::string> expressions);

}  // namespace burl
