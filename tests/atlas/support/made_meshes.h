#pragma once
// Meshes made by the tests, and neighbours found by sorting edges, independent of the half-edge
// structure.
#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"

namespace burl::made {

inline Mesh mesh_of(std::vector<Vec3d> positions, std::vector<Triangle> triangles) {
    Mesh mesh;
    mesh.name = "made";
    mesh.positions = std::move(positions);
    mesh.triangles = std::move(triangles);
    mesh.parts.push_back({"made", 0, static_cast<std::uint32_t>(mesh.triangles.size())});
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) mesh.source_faces.push_back(t);
    return mesh;
}

/// Returns the neighbours of all triangles: those that share an edge no third triangle has.
inline Connectivity neighbours_by_brute_force(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::pair<std::size_t, int>>>
        edges;
    Connectivity connectivity;
    connectivity.neighbours.assign(mesh.triangles.size(), {-1, -1, -1});
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle& f = mesh.triangles[t];
        if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0]) continue;
        for (int k = 0; k < 3; ++k)
            edges[std::minmax(f[std::size_t(k)], f[std::size_t((k + 1) % 3)])].push_back({t, k});
    }
    for (const auto& [edge, sides] : edges) {
        if (sides.size() != 2 || sides[0].first == sides[1].first) continue;
        for (std::size_t s : {0u, 1u})
            connectivity.neighbours[sides[s].first][std::size_t(sides[s].second)] =
                static_cast<std::int32_t>(sides[1 - s].first);
    }
    return connectivity;
}

/// Returns a bumpy sheet of columns x rows squares, cut along one diagonal.
inline Mesh grid(std::uint32_t columns, std::uint32_t rows) {
    std::vector<Vec3d> positions;
    std::vector<Triangle> triangles;
    for (std::uint32_t y = 0; y <= rows; ++y)
        for (std::uint32_t x = 0; x <= columns; ++x)
            positions.push_back({x / double(columns), y / double(columns),
                                 0.1 * std::sin(1.3 * x) * std::cos(0.7 * y)});
    const auto id = [&](std::uint32_t x, std::uint32_t y) { return y * (columns + 1) + x; };
    for (std::uint32_t y = 0; y < rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x) {
            triangles.push_back({id(x, y), id(x + 1, y), id(x, y + 1)});
            triangles.push_back({id(x + 1, y), id(x + 1, y + 1), id(x, y + 1)});
        }
    return mesh_of(positions, triangles);
}

/// Returns a closed surface like a sphere: an octahedron whose triangles are divided into four
/// `depth` times.
inline Mesh ball(int depth) {
    std::vector<Vec3d> p{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<Triangle> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < depth; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [it, made] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(p.size()));
            if (made) p.push_back(glm::normalize(p[a] + p[b]));
            return it->second;
        };
        std::vector<Triangle> finer;
        for (const auto& [a, b, c] : triangles) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        triangles = finer;
    }
    return mesh_of(p, triangles);
}

/// Returns separate triangles, with areas over about two decades.
inline Mesh soup(std::uint32_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    std::vector<Vec3d> positions;
    std::vector<Triangle> triangles;
    for (std::uint32_t t = 0; t < count; ++t) {
        const double size = std::pow(10.0, 0.5 * place(random));
        const Vec3d centre{place(random), place(random), place(random)};
        for (int k = 0; k < 3; ++k)
            positions.push_back(centre + size * Vec3d{place(random), place(random), place(random)});
        triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return mesh_of(positions, triangles);
}

/// Returns a disk of radius 1 made of slivers around one point.
inline Mesh fan(std::uint32_t count) {
    std::vector<Vec3d> positions{{0, 0, 0}};
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * i / count;
        positions.push_back({std::cos(angle), std::sin(angle), 0.0});
        triangles.push_back({0, 1 + i, 1 + (i + 1) % count});
    }
    return mesh_of(positions, triangles);
}

/// Returns a ribbon whose quads shrink by `factor` each, so that weights span many decades.
inline Mesh taper(std::uint32_t quads, double factor) {
    std::vector<Vec3d> positions{{0, 0, 0}, {0, 1, 0}};
    std::vector<Triangle> triangles;
    double x = 0.0, width = 1.0;
    for (std::uint32_t i = 0; i < quads; ++i) {
        x += width;
        width *= factor;
        positions.insert(positions.end(), {{x, 0, 0}, {x, width, 0}});
        const std::uint32_t a = 2 * i;
        triangles.push_back({a, a + 2, a + 1});
        triangles.push_back({a + 2, a + 3, a + 1});
    }
    return mesh_of(positions, triangles);
}

inline Mesh one_triangle() {
    return mesh_of({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
}

/// Returns a unit square of two triangles.
inline Mesh square() {
    return mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
}

/// Returns a ball with repeated points, collinear points, duplicates and an edge of three
/// triangles.
inline Mesh nasty() {
    Mesh mesh = ball(1);
    const auto n = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(),
                          {{5, 0, 0}, {6, 0, 0}, {7, 0, 0}, {0, 0, 3}, {5, 5, 5}});
    auto& t = mesh.triangles;
    t.insert(t.end(), {{n, n + 1, n + 2}, {n, n, n + 1}, {n + 4, n + 4, n + 4}, t[0], t[3]});
    t.push_back({t[5][0], t[5][1], n + 3});
    return mesh_of(mesh.positions, t);
}

/// Whether atlases of this kind can have this size.
inline bool allowed(AtlasKind kind, std::uint32_t size) {
    return kind != AtlasKind::quad || std::has_single_bit(size);
}

/// Returns for every triangle whether it lies in a block one texel wide, in which it has no area.
inline std::vector<bool> collapsed_triangles(const Atlas& atlas) {
    std::vector<bool> collapsed(atlas.corners.size(), false);
    for (const Block& block : atlas.blocks)
        for (const std::int32_t t : {block.lower, block.upper})
            if (t >= 0 && block.collapsed()) collapsed[std::size_t(t)] = true;
    return collapsed;
}

struct Named {
    std::string name;
    Mesh mesh;
};

inline std::vector<Named> all() {
    return {{"one_triangle", one_triangle()},
            {"square", square()},
            {"grid", grid(9, 7)},
            {"ball", ball(2)},
            {"soup", soup(61, 1)},
            {"soup_of_two", soup(2, 3)},
            {"fan", fan(40)},
            {"taper", taper(24, 0.7)},
            {"nasty", nasty()}};
}

}  // namespace burl::made
