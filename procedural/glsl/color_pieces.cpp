#include "procedural/glsl/color_pieces.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

namespace burl {

namespace {

/// The lines of piece i of a function: "begin = ...;", "c0 = real3(...);" and so on.
std::string piece_lines(const ColorPieces& pieces, std::size_t i, GlslReal real) {
    const std::size_t coefficients = pieces.degree + 1;
    const double* piece = &pieces.table[i * pieces.stride()];
    const char* indent = i == 0 ? "    " : "        ";
    const auto number = [&](std::size_t k) { return glsl_number(piece[k], real); };
    std::string lines = fmt::format("{}{}begin = {};\n", indent, i == 0 ? "real " : "", number(0));
    for (std::size_t k = 0; k < coefficients; ++k)
        lines += fmt::format("{}{}c{} = real3({}, {}, {});\n", indent, i == 0 ? "real3 " : "", k,
                             number(1 + k), number(1 + coefficients + k),
                             number(1 + 2 * coefficients + k));
    return lines;
}

/// The lines that find the last piece that begins at or before t. (Comparisons are not nested:
/// llvmpipe fails where more than 80 are.)
std::string compared_lines(const ColorPieces& pieces, GlslReal real) {
    std::string text = piece_lines(pieces, 0, real);
    for (std::size_t i = 1; i < pieces.begins.size(); ++i)
        text += fmt::format("    if (t >= {}) {{\n{}    }}\n", glsl_number(pieces.begins[i], real),
                            piece_lines(pieces, i, real));
    return text;
}

/// The table of the pieces: the begins of all, then the numbers of each.
GlslTable piece_table(const std::string& name, const ColorPieces& pieces) {
    GlslTable table{name + "_pieces", pieces.begins};
    std::ranges::copy(pieces.table, std::back_inserter(table.numbers));
    return table;
}

/// The lines that look a piece up in the table by bisection.
std::string halved_lines(const std::string& table, const ColorPieces& pieces) {
    const std::size_t count = pieces.begins.size(), coefficients = pieces.degree + 1;
    std::string text = fmt::format(
        "    int piece = 0;\n"
        "    for (int jump = {0}; jump > 0; jump /= 2)\n"
        "        if (piece + jump < {1} && t >= {2}_at(min(piece + jump, {3}))) piece += jump;\n"
        "    int at = {1} + {4} * piece;\n"
        "    real begin = {2}_at(at);\n",
        std::bit_floor(count), count, table, count - 1, pieces.stride());
    for (std::size_t k = 0; k < coefficients; ++k)
        text += fmt::format(
            "    real3 c{0} = real3({1}_at(at + {2}), {1}_at(at + {3}), {1}_at(at + {4}));\n", k,
            table, 1 + k, 1 + coefficients + k, 1 + 2 * coefficients + k);
    return text;
}

}  // namespace

GlslColorPieces glsl_color_pieces(const std::string& name, const ColorPieces& pieces,
                                  GlslReal real) {
    const std::size_t coefficients = pieces.degree + 1;
    const bool repeats = pieces.argument == ColorPieces::Argument::repeat;
    GlslColorPieces written;
    if (pieces.begins.size() > most_compared_pieces) written.table = piece_table(name, pieces);
    written.text = fmt::format("real3 {}(real x) {{\n    real t = {}(x);\n", name,
                               repeats ? "repeated_index" : "clamped_index");
    written.text +=
        written.table ? halved_lines(written.table->name, pieces) : compared_lines(pieces, real);
    written.text += "    exact real u = t - begin;\n    exact real3 color = ";
    for (std::size_t k = 0; k + 1 < coefficients; ++k)
        written.text += fmt::format("c{} + u * (", k);
    written.text += fmt::format("c{}{};\n    return color;\n}}\n\n", coefficients - 1,
                                std::string(coefficients - 1, ')'));
    return written;
}

}  // namespace burl
