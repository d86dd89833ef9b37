#include "app/surface/tangents.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "app/base/unique_rows.h"
#include "app/surface/normals.h"

namespace burl {
namespace {

Vec3d any_perpendicular(const Vec3d& n) {
    const Vec3d axis = std::abs(n.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    const Vec3d across = unit_or_zero(axis - glm::dot(axis, n) * n);
    return across == Vec3d(0.0) ? Vec3d(1, 0, 0) : across;
}

/// The direction of growing u on a triangle, and the bitangent's sign.
struct TriangleTangent {
    Vec3d along_u{0.0};  ///< unit, or zero where the texture coordinates span no area
    float w = 1.0f;
};

/// The inputs of corner_tangents(): all per triangle corner but for the positions.
struct TangentCorners {
    std::span<const Vec3d> positions;
    std::span<const Triangle> triangles;
    std::span<const Vec2d> uvs;
    std::span<const Vec3f> normals;
};

TriangleTangent triangle_tangent(const TangentCorners& of, std::size_t t) {
    const auto& [a, b, c] = of.triangles[t];
    const auto& p = of.positions;
    const Vec2d* uvs = &of.uvs[3 * t];
    const Vec3d e = p[b] - p[a], f = p[c] - p[a];
    const Vec2d g = uvs[1] - uvs[0], h = uvs[2] - uvs[0];
    const double area = g.x * h.y - g.y * h.x;
    TriangleTangent result;
    if (area == 0.0 || !std::isfinite(area)) return result;
    const double sign = area < 0.0 ? -1.0 : 1.0;
    result.along_u = unit_or_zero(sign * (h.y * e - g.y * f));
    // v grows downwards, so a triangle that is not mirrored has a negative area in texture space;
    // normals that point inwards reverse the sign once more.
    Vec3d normal(0.0);
    for (std::size_t k = 0; k < 3; ++k) normal += Vec3d(of.normals[3 * t + k]);
    const double outside = glm::dot(unit_or_zero(glm::cross(e, f)), normal) < 0.0 ? -1.0 : 1.0;
    result.w = float(-sign * outside);
    return result;
}

std::uint32_t bits(double value) {
    return std::bit_cast<std::uint32_t>(float(value) + 0.0f);  // -0 becomes 0
}

using Shared = UniqueRows<12>;  // position as three doubles, u, v, normal, w

Shared::Row shared_row(const TangentCorners& of, std::size_t t, std::size_t k, float w) {
    const Vec3d& p = of.positions[of.triangles[t][k]];
    const Vec2d& uv = of.uvs[3 * t + k];
    const Vec3f& n = of.normals[3 * t + k];
    Shared::Row row{0,          0,          0,         0,         0,         0,
                    bits(uv.x), bits(uv.y), bits(n.x), bits(n.y), bits(n.z), bits(w)};
    for (int axis = 0; axis < 3; ++axis) {
        const auto word = std::bit_cast<std::uint64_t>(p[axis] + 0.0);
        row[std::size_t(2 * axis)] = std::uint32_t(word);
        row[std::size_t(2 * axis + 1)] = std::uint32_t(word >> 32);
    }
    return row;
}

}  // namespace

std::vector<Vec4f> corner_tangents(std::span<const Vec3d> positions,
                                   std::span<const Triangle> triangles, std::span<const Vec2d> uvs,
                                   std::span<const Vec3f> normals) {
    const TangentCorners of{positions, triangles, uvs, normals};
    Shared rows(normals.size() / 2);
    std::vector<std::uint32_t> row_of(normals.size());
    std::vector<Vec3d> sums;
    std::vector<float> signs(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const TriangleTangent tangent = triangle_tangent(of, t);
        signs[t] = tangent.w;
        for (std::size_t k = 0; k < 3; ++k) {
            row_of[3 * t + k] = rows.insert(shared_row(of, t, k, tangent.w));
            sums.resize(rows.rows().size(), Vec3d(0.0));
            const Vec3d n(normals[3 * t + k]), &u = tangent.along_u;
            sums[row_of[3 * t + k]] +=
                corner_angle(positions, triangles[t], k) * unit_or_zero(u - glm::dot(u, n) * n);
        }
    }
    std::vector<Vec4f> tangents(normals.size());
    for (std::size_t corner = 0; corner < normals.size(); ++corner) {
        const Vec3d mean = unit_or_zero(sums[row_of[corner]]);
        const Vec3d tangent = mean == Vec3d(0.0) ? any_perpendicular(Vec3d(normals[corner])) : mean;
        tangents[corner] = Vec4f(Vec3f(tangent), signs[corner / 3]);
    }
    return tangents;
}

Vec4f placed_tangent(const Vec4f& tangent, const Vec3f& normal, const Mat3d& linear) {
    const Vec3d n(normal), moved = unit_or_zero(linear * Vec3d(tangent));
    const Vec3d across = unit_or_zero(moved - glm::dot(moved, n) * n);
    const bool mirrors = glm::determinant(linear) < 0.0;
    return {Vec3f(across == Vec3d(0.0) ? any_perpendicular(n) : across),
            mirrors ? -tangent.w : tangent.w};
}

std::vector<Vec2d> corner_uvs(const Atlas& atlas) {
    std::vector<Vec2d> uvs;
    uvs.reserve(3 * atlas.corners.size());
    for (const auto& corners : atlas.corners)
        for (const Vec2d& corner : corners) uvs.push_back(corner / atlas.extent());
    return uvs;
}

NormalFrames make_normal_frames(const Mesh& mesh, const MeshAtlas& atlas,
                                const NormalFramesKey& key) {
    const Mesh& placed = atlas.mesh(mesh);
    NormalFrames frames{key};
    frames.positions = map_positions(placed, solid_from_mesh(mesh, key.space));
    frames.normals = corner_normals(placed, key.crease_degrees);
    if (key.tangents)
        frames.tangents = corner_tangents(placed.positions, placed.triangles,
                                          corner_uvs(atlas.atlas()), frames.normals);
    return frames;
}

}  // namespace burl
