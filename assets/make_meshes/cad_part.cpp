// What a CAD program hands over: a plate with rounded corners, filleted edges and two bores, all
// flat parts covered by as few and as thin triangles as possible. Fillet bands along the straight
// sides are slivers of well over 100:1. Genus 2.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "assets/make_meshes/model.h"

namespace burl {
namespace {

constexpr double half_length = 2.0, half_width = 1.0, half_thickness = 0.25;
constexpr double corner_radius = 0.4, fillet_radius = 0.1;
constexpr int corner_segments = 12;

struct Bore {
    double x, radius;
    int segments;
};
constexpr Bore left_bore{-1.0, 0.55, 48}, right_bore{1.0, 0.3, 32};

struct Point2 {
    double x, z;
};
using Loop = std::vector<Point2>;

Vec3d at_height(const Point2& p, double height) {
    return {p.x, height, p.z};
}

double distance(const Point2& a, const Point2& b) {
    return std::hypot(a.x - b.x, a.z - b.z);
}

/// The plate's outline moved inwards, counter-clockwise seen from +y (from +x towards -z), with the
/// points where x = 0 crosses it, so that the flat faces can be cut there.
Loop outline(double inset) {
    Loop loop;
    const double radius = corner_radius - inset;
    for (int corner = 0; corner < 4; ++corner) {
        const double sx = corner == 0 || corner == 3 ? 1.0 : -1.0, sz = corner < 2 ? -1.0 : 1.0;
        for (int i = 0; i <= corner_segments; ++i) {
            const double angle = std::numbers::pi / 2.0 * (corner + double(i) / corner_segments);
            loop.push_back({sx * (half_length - corner_radius) + radius * std::cos(angle),
                            sz * (half_width - corner_radius) - radius * std::sin(angle)});
        }
        if (corner == 0) loop.push_back({0.0, -(half_width - inset)});
        if (corner == 2) loop.push_back({0.0, half_width - inset});
    }
    return loop;
}

Loop circle(const Bore& bore) {
    Loop loop;
    for (int i = 0; i < bore.segments; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / bore.segments;
        loop.push_back({bore.x + bore.radius * std::cos(angle), -bore.radius * std::sin(angle)});
    }
    return loop;
}

/// The plate's half on one side of x = 0.
Loop half_of(const Loop& loop, double side) {
    Loop half;
    std::copy_if(loop.begin(), loop.end(), std::back_inserter(half),
                 [&](const Point2& p) { return side * p.x >= 0.0; });
    // The points of the right half do not follow each other: begin after the gap.
    const auto gap = std::adjacent_find(half.begin(), half.end(), [](const auto& a, const auto& b) {
        return a.x == 0.0 && b.x == 0.0;
    });
    if (gap != half.end()) std::rotate(half.begin(), gap + 1, half.end());
    return half;
}

/// Covers the ring between two loops that run the same way, going round both at once and always
/// taking the shorter of the two possible cuts; up = 1 faces +y, -1 faces -y.
void add_ring(Model& model, const Loop& outer, Loop inner, double height, double up) {
    const auto nearest = std::min_element(inner.begin(), inner.end(), [&](auto& a, auto& b) {
        return distance(a, outer[0]) < distance(b, outer[0]);
    });
    std::rotate(inner.begin(), nearest, inner.end());
    const auto add = [&](const Point2& a, const Point2& b, const Point2& c) {
        if (up > 0.0)
            model.triangle(at_height(a, height), at_height(b, height), at_height(c, height));
        else
            model.triangle(at_height(a, height), at_height(c, height), at_height(b, height));
    };
    const std::size_t n = outer.size(), m = inner.size();
    for (std::size_t i = 0, j = 0; i < n || j < m;) {
        const Point2 &o = outer[i % n], &next_o = outer[(i + 1) % n];
        const Point2 &p = inner[j % m], &next_p = inner[(j + 1) % m];
        const bool step_outer = j == m || (i < n && distance(next_o, p) < distance(o, next_p));
        if (step_outer) {
            add(o, next_o, p);
            ++i;
        } else {
            add(o, next_p, p);
            ++j;
        }
    }
}

void add_band(Model& model, const Loop& low, double low_height, const Loop& high,
              double high_height) {
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::size_t j = (i + 1) % low.size();
        model.quad(at_height(low[i], low_height), at_height(low[j], low_height),
                   at_height(high[j], high_height), at_height(high[i], high_height));
    }
}

/// The rim from the bottom face's edge to the top face's: fillet, straight side, fillet.
void add_rim(Model& model, int fillet_segments) {
    struct Level {
        double inset, height;
    };
    std::vector<Level> levels;
    for (int i = 0; i <= fillet_segments; ++i) {
        const double angle = std::numbers::pi / 2.0 * i / fillet_segments;
        levels.push_back({fillet_radius * (1.0 - std::sin(angle)),
                          half_thickness - fillet_radius * (1.0 - std::cos(angle))});
    }
    // The lower half mirrors the upper one, point for point.
    for (std::size_t i = 0; i + 1 < levels.size(); ++i)
        for (const double side : {1.0, -1.0}) {
            const Level& low = levels[side > 0.0 ? i + 1 : i];
            const Level& high = levels[side > 0.0 ? i : i + 1];
            add_band(model, outline(low.inset), side * low.height, outline(high.inset),
                     side * high.height);
        }
    add_band(model, outline(levels.back().inset), -levels.back().height,
             outline(levels.back().inset), levels.back().height);
}

}  // namespace

Model make_cad_part(int fillet_segments) {
    Model model;
    const Loop edge = outline(fillet_radius);
    for (const Bore& bore : {left_bore, right_bore}) {
        const Loop half = half_of(edge, bore.x < 0.0 ? -1.0 : 1.0), hole = circle(bore);
        add_ring(model, half, hole, half_thickness, 1.0);
        add_ring(model, half, hole, -half_thickness, -1.0);
        add_band(model, hole, half_thickness, hole, -half_thickness);
    }
    add_rim(model, fillet_segments);
    return model;
}

}  // namespace burl
