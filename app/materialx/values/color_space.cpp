#include "app/materialx/values/color_space.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burl::materialx {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

/// A space: a curve to linear light, and then a matrix to the primaries of Rec. 709.
struct Space {
    std::string_view name;
    double (*curve)(double);
    Matrix to_rec709;
};

constexpr Matrix identity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// The primaries AP1 of ACES, white adapted by Bradford's transform.
constexpr Matrix from_ap1{{{1.705050992658, -0.621792120657, -0.083258872001},
                           {-0.130256417507, 1.140804736575, -0.010548319068},
                           {-0.024003356805, -0.128968976065, 1.152972332870}}};
constexpr Matrix from_adobe_rgb{
    {{1.39835574, -0.39835574, 0}, {0, 1, 0}, {0, -0.04292899, 1.04292899}}};
constexpr Matrix from_display_p3{{{1.22494018, -0.22494018, 0},
                                  {-0.04205695, 1.04205695, 0},
                                  {-0.01963755, -0.07863605, 1.09827360}}};

double linear(double x) {
    return x;
}
/// IEC 61966-2-1.
double srgb(double x) {
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}
double gamma_18(double x) {
    return std::pow(std::max(x, 0.0), 1.8);
}
double gamma_22(double x) {
    return std::pow(std::max(x, 0.0), 2.2);
}
double gamma_24(double x) {
    return std::pow(std::max(x, 0.0), 2.4);
}
/// Adobe RGB (1998), 4.3.4.2.
double adobe(double x) {
    return std::pow(std::max(x, 0.0), 563.0 / 256.0);
}

constexpr std::array spaces{Space{"", linear, identity},
                            Space{"lin_rec709", linear, identity},
                            Space{"raw", linear, identity},
                            Space{"none", linear, identity},
                            Space{"srgb_texture", srgb, identity},
                            Space{"g18_rec709", gamma_18, identity},
                            Space{"g22_rec709", gamma_22, identity},
                            Space{"rec709_display", gamma_24, identity},
                            Space{"acescg", linear, from_ap1},
                            Space{"lin_ap1", linear, from_ap1},
                            Space{"g22_ap1", gamma_22, from_ap1},
                            Space{"adobergb", adobe, from_adobe_rgb},
                            Space{"lin_adobergb", linear, from_adobe_rgb},
                            Space{"srgb_displayp3", srgb, from_display_p3},
                            Space{"lin_displayp3", linear, from_display_p3}};

}  // namespace

bool is_linear(std::string_view space) {
    const auto found = std::ranges::find(spaces, space, &Space::name);
    return found != spaces.end() && found->curve == linear && found->to_rec709 == identity;
}

bool to_linear(std::string_view space, std::vector<double>& color) {
    const auto found = std::ranges::find(spaces, space, &Space::name);
    if (found == spaces.end()) return false;
    std::array<double, 3> light{};
    for (std::size_t c = 0; c < 3; ++c) light[c] = found->curve(color[c]);
    for (std::size_t c = 0; c < 3; ++c) {
        const auto& row = found->to_rec709[c];
        color[c] = row[0] * light[0] + row[1] * light[1] + row[2] * light[2];
    }
    return true;
}

}  // namespace burl::materialx
