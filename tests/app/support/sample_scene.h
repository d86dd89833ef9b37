#pragma once
// Small meshes and a simple atlas for the exporter's tests, independent of readers and layouts.
#include <cmath>
#include <map>
#include <numbers>

#include "atlas/base/image.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"

namespace burl {

inline void add_whole_part(Mesh& mesh) {
    mesh.parts = {{mesh.name, 0, std::uint32_t(mesh.triangles.size()), {Mat4d(1.0)}}};
}

/// Returns a cube of side 2 about `centre`, with two triangles per side, counter-clockwise outside.
inline Mesh cube_mesh(const Vec3d& centre = Vec3d(0.0)) {
    Mesh mesh;
    mesh.name = "cube";
    for (int i = 0; i < 8; ++i) {
        mesh.positions.push_back(centre + Vec3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    }
    const std::array<std::array<std::uint32_t, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& s : sides) {
        mesh.triangles.push_back({s[0], s[1], s[2]});
        mesh.triangles.push_back({s[0], s[2], s[3]});
    }
    add_whole_part(mesh);
    return mesh;
}

/// Returns a unit sphere by latitude and longitude; triangles close the poles.
inline Mesh sphere_mesh(std::uint32_t rings, std::uint32_t segments) {
    Mesh mesh;
    mesh.name = "sphere";
    mesh.positions.push_back({0, 0, 1});
    for (std::uint32_t r = 1; r < rings; ++r) {
        const double polar = std::numbers::pi * r / rings;
        for (std::uint32_t s = 0; s < segments; ++s) {
            const double turn = 2 * std::numbers::pi * s / segments;
            mesh.positions.push_back({std::sin(polar) * std::cos(turn),
                                      std::sin(polar) * std::sin(turn), std::cos(polar)});
        }
    }
    const auto south = std::uint32_t(mesh.positions.size());
    mesh.positions.push_back({0, 0, -1});
    const auto at = [&](std::uint32_t r, std::uint32_t s) {
        return 1 + (r - 1) * segments + s % segments;
    };
    for (std::uint32_t s = 0; s < segments; ++s) {
        mesh.triangles.push_back({0, at(1, s), at(1, s + 1)});
        for (std::uint32_t r = 1; r + 1 < rings; ++r) {
            mesh.triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
            mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
        }
        mesh.triangles.push_back({at(rings - 1, s), south, at(rings - 1, s + 1)});
    }
    add_whole_part(mesh);
    return mesh;
}

/// Returns an atlas in which triangles 2i and 2i+1 fill one square cell and share its diagonal. A
/// mesh that lists the two halves of each quad in turn, as cube_mesh does, shares two vertices per
/// pair.
inline Atlas pair_atlas(const Mesh& mesh, std::uint32_t size,
                        Overscan overscan = Overscan::bilinear) {
    Atlas atlas;
    atlas.options = {AtlasKind::uniform, overscan, size};
    const std::size_t pairs = (mesh.triangles.size() + 1) / 2;
    const auto columns = std::size_t(std::ceil(std::sqrt(double(pairs))));
    const double cell = double(size) / double(columns);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec2d low = cell * Vec2d(double(t / 2 % columns), double(t / 2 / columns)) + 0.5;
        const Vec2d high = low + cell - 1.0;
        if (t % 2 == 0) {
            atlas.corners.push_back({low, {high.x, low.y}, high});
        } else {
            atlas.corners.push_back({low, high, {low.x, high.y}});
        }
        atlas.charts.push_back(std::uint32_t(t / 2));
    }
    atlas.chart_count = std::uint32_t(pairs);
    return atlas;
}

/// Returns an image whose texels differ, so that a swap or shift shows.
inline Image<Rgb8> sample_image(std::uint32_t size) {
    Image<Rgb8> image(size, size);
    for (std::uint32_t y = 0; y < size; ++y) {
        for (std::uint32_t x = 0; x < size; ++x) {
            image(x, y) = {std::uint8_t(255 * x / size), std::uint8_t(255 * y / size),
                           std::uint8_t((x ^ y) & 1 ? 160 : 96)};
        }
    }
    return image;
}

/// Returns a placement that turns about Z by `degrees`, then scales, then translates.
inline Mat4d placement(double degrees, const Vec3d& scale, const Vec3d& move) {
    const double c = std::cos(degrees * std::numbers::pi / 180);
    const double s = std::sin(degrees * std::numbers::pi / 180);
    Mat4d m(1.0);
    m[0] = Vec4d(Vec3d(c, s, 0) * scale, 0);
    m[1] = Vec4d(Vec3d(-s, c, 0) * scale, 0);
    m[2] = Vec4d(Vec3d(0, 0, 1) * scale, 0);
    m[3] = Vec4d(move, 1);
    return m;
}

}  // namespace burl
