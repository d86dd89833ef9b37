#include "app/bench/svg_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace burl {

namespace {

constexpr double font_size = 11;

}  // namespace

std::string svg_escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return result;
}

double svg_width(std::size_t characters) {
    return 0.62 * font_size * double(characters);
}

std::string svg_line(double x0, double y0, double x1, double y1, std::string_view color) {
    return fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x0, y0,
        x1, y1, color);
}

std::string svg_text(double x, double y, std::string_view anchor, std::string_view text,
                     std::string_view style) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y,
                       anchor, style, svg_escaped(text));
}

std::string decade_text(int exponent) {
    if (exponent >= 0 && exponent <= 4) return std::to_string(std::lround(std::pow(10, exponent)));
    if (exponent == -1) return "0.1";
    if (exponent == -2) return "0.01";
    return fmt::format("1e{}", exponent);
}

std::string svg_document(double width, double height, std::string_view body) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"{2}\" "
        "fill=\"#000000\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{3}</svg>\n",
        width, height, font_size, body);
}

std::string SvgLabels::place(double x, double y, std::string_view text) {
    const double half_width = 0.5 * svg_width(text.size()), half_height = 0.4 * font_size;
    for (double away = 11; away < 200; away += 3)
        for (int turn = 0; turn < 16; ++turn) {
            const double angle = std::numbers::pi * (0.25 + turn / 8.0);
            const double cx = x + away * std::cos(angle), cy = y - away * std::sin(angle);
            const SvgBox box{cx - half_width, cy - half_height, cx + half_width, cy + half_height};
            const bool inside = box.left >= within_.left && box.right <= within_.right &&
                                box.top >= within_.top && box.bottom <= within_.bottom;
            if (!inside || std::ranges::any_of(
                               taken_, [&](const SvgBox& other) { return box.overlaps(other); }))
                continue;
            taken_.push_back(box);
            const std::string line =
                away > 14 ? svg_line(x + 6 * std::cos(angle), y - 6 * std::sin(angle),
                                     x + (away - 5) * std::cos(angle),
                                     y - (away - 5) * std::sin(angle), "#999999")
                          : std::string();
            return line + svg_text(cx, cy + half_height, "middle", text);
        }
    return {};
}

}  // namespace burl
