// Vertices are the classes of corners that meet across common edges (union-find), numbered by their
// first corner. Each class is a fan or an umbrella round one point, so at most one border half-edge
// leaves a vertex, and loops can be followed without choices.
#include "atlas/chart/patch.h"

#include <algorithm>
#include <numeric>

namespace burl {
namespace {

HalfEdge next_in_triangle(HalfEdge h) {
    return h - h % 3 + (h % 3 + 1) % 3;
}

DisjointSets corners_that_meet(const Patch& patch) {
    DisjointSets sets(3 * patch.triangles.size());
    for (HalfEdge h = 0; h < 3 * patch.triangles.size(); ++h) {
        if (patch.on_border(h)) continue;
        const HalfEdge other = patch.across(h);
        sets.join(h, next_in_triangle(other));
        sets.join(next_in_triangle(h), other);
    }
    return sets;
}

/// The border half-edge that starts where h ends, found by turning about that vertex through its
/// triangles.
HalfEdge next_on_border(const Patch& patch, HalfEdge h) {
    h = next_in_triangle(h);
    while (!patch.on_border(h)) h = next_in_triangle(patch.across(h));
    return h;
}

/// Renumbers the vertices; returns the former number of each.
std::vector<std::uint32_t> number_vertices(Patch& patch) {
    DisjointSets sets = corners_that_meet(patch);
    std::vector<std::uint32_t> from;
    std::vector<Triangle> numbered(patch.triangles.size());
    for (HalfEdge c = 0; c < 3 * patch.triangles.size(); ++c) {
        const std::uint32_t first = sets.find(c);
        if (first == c) {
            numbered[c / 3][c % 3] = static_cast<std::uint32_t>(from.size());
            from.push_back(patch.start(c));
        } else {
            numbered[c / 3][c % 3] = numbered[first / 3][first % 3];
        }
    }
    patch.triangles = std::move(numbered);
    return from;
}

void order_loops(Patch& patch) {
    patch.loops.clear();
    std::vector<bool> seen(3 * patch.triangles.size(), false);
    for (HalfEdge first = 0; first < seen.size(); ++first) {
        if (seen[first] || !patch.on_border(first)) continue;
        auto& loop = patch.loops.emplace_back();
        for (HalfEdge h = first; !seen[h]; h = next_on_border(patch, h)) {
            seen[h] = true;
            loop.push_back(h);
        }
    }
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < patch.loops.size(); ++i)
        order.emplace_back(-length_of(patch, patch.loops[i]), i);
    std::sort(order.begin(), order.end());
    std::vector<std::vector<HalfEdge>> sorted;
    for (const auto& [length, i] : order) sorted.push_back(std::move(patch.loops[i]));
    patch.loops = std::move(sorted);
}

std::vector<std::uint32_t> component_of_triangles(const Patch& patch) {
    DisjointSets sets(patch.triangles.size());
    for (std::uint32_t t = 0; t < patch.triangles.size(); ++t)
        for (const std::int32_t n : patch.neighbours[t])
            if (n >= 0) sets.join(t, static_cast<std::uint32_t>(n));
    std::vector<std::uint32_t> component(patch.triangles.size());
    std::uint32_t count = 0;
    for (std::uint32_t t = 0; t < component.size(); ++t) {
        const std::uint32_t root = sets.find(t);
        component[t] = root == t ? count++ : component[root];
    }
    return component;
}

}  // namespace

HalfEdge Patch::across(HalfEdge h) const {
    const auto other = static_cast<std::uint32_t>(neighbours[h / 3][h % 3]);
    for (HalfEdge k = 3 * other; k < 3 * other + 2; ++k)
        if (neighbours[other][k % 3] == static_cast<std::int32_t>(h / 3) && start(k) == end(h) &&
            end(k) == start(h))
            return k;
    return 3 * other + 2;
}

void rebuild_vertices(Patch& patch) {
    const std::vector<std::uint32_t> from = number_vertices(patch);
    std::vector<Vec3d> points;
    std::vector<VertexOrigin> origins;
    points.reserve(from.size());
    origins.reserve(from.size());
    for (const std::uint32_t old : from) {
        points.push_back(patch.points[old]);
        origins.push_back(patch.origins[old]);
    }
    patch.points = std::move(points);
    patch.origins = std::move(origins);
    order_loops(patch);
}

Patch extract_patch(const Mesh& mesh, const Connectivity& connectivity,
                    std::span<const std::uint32_t> faces, std::vector<std::int32_t>& local) {
    Patch patch;
    patch.faces.assign(faces.begin(), faces.end());
    patch.neighbours.reserve(faces.size());
    patch.triangles.reserve(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) local[faces[i]] = static_cast<std::int32_t>(i);
    for (const std::uint32_t face : faces) {
        auto& sides = patch.neighbours.emplace_back(connectivity.neighbours[face]);
        for (std::int32_t& side : sides)
            if (side >= 0) side = local[static_cast<std::size_t>(side)];
        patch.triangles.push_back(mesh.triangles[face]);
    }
    for (const std::uint32_t face : faces) local[face] = -1;
    const std::vector<std::uint32_t> points = number_vertices(patch);
    patch.points.reserve(points.size());
    patch.origins.reserve(points.size());
    for (const std::uint32_t point : points) {
        patch.points.push_back(mesh.positions[point]);
        patch.origins.push_back({point, point});
    }
    order_loops(patch);
    return patch;
}

PatchTopology topology_of(const Patch& patch) {
    PatchTopology topology;
    const auto component = component_of_triangles(patch);
    for (const std::uint32_t c : component)
        topology.components = std::max(topology.components, c + 1);
    topology.loops = static_cast<std::uint32_t>(patch.loops.size());
    std::size_t border = 0;
    for (const auto& loop : patch.loops) border += loop.size();
    const std::size_t edges = (3 * patch.triangles.size() + border) / 2;
    topology.euler_characteristic = static_cast<std::int64_t>(patch.points.size()) -
                                    static_cast<std::int64_t>(edges) +
                                    static_cast<std::int64_t>(patch.triangles.size());
    topology.handles =
        static_cast<std::uint32_t>((2 * std::int64_t(topology.components) -
                                    topology.euler_characteristic - std::int64_t(topology.loops)) /
                                   2);
    return topology;
}

std::vector<std::vector<std::uint32_t>> component_faces(const Patch& patch) {
    std::vector<std::vector<std::uint32_t>> result;
    const auto component = component_of_triangles(patch);
    for (std::size_t t = 0; t < component.size(); ++t) {
        if (patch.faces[t] == not_in_mesh) continue;
        if (component[t] >= result.size()) result.resize(component[t] + 1);
        result[component[t]].push_back(patch.faces[t]);
    }
    std::erase_if(result, [](const auto& faces) { return faces.empty(); });
    return result;
}

double area_of(const Patch& patch, std::size_t triangle) {
    const Triangle& t = patch.triangles[triangle];
    const Vec3d& p = patch.points[t[0]];
    return 0.5 * glm::length(glm::cross(patch.points[t[1]] - p, patch.points[t[2]] - p));
}

double area_of(const Patch& patch) {
    double sum = 0.0;
    for (std::size_t t = 0; t < patch.triangles.size(); ++t)
        if (patch.faces[t] != not_in_mesh) sum += area_of(patch, t);
    return sum;
}

double length_of(const Patch& patch, std::span<const HalfEdge> edges) {
    double sum = 0.0;
    for (const HalfEdge h : edges)
        sum += glm::length(patch.points[patch.end(h)] - patch.points[patch.start(h)]);
    return sum;
}

}  // namespace burl
