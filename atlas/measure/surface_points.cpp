#include "atlas/measure/surface_points.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/random_unit.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/solid/weights.h"

namespace burl {

namespace {

/// Barycentric weights, in the triangle it lies on, of a patch vertex: a corner, or half-way
/// between two.
Vec3d weights_in(const Triangle& triangle, const VertexOrigin& origin) {
    Vec3d weights(0.0);
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t point = triangle[std::size_t(k)];
        weights[k] = 0.5 * (point == origin.a) + 0.5 * (point == origin.b);
    }
    return weights;
}

/// Number of the refined mesh's first triangle for every input triangle, and one entry behind the
/// last: the pieces of triangle t are first_pieces()[t] up to first_pieces()[t + 1].
std::vector<std::uint32_t> first_pieces(const Mesh& input, const RefinedMesh& refined) {
    std::vector<std::uint32_t> counts(input.triangles.size() + 1, 1);
    counts[0] = 0;
    for (const CutFace& cut : refined.cut_faces) counts[cut.face + 1] = cut.pieces;
    for (std::size_t i = 1; i < counts.size(); ++i) counts[i] += counts[i - 1];
    return counts;
}

SurfacePoint in_piece(const Mesh& input, const RefinedMesh& refined, const SurfacePoint& point,
                      std::uint32_t piece) {
    Mat3d columns;
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t corner = refined.mesh.triangles[piece][std::size_t(k)];
        columns[k] = weights_in(input.triangles[point.triangle], refined.origin(corner));
    }
    return {piece, glm::inverse(columns) * point.weights};
}

double least(const Vec3d& v) {
    return std::min({v.x, v.y, v.z});
}

}  // namespace

std::vector<SurfacePoint> area_uniform_points(const Mesh& mesh, std::size_t count,
                                              std::uint64_t seed) {
    std::vector<SurfacePoint> points;
    const std::vector<double> areas = triangle_areas(mesh).areas;
    double total = 0.0;
    for (const double area : areas) total += area;
    if (!(total > 0.0)) return points;
    points.reserve(count);
    double below = 0.0;
    std::uint32_t t = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double wanted = total * (double(i) + random_unit(seed, 3 * i)) / double(count);
        while (t + 1 < areas.size() && (areas[t] == 0.0 || below + areas[t] <= wanted))
            below += areas[t++];
        while (areas[t] == 0.0) --t;  // rounding ran past the last triangle with area
        const double root = std::sqrt(random_unit(seed, 3 * i + 1));
        const double v = random_unit(seed, 3 * i + 2);
        points.push_back({t, {1.0 - root, root * (1.0 - v), root * v}});
    }
    return points;
}

Vec3d face_normal(const Mesh& mesh, std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const auto& p = mesh.positions;
    const Vec3d normal = glm::cross(p[b] - p[a], p[c] - p[a]);
    const double length = glm::length(normal);
    return length > 0.0 ? normal / length : Vec3d(0.0);
}

std::vector<SurfacePoint> refined_points(const Mesh& input, const MeshAtlas& atlas,
                                         std::vector<SurfacePoint> points) {
    const PatchAtlas* patches = atlas.patches();
    if (!patches) return points;
    const std::vector<std::uint32_t> first = first_pieces(input, patches->refined);
    for (SurfacePoint& point : points) {
        const std::uint32_t begin = first[point.triangle], end = first[point.triangle + 1];
        if (patches->patch_of(begin) == not_in_mesh) {  // whole, and its corners in order
            point.triangle = begin;
            continue;
        }
        // A triangle's pieces tile it, so a point lies in the piece in which its least barycentric
        // weight is greatest; on a border between pieces rounding picks either.
        SurfacePoint best = in_piece(input, patches->refined, point, begin);
        for (std::uint32_t piece = begin + 1; piece < end; ++piece) {
            const SurfacePoint next = in_piece(input, patches->refined, point, piece);
            if (least(next.weights) > least(best.weights)) best = next;
        }
        point = best;
    }
    return points;
}

}  // namespace burl
