#pragma once
// Meshes with a known topology for the patch tests, whole meshes as patches, and checks of a patch
// and a map that use only their definitions.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

#include "atlas/chart/patch.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl::made {

/// Returns columns x rows squares bent into an open tube about z: two loops, no handle.
inline Mesh tube(std::uint32_t columns, std::uint32_t rows, double height) {
    std::vector<Vec3d> positions;
    std::vector<Triangle> triangles;
    for (std::uint32_t y = 0; y <= rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x) {
            const double angle = 2.0 * std::numbers::pi * x / columns;
            positions.push_back({std::cos(angle), std::sin(angle), height * y / rows});
        }
    for (std::uint32_t y = 0; y < rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x) {
            const std::uint32_t a = y * columns + x, b = y * columns + (x + 1) % columns;
            triangles.push_back({a, b, a + columns});
            triangles.push_back({b, b + columns, a + columns});
        }
    return mesh_of(positions, triangles);
}

/// Returns a closed ring: no loop, one handle.
inline Mesh ring(std::uint32_t columns, std::uint32_t rows) {
    std::vector<Vec3d> positions;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < columns; ++i)
        for (std::uint32_t j = 0; j < rows; ++j) {
            const double a = 2.0 * std::numbers::pi * i / columns,
                         b = 2.0 * std::numbers::pi * j / rows, r = 1.0 + 0.3 * std::cos(b);
            positions.push_back({r * std::cos(a), r * std::sin(a), 0.3 * std::sin(b)});
        }
    for (std::uint32_t i = 0; i < columns; ++i)
        for (std::uint32_t j = 0; j < rows; ++j) {
            const std::uint32_t a = i * rows + j, b = (i + 1) % columns * rows + j;
            const std::uint32_t c = (i + 1) % columns * rows + (j + 1) % rows,
                                d = i * rows + (j + 1) % rows;
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    return mesh_of(positions, triangles);
}

/// Returns a closed box of sides 1 x 2 x 3, with n x n squares on each side and shared points.
inline Mesh box(std::uint32_t n) {
    std::vector<Vec3d> positions;
    std::vector<Triangle> triangles;
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> ids;
    const auto id = [&](std::array<std::uint32_t, 3> at) {
        const auto [place, fresh] =
            ids.try_emplace(at, static_cast<std::uint32_t>(positions.size()));
        if (fresh) positions.push_back(Vec3d(at[0], 2.0 * at[1], 3.0 * at[2]) / double(n));
        return place->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const std::uint32_t level : {0u, n})
            for (std::uint32_t i = 0; i < n; ++i)
                for (std::uint32_t j = 0; j < n; ++j) {
                    const auto at = [&](std::uint32_t x, std::uint32_t y) {
                        std::array<std::uint32_t, 3> p{};
                        p[axis] = level;
                        p[(axis + 1) % 3] = x;
                        p[(axis + 2) % 3] = y;
                        return id(p);
                    };
                    const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1),
                                        d = at(i, j + 1);
                    if (level == n)
                        triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
                    else
                        triangles.insert(triangles.end(), {{a, c, b}, {a, d, c}});
                }
    return mesh_of(positions, triangles);
}

inline Patch patch_of(const Mesh& mesh, const std::vector<std::uint32_t>& faces) {
    std::vector<std::int32_t> local(mesh.triangles.size(), -1);
    return extract_patch(mesh, build_connectivity(mesh), faces, local);
}

inline Patch whole(const Mesh& mesh) {
    std::vector<std::uint32_t> faces(mesh.triangles.size());
    std::iota(faces.begin(), faces.end(), 0u);
    return patch_of(mesh, faces);
}

