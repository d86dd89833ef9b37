#include "app/direct/pass_figure.h"

#include <string_view>

#include <fmt/format.h>

namespace burl {

namespace {

/// A coordinate of the square, from 0 to 16, along "1,0,0" or "0,1,0".
std::string place(std::string_view axis) {
    return fmt::format(R"({{"node":"coordinate","direction":[{}],"offset":8}})", axis);
}

std::string of(std::string_view node, const std::string& input) {
    return fmt::format(R"({{"node":"{}","input":{}}})", node, input);
}

std::string product(const std::string& a, const std::string& b) {
    return fmt::format(R"({{"node":"multiply","a":{},"b":{}}})", a, b);
}

/// Red from s and green from t, whose largest number is brightest.
std::string red_green(const std::string& s, const std::string& t, double largest) {
    const std::string share = fmt::format("{:.6g}", 1.0 / largest);
    return fmt::format(R"({{"node":"combine","red":{},"green":{},"blue":0}})", product(s, share),
                       product(t, share));
}

/// A random number in [0,1] for every cell, of the point times `frequency` plus `phase`. Cell noise
/// has the numbers that value noise has at the lattice points.
std::string cell(std::string_view frequency, std::string_view phase) {
    return fmt::format(
        R"({{"node":"field","noise":[{{"kind":"cell","range":"unit","frequency":[{}],"phase":[{}],"seed":1}}]}})",
        frequency, phase);
}

std::string corner(int i, int j) {
    return cell("1,1,1", fmt::format("{},{},0.5", 8 + i, 8 + j));
}

/// The weight of a corner along one axis: the coordinate's fraction, or what is left of it to 1.
std::string weight(std::string_view axis, int upper) {
    const std::string part = of("fract", place(axis));
    return upper != 0 ? part : fmt::format(R"({{"node":"subtract","a":1,"b":{}}})", part);
}

std::string square(const std::string& texture) {
    return fmt::format(
        "--plane 0,0,1,0 --view 0,0,25.3728 --size 120x120 --unlit --supersample 1 --recipe noise "
        "--set 'texture={}'",
        texture);
}

/// A texture on 4 x 4 cells.
std::string near_square(const std::string& texture) {
    return fmt::format(
        "--plane 0,0,1,0 --view 0,0,6.3432 --size 240x240 --unlit --supersample 1 --recipe noise "
        "--set 'texture={}'",
        texture);
}

}  // namespace

std::vector<std::string> channel_parts() {
    const std::string s = of("fract", place("1,0,0")), t = of("fract", place("0,1,0"));
    return {near_square(red_green(s, t, 1.0)), near_square(product(s, "1")),
            near_square(product(t, "1"))};
}

std::vector<std::string> pass_parts() {
    const std::string_view s = "1,0,0", t = "0,1,0";
    const std::string by_s = cell("1,0,0", "8,0.5,0.5"), by_t = cell("0,1,0", "0.5,8,0.5");
    std::vector<std::string> parts{
        square(red_green(place(s), place(t), 16.0)),
        square(red_green(of("floor", place(s)), of("floor", place(t)), 16.0)),
        square(red_green(of("fract", place(s)), of("fract", place(t)), 1.0)), square(by_s)};
    parts.push_back(square(by_t));
    parts.push_back(
        square(product(fmt::format(R"({{"node":"add","a":{},"b":{}}})", by_s, by_t), "0.5")));
    parts.push_back(square(corner(0, 0)));
    parts.push_back(square(
        R"({"node":"field","noise":[{"kind":"value","fade":"linear","range":"unit","phase":[8,8,0],"seed":1}]})"));
    for (const int j : {0, 1})
        for (const int i : {0, 1}) parts.push_back(square(corner(i, j)));
    for (const int j : {0, 1})
        for (const int i : {0, 1})
            parts.push_back(square(product(corner(i, j), product(weight(s, i), weight(t, j)))));
    return parts;
}

}  // namespace burl
