#include "procedural/glsl/text.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace burl {

std::string glsl_number(double value, GlslReal real) {
    std::string text =
        real == GlslReal::float64 ? fmt::format("{}", value) : fmt::format("{}", float(value));
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    if (real == GlslReal::float64) text += "lf";
    return text;
}

namespace {

/// The bits of a float64 number, its lower half first.
std::string bits_text(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return fmt::format("uvec2({:#x}u, {:#x}u)", std::uint32_t(bits), bits >> 32);
}

}  // namespace

std::string glsl_array(std::string_view name, std::span<const double> numbers, std::size_t width,
                       GlslReal real) {
    const bool bits = real == GlslReal::float64;
    std::vector<std::string> items;
    for (const double x : numbers) items.push_back(bits ? bits_text(x) : glsl_number(x, real));
    const auto element = [&](const std::string& place) {
        return bits ? fmt::format("packDouble2x32({}_items[{}])", name, place)
                    : fmt::format("{}_items[{}]", name, place);
    };
    const std::string value = width == 1 ? element("i")
                                         : fmt::format("real3({}, {}, {})", element("3 * i"),
                                                       element("3 * i + 1"), element("3 * i + 2"));
    return fmt::format(
        "const {0} {1}_items[{2}] = {0}[{2}](\n    {3});\n{4} {1}(int i) {{\n    "
        "return {5};\n}}\n\n",
        bits ? "uvec2" : "float", name, items.size(), fmt::join(items, ",\n    "),
        width == 1 ? "real" : "real3", value);
}

std::string glsl_operand(const std::string& text) {
    return text.starts_with('-') ? fmt::format("({})", text) : text;
}

std::string glsl_sum(const std::vector<double>& factors, const std::vector<std::string>& terms,
                     double constant, GlslReal real) {
    std::string sum;
    const auto add = [&](bool negative, const std::string& term) {
        const char* sign = sum.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
        sum += sign;
        sum += term;
    };
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const double size = std::abs(factors[i]);
        add(factors[i] < 0.0,
            size == 1.0 ? terms[i] : fmt::format("{} * {}", glsl_number(size, real), terms[i]));
    }
    if (constant != 0.0 || sum.empty()) add(constant < 0.0, glsl_number(std::abs(constant), real));
    return sum;
}

std::string glsl_buffer_tables(std::span<const GlslTable> tables, GlslReal real) {
    std::string text;
    for (const GlslTable& table : tables)
        text += real == GlslReal::float64
                    ? fmt::format(
                          "uniform usamplerBuffer {0};\n"
                          "double {0}_at(int i) {{ return packDouble2x32(texelFetch({0}, i).xy); "
                          "}}\n",
                          table.name)
                    : fmt::format(
                          "uniform samplerBuffer {0};\n"
                          "float {0}_at(int i) {{ return texelFetch({0}, i).x; }}\n",
                          table.name);
    return text;
}

std::string glsl_constant_tables(std::span<const GlslTable> tables, GlslReal real) {
    std::string text;
    for (const GlslTable& table : tables) {
        // By fours: NVIDIA's compiler takes about 2,270 numbers in a constructor.
        std::vector<std::string> fours;
        for (std::size_t i = 0; i < table.numbers.size(); i += 4) {
            std::array<std::string, 4> four;
            for (std::size_t k = 0; k < 4; ++k)
                four[k] =
                    glsl_number(i + k < table.numbers.size() ? table.numbers[i + k] : 0.0, real);
            fours.push_back(fmt::format("real4({})", fmt::join(four, ", ")));
        }
        text += fmt::format(
            "const real4 {0}[{1}] = real4[{1}](\n    {2});\n\n"
            "real {0}_at(int i) {{\n    return {0}[i / 4][i % 4];\n}}\n\n",
            table.name, fours.size(), fmt::join(fours, ",\n    "));
    }
    return text;
}

}  // namespace burl