/// Returns a disk grown at random on a bumpy sheet: ragged, with ears.
inline Patch random_disk(std::uint32_t seed, std::size_t faces) {
    Mesh mesh = grid(20, 20);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> jitter(-0.015, 0.015);
    for (Vec3d& p : mesh.positions) p += Vec3d{jitter(random), jitter(random), jitter(random)};
    const Connectivity connectivity = build_connectivity(mesh);
    std::vector<std::uint32_t> chosen{static_cast<std::uint32_t>(random() % mesh.triangles.size())};
    std::vector<std::int32_t> local(mesh.triangles.size(), -1);
    while (chosen.size() < faces) {
        const std::uint32_t from = chosen[random() % chosen.size()];
        const std::int32_t n = connectivity.neighbours[from][random() % 3];
        if (n < 0) continue;
        const auto next = static_cast<std::uint32_t>(n);
        if (std::find(chosen.begin(), chosen.end(), next) != chosen.end()) continue;
        chosen.push_back(next);
        if (!topology_of(extract_patch(mesh, connectivity, chosen, local)).is_disk())
            chosen.pop_back();
    }
    return extract_patch(mesh, connectivity, chosen, local);
}

/// Expects that neighbours and vertices agree with each other, and that the loops hold every border
/// half-edge once.
inline void expect_sound(const Patch& patch) {
    ASSERT_EQ(patch.points.size(), patch.origins.size());
    ASSERT_EQ(patch.triangles.size(), patch.neighbours.size());
    ASSERT_EQ(patch.triangles.size(), patch.faces.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, HalfEdge> edges;
    std::size_t border = 0;
    for (HalfEdge h = 0; h < 3 * patch.triangles.size(); ++h) {
        EXPECT_TRUE(edges.emplace(std::pair(patch.start(h), patch.end(h)), h).second);
        border += patch.on_border(h);
    }
    for (const auto& [ends, h] : edges) {
        const auto other = edges.find({ends.second, ends.first});
        EXPECT_EQ(patch.on_border(h), other == edges.end());
        if (other != edges.end() && !patch.on_border(h)) {
            EXPECT_EQ(patch.across(h), other->second);
        }
    }
    std::size_t in_loops = 0;
    std::vector<int> seen(patch.points.size(), 0);
    for (const auto& loop : patch.loops) {
        in_loops += loop.size();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            EXPECT_TRUE(patch.on_border(loop[i]));
            EXPECT_EQ(patch.end(loop[i]), patch.start(loop[(i + 1) % loop.size()]));
            EXPECT_EQ(++seen[patch.start(loop[i])], 1);
        }
    }
    EXPECT_EQ(in_loops, border);
}

/// Returns the signed area of a triangle in the unit square.
inline double uv_area(const Patch& patch, const std::vector<Vec2d>& uv, std::size_t t) {
    const Triangle& v = patch.triangles[t];
    const Vec2d a = uv[v[1]] - uv[v[0]], b = uv[v[2]] - uv[v[0]];
    return 0.5 * (a.x * b.y - a.y * b.x);
}

/// Expects a one-to-one map: no triangle is flipped, and together they fill the unit square once.
inline void expect_fills_square(const Patch& patch, const std::vector<Vec2d>& uv) {
    double sum = 0.0;
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
        EXPECT_GT(uv_area(patch, uv, t), 0.0) << t;
        sum += uv_area(patch, uv, t);
    }
    EXPECT_NEAR(sum, 1.0, 1e-9);
}

/// Whether a point lies on the mesh, within `far`.
inline bool lies_on(const Mesh& mesh, const Vec3d& q, double far) {
    for (const Triangle& t : mesh.triangles) {
        const Vec3d a = mesh.positions[t[0]], u = mesh.positions[t[1]] - a,
                    v = mesh.positions[t[2]] - a;
        const Vec3d n = glm::cross(u, v), w = q - a;
        if (std::abs(glm::dot(w, glm::normalize(n))) > far) continue;
        const double i = glm::dot(glm::cross(w, v), n) / glm::dot(n, n),
                     j = glm::dot(glm::cross(u, w), n) / glm::dot(n, n);
        if (i > -1e-9 && j > -1e-9 && i + j < 1.0 + 1e-9) return true;
    }
    return false;
}

}  // namespace burl::made
