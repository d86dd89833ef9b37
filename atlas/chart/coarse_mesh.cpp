// The relation of fine to coarse triangles: a fine triangle starts at the heir of its own number
// and walks over neighbours to the coarse triangle nearest to its centroid, so that it never jumps
// to another sheet.
#include "atlas/chart/coarse_mesh.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "atlas/chart/edge_collapse.h"
#include "atlas/chart/patch.h"

namespace burl {
namespace {

constexpr int most_steps = 64;

Vec3d centroid(const Mesh& mesh, const Triangle& t) {
    return (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0;
}

/// Squared distance of a point to a triangle (after Ericson, "Real-Time Collision Detection",
/// 2005, 5.1.5).
double squared_distance(const Mesh& mesh, std::uint32_t triangle, const Vec3d& p) {
    const Triangle& t = mesh.triangles[triangle];
    const Vec3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const auto to_side = [&](const Vec3d& from, const Vec3d& to) {
        const Vec3d along = to - from;
        const double square = glm::dot(along, along);
        const double s =
            square > 0.0 ? std::clamp(glm::dot(p - from, along) / square, 0.0, 1.0) : 0.0;
        const Vec3d off = p - from - s * along;
        return glm::dot(off, off);
    };
    const Vec3d n = glm::cross(b - a, c - a);
    const double square = glm::dot(n, n);
    const bool inside = square > 0.0 && glm::dot(glm::cross(b - a, p - a), n) >= 0.0 &&
                        glm::dot(glm::cross(c - b, p - b), n) >= 0.0 &&
                        glm::dot(glm::cross(a - c, p - c), n) >= 0.0;
    if (inside) return glm::dot(p - a, n) * glm::dot(p - a, n) / square;
    return std::min({to_side(a, b), to_side(b, c), to_side(c, a)});
}

std::uint32_t walk_to(const CoarseMesh& coarse, std::uint32_t from, const Vec3d& p) {
    double distance = squared_distance(coarse.mesh, from, p);
    for (int step = 0; step < most_steps; ++step) {
        const std::uint32_t before = from;
        for (const std::int32_t n : coarse.connectivity.neighbours[before]) {
            if (n < 0) continue;
            const double d = squared_distance(coarse.mesh, static_cast<std::uint32_t>(n), p);
            if (!(d < distance)) continue;
            distance = d;
            from = static_cast<std::uint32_t>(n);
        }
        if (from == before) break;
    }
    return from;
}

}  // namespace

Connectivity connect_by_vertices(const std::vector<Triangle>& triangles) {
    struct Side {
        std::uint32_t low, high, triangle;
        bool rising;
        std::size_t k;
    };
    std::vector<Side> sides;
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), t, a < b, k});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
        return std::tie(x.low, x.high, x.triangle, x.k) < std::tie(y.low, y.high, y.triangle, y.k);
    });
    Connectivity result;
    result.neighbours.assign(triangles.size(), {-1, -1, -1});
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
        while (end < sides.size() && sides[end].low == sides[i].low &&
               sides[end].high == sides[i].high)
            ++end;
        if (end - i != 2 || sides[i].rising == sides[i + 1].rising) continue;
        result.neighbours[sides[i].triangle][sides[i].k] =
            static_cast<std::int32_t>(sides[i + 1].triangle);
        result.neighbours[sides[i + 1].triangle][sides[i + 1].k] =
            static_cast<std::int32_t>(sides[i].triangle);
    }
    return result;
}

CoarseMesh coarsen(const Mesh& mesh, const Connectivity& connectivity, std::size_t triangles) {
    std::vector<std::uint32_t> faces(mesh.triangles.size());
    std::iota(faces.begin(), faces.end(), 0u);
    std::vector<std::int32_t> local(faces.size(), -1);
    const Patch whole = extract_patch(mesh, connectivity, faces, local);
    const CollapsedMesh left = collapse_edges(whole.points, whole.triangles, triangles);
    CoarseMesh coarse;
    std::vector<std::int64_t> number(whole.points.size(), -1);
    for (Triangle t : left.triangles) {
        for (std::uint32_t& v : t) {
            if (number[v] < 0) {
                number[v] = static_cast<std::int64_t>(coarse.mesh.positions.size());
                coarse.mesh.positions.push_back(whole.points[v]);
            }
            v = static_cast<std::uint32_t>(number[v]);
        }
        coarse.mesh.triangles.push_back(t);
    }
    coarse.connectivity = connect_by_vertices(coarse.mesh.triangles);
    std::vector<std::uint32_t> position(faces.size(), 0);
    for (std::uint32_t i = 0; i < left.which.size(); ++i) position[left.which[i]] = i;
    for (std::uint32_t t = 0; t < faces.size(); ++t)
        coarse.nearest.push_back(
            walk_to(coarse, position[left.heir[t]], centroid(mesh, mesh.triangles[t])));
    return coarse;
}

}  // namespace burl
