// A chess king off the lathe, after the piece with slivers on its cross of figure 6 in Carr and
// Hart (2001). Here the cross has bevels a hundredth as wide as it is tall, stem and head are
// single tall bands of slivers of 30:1, and the rings of the collars are thin the other way. The
// cross is a shell of its own.
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

using Outline = std::array<std::pair<double, double>, 12>;

/// The cross seen from the front, moved inwards by `inset`, counter-clockwise from the foot.
constexpr Outline cross_outline(double inset) {
    constexpr double centre = 8.55;
    const double arm = 0.13 - inset, reach = 0.42 - inset, foot = 8.00 + inset, head = 9.00 - inset;
    const double low = centre - arm, high = centre + arm;
    return {{{arm, foot},
             {arm, low},
             {reach, low},
             {reach, high},
             {arm, high},
             {arm, head},
             {-arm, head},
             {-arm, high},
             {-reach, high},
             {-reach, low},
             {-arm, low},
             {-arm, foot}}};
}

void add_cross_band(Model& model, double front_inset, double front, double back_inset,
                    double back) {
    const Outline near = cross_outline(front_inset), far = cross_outline(back_inset);
    const auto at = [](const Outline& outline, std::size_t i, double z) {
        const auto [x, y] = outline[i % outline.size()];
        return Vec3d(x, y, z);
    };
    for (std::size_t i = 0; i < near.size(); ++i)
        model.quad(at(near, i, front), at(far, i, back), at(far, i + 1, back),
                   at(near, i + 1, front));
}

/// A little sunk into the crown. Its edges are bevelled: slivers along every side, between flat
/// faces of five quads each.
void add_cross(Model& model) {
    constexpr double depth = 0.10, bevel = 0.008;
    constexpr std::array<std::array<std::size_t, 4>, 5> quads{
        {{0, 1, 10, 11}, {2, 3, 4, 1}, {5, 6, 7, 4}, {8, 9, 10, 7}, {1, 4, 7, 10}}};
    const Outline face = cross_outline(bevel);
    const auto at = [&](std::size_t i, double z) {
        return Vec3d(face[i].first, face[i].second, z);
    };
    for (const auto& [a, b, c, d] : quads) {
        model.quad(at(a, depth), at(b, depth), at(c, depth), at(d, depth));
        model.quad(at(d, -depth), at(c, -depth), at(b, -depth), at(a, -depth));
    }
    add_cross_band(model, bevel, depth, 0.0, depth - bevel);
    add_cross_band(model, 0.0, depth - bevel, 0.0, bevel - depth);
    add_cross_band(model, 0.0, bevel - depth, bevel, -depth);
}

}  // namespace

Model make_king(int segments) {
    Model model;
    add_lathed(model, segments);
    add_cross(model);
    return model;
}

}  // namespace burl
