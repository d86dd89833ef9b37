// A chess king off the lathe, in the manner of the model in figure 6 of Carr and Hart (2001): its
// stem and head are single tall bands, so their triangles are slivers of 30:1, and the rings
// between the collars are as thin the other way. The cross on top is a shell of its own.
#include <cmath>
#include <numbers>
#include <utility>

#include "assets/make_meshes/model.h"

namespace burl {
namespace {

/// Radius and height, from the edge of the foot up; the two ends are closed onto the axis.
constexpr std::array<std::pair<double, double>, 28> profile{
    {{1.55, 0.00}, {1.65, 0.06}, {1.65, 0.45}, {1.55, 0.55}, {1.40, 0.70}, {1.38, 0.78},
     {1.30, 0.84}, {1.05, 1.10}, {0.90, 1.50}, {0.78, 2.10}, {0.70, 2.90}, {0.60, 5.60},
     {0.62, 5.70}, {0.95, 5.78}, {1.00, 5.86}, {0.95, 5.94}, {0.72, 6.00}, {0.72, 6.06},
     {0.88, 6.12}, {0.88, 6.20}, {0.66, 6.28}, {1.00, 7.50}, {1.06, 7.56}, {1.06, 7.57},
     {1.02, 7.64}, {0.60, 7.90}, {0.25, 8.02}, {0.12, 8.05}}};
constexpr double foot_height = 0.0, crown_height = 8.06;

void add_lathed(Model& model, int segments) {
    const auto at = [&](std::size_t ring, int i) {
        const double angle = 2.0 * std::numbers::pi * (i % segments) / segments;
        const auto [radius, height] = profile[ring];
        return Vec3d(radius * std::cos(angle), height, -radius * std::sin(angle));
    };
    const std::size_t last = profile.size() - 1;
    for (int i = 0; i < segments; ++i) {
        model.triangle(Vec3d(0.0, foot_height, 0.0), at(0, i + 1), at(0, i));
        for (std::size_t ring = 0; ring < last; ++ring)
            model.quad(at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i));
        model.triangle(Vec3d(0.0, crown_height, 0.0), at(last, i), at(last, i + 1));
    }
}

/// A cross of five squares' outline, a little sunk into the crown.
void add_cross(Model& model) {
    constexpr double arm = 0.13, reach = 0.42, depth = 0.10, centre = 8.55, foot = 8.00,
                     head = 9.00;
    constexpr std::array<std::pair<double, double>, 12> outline{{{arm, foot},
                                                                 {arm, centre - arm},
                                                                 {reach, centre - arm},
                                                                 {reach, centre + arm},
                                                                 {arm, centre + arm},
                                                                 {arm, head},
                                                                 {-arm, head},
                                                                 {-arm, centre + arm},
                                                                 {-reach, centre + arm},
                                                                 {-reach, centre - arm},
                                                                 {-arm, centre - arm},
                                                                 {-arm, foot}}};
    constexpr std::array<std::array<std::size_t, 4>, 5> squares{
        {{0, 1, 10, 11}, {2, 3, 4, 1}, {5, 6, 7, 4}, {8, 9, 10, 7}, {1, 4, 7, 10}}};
    const auto at = [&](std::size_t i, double z) {
        const auto [x, y] = outline[i % outline.size()];
        return Vec3d(x, y, z);
    };
    for (const auto& [a, b, c, d] : squares) {
        model.quad(at(a, depth), at(b, depth), at(c, depth), at(d, depth));
        model.quad(at(d, -depth), at(c, -depth), at(b, -depth), at(a, -depth));
    }
    for (std::size_t i = 0; i < outline.size(); ++i)
        model.quad(at(i, depth), at(i, -depth), at(i + 1, -depth), at(i + 1, depth));
}

}  // namespace

Model make_king(int segments) {
    Model model;
    add_lathed(model, segments);
    add_cross(model);
    return model;
}

}  // namespace burl
