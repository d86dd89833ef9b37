// Martin Newell's teapot (1975), from its Bezier control points, which are public. Body, rim, lid
// and bottom are turned profiles: a quarter circle's control points are (1, 0), (1, k), (k, 1), (0,
// 1) times the profile's radius, with Newell's k = 0.56. Handle and spout are rows of half
// sections, mirrored. Together 6 x 4 + 4 + 4 = 32 patches with their bottom, as completed by Crow
// (1987).
#include <array>

#include "assets/make_meshes/model.h"

namespace burl {
namespace {

using Patch = std::array<std::array<Vec3d, 4>, 4>;

struct ProfilePoint {
    double radius, height, k = 0.56;
};

/// Four control points along the pot from the top down.
using Profile = std::array<ProfilePoint, 4>;

constexpr std::array<Profile, 6> turned_profiles{{
    {{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}},  // rim
    {{{1.5, 2.4}, {1.75, 1.875}, {2.0, 1.35}, {2.0, 0.9}}},            // upper body
    {{{2.0, 0.9}, {2.0, 0.45}, {1.5, 0.225}, {1.5, 0.15}}},            // lower body
    {{{0.0, 3.15}, {0.8, 3.15, 0.5625}, {0.0, 2.85}, {0.2, 2.7}}},     // the lid's knob
    {{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}},              // lid
    {{{1.5, 0.15}, {1.5, 0.075}, {1.425, 0.0}, {0.0, 0.0}}},           // bottom
}};

/// Half a section of handle or spout: inner and outer point in the plane of symmetry, half width.
struct Section {
    double inner_x, inner_height, outer_x, outer_height, half_width;
};

/// Seven rows: two patches that share the fourth.
using Tube = std::array<Section, 7>;

constexpr Tube handle{{{-1.6, 2.025, -1.5, 2.25, 0.3},
                       {-2.3, 2.025, -2.5, 2.25, 0.3},
                       {-2.7, 2.025, -3.0, 2.25, 0.3},
                       {-2.7, 1.8, -3.0, 1.8, 0.3},
                       {-2.7, 1.575, -3.0, 1.35, 0.3},
                       {-2.5, 1.125, -2.65, 0.9375, 0.3},
                       {-2.0, 0.9, -1.9, 0.6, 0.3}}};
constexpr Tube spout{{{1.7, 1.425, 1.7, 0.6, 0.66},
                      {2.6, 1.425, 3.1, 0.825, 0.66},
                      {2.3, 2.1, 2.4, 2.025, 0.25},
                      {2.7, 2.4, 3.3, 2.4, 0.25},
                      {2.8, 2.475, 3.525, 2.49375, 0.25},
                      {2.9, 2.475, 3.45, 2.5125, 0.15},
                      {2.8, 2.4, 3.2, 2.4, 0.15}}};

Vec3d evaluate(const Patch& patch, double u, double v) {
    const auto weights = [](double t) {
        const double s = 1.0 - t;
        return std::array<double, 4>{s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
    };
    const std::array<double, 4> row = weights(u), column = weights(v);
    Vec3d sum(0.0);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) sum += row[i] * column[j] * patch[i][j];
    return sum;
}

void add_patch(Model& model, const Patch& patch, int segments) {
    for (int i = 0; i < segments; ++i)
        for (int j = 0; j < segments; ++j) {
            const auto at = [&](int k, int l) {
                return evaluate(patch, double(i + k) / segments, double(j + l) / segments);
            };
            model.quad(at(0, 0), at(1, 0), at(1, 1), at(0, 1));
        }
}

/// The profile turned through quarter `quarter` about the y axis, seen from outside.
Patch turned_patch(const Profile& profile, int quarter) {
    Patch patch;
    for (std::size_t i = 0; i < 4; ++i) {
        const double k = profile[i].k;
        const std::array<std::array<double, 2>, 4> arc{
            {{1.0, 0.0}, {1.0, k}, {k, 1.0}, {0.0, 1.0}}};
        for (std::size_t j = 0; j < 4; ++j) {
            double x = profile[i].radius * arc[j][0], z = -profile[i].radius * arc[j][1];
            for (int turn = 0; turn < quarter; ++turn) {
                const double old_x = x;
                x = z;
                z = -old_x;
            }
            patch[i][j] = Vec3d(x, profile[i].height, z);
        }
    }
    return patch;
}

/// Rows first_row .. first_row + 3, on the side of +z (side = 1) or -z (side = -1).
Patch tube_patch(const Tube& tube, std::size_t first_row, double side) {
    Patch patch;
    for (std::size_t i = 0; i < 4; ++i) {
        const Section& s = tube[first_row + i];
        const double z = side * s.half_width;
        patch[i] = {Vec3d(s.inner_x, s.inner_height, 0.0), Vec3d(s.inner_x, s.inner_height, z),
                    Vec3d(s.outer_x, s.outer_height, z), Vec3d(s.outer_x, s.outer_height, 0.0)};
    }
    return patch;
}

/// The same surface, seen from its other side.
Patch mirrored(const Patch& patch) {
    Patch other = patch;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) other[i][j] = patch[i][3 - j];
    return other;
}

void add_tube(Model& model, const Tube& tube, int segments) {
    for (const std::size_t first_row : {std::size_t{0}, std::size_t{3}}) {
        add_patch(model, mirrored(tube_patch(tube, first_row, 1.0)), segments);
        add_patch(model, tube_patch(tube, first_row, -1.0), segments);
    }
}

}  // namespace

Model make_teapot(int segments) {
    Model model;
    for (const Profile& profile : turned_profiles)
        for (int quarter = 0; quarter < 4; ++quarter)
            add_patch(model, turned_patch(profile, quarter), segments);
    add_tube(model, handle, segments);
    add_tube(model, spout, segments);
    return model;
}

}  // namespace burl
