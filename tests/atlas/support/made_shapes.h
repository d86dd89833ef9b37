#pragma once
// Shapes with closed forms, for masks: sheets, spheres, tori, discs; and the points of a scene.
#include <cmath>
#include <numbers>
#include <vector>

#include "atlas/shape/shape_scene.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl::made {

/// Both meshes as one; points are not welded.
inline Mesh both(const Mesh& a, const Mesh& b) {
    std::vector<Vec3d> positions = a.positions;
    std::vector<Triangle> triangles = a.triangles;
    positions.insert(positions.end(), b.positions.begin(), b.positions.end());
    const auto first = std::uint32_t(a.positions.size());
    for (const auto& [i, j, k] : b.triangles)
        triangles.push_back({i + first, j + first, k + first});
    return mesh_of(positions, triangles);
}

/// The parallelogram with this corner and sides; its normal is that of cross(u, v). The diagonal
/// runs between the ends of the sides.
inline Mesh sheet(const Vec3d& corner, const Vec3d& u, const Vec3d& v) {
    return mesh_of({corner, corner + u, corner + u + v, corner + v}, {{0, 1, 3}, {1, 2, 3}});
}

inline Mesh turned_inside_out(Mesh mesh) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

/// The box from `low` to `high`, with shared points, its normals outwards.
inline Mesh cuboid(const Vec3d& low, const Vec3d& high) {
    std::vector<Vec3d> points;
    for (int i = 0; i < 8; ++i)
        points.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    return mesh_of(points, {{0, 2, 3},
                            {0, 3, 1},
                            {4, 5, 7},
                            {4, 7, 6},
                            {0, 1, 5},
                            {0, 5, 4},
                            {2, 6, 7},
                            {2, 7, 3},
                            {0, 4, 6},
                            {0, 6, 2},
                            {1, 3, 7},
                            {1, 7, 5}});
}

/// A closed or open grid of `columns` x `rows` squares, wrapped round along its columns and, where
/// `closed`, along its rows; point(s, t) is its surface for s, t from 0 to 1.
template <class Point>
Mesh wrapped(std::uint32_t columns, std::uint32_t rows, bool closed, const Point& point) {
    std::vector<Vec3d> positions;
    std::vector<Triangle> triangles;
    const std::uint32_t lines = closed ? rows : rows + 1;
    for (std::uint32_t j = 0; j < lines; ++j)
        for (std::uint32_t i = 0; i < columns; ++i)
            positions.push_back(point(double(i) / columns, double(j) / rows));
    const auto id = [&](std::uint32_t i, std::uint32_t j) {
        return j % lines * columns + i % columns;
    };
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
            triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    return mesh_of(positions, triangles);
}

inline constexpr double full_turn = 2.0 * std::numbers::pi;

/// A torus about z: radius R of the ring, r of the tube.
inline Mesh torus(double R, double r, std::uint32_t columns, std::uint32_t rows) {
    return wrapped(columns, rows, true, [&](double s, double t) {
        const double u = full_turn * s, v = full_turn * t;
        const double out = R + r * std::cos(v);
        return Vec3d(out * std::cos(u), out * std::sin(u), r * std::sin(v));
    });
}

/// An open cylinder about z, from -height / 2 to height / 2.
inline Mesh cylinder(double R, double height, std::uint32_t columns, std::uint32_t rows) {
    return wrapped(columns, rows, false, [&](double s, double t) {
        return Vec3d(R * std::cos(full_turn * s), R * std::sin(full_turn * s), height * (t - 0.5));
    });
}

/// The mesh's points scaled and then moved.
inline Mesh placed(Mesh mesh, double scale, const Vec3d& offset) {
    for (Vec3d& p : mesh.positions) p = scale * p + offset;
    return mesh;
}

/// The middle of every triangle.
inline std::vector<ShapePoint> middles(const ShapeScene& shape) {
    std::vector<ShapePoint> points;
    for (std::uint32_t t = 0; t < shape.triangles().size(); ++t)
        points.push_back(shape.surface_point(t, Vec3d(1.0 / 3.0)));
    return points;
}

/// The point of triangle t's plane at `position`, moved onto the triangle.
inline ShapePoint point_at(const ShapeScene& shape, std::uint32_t t, const Vec3d& position) {
    return shape.surface_point(t, shape.weights_at(t, position));
}

}  // namespace burl::made
