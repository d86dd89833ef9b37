#include "atlas/measure/charts.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "atlas/solid/weights.h"

namespace burl {

namespace {

EdgeSide side(std::size_t triangle, std::size_t k) {
    return {std::uint32_t(triangle), {std::uint8_t(k), std::uint8_t((k + 1) % 3)}};
}

/// The side of triangle `other` that looks back at `from`'s edge k.
std::optional<EdgeSide> opposite(const Mesh& mesh, const Connectivity& connectivity,
                                 std::size_t from, std::size_t k, std::size_t other) {
    const Triangle &a = mesh.triangles[from], &b = mesh.triangles[other];
    for (std::size_t j = 0; j < 3; ++j) {
        if (connectivity.neighbours[other][j] != std::int32_t(from)) continue;
        EdgeSide found = side(other, j);
        if (b[found.corners[0]] != a[k]) std::swap(found.corners[0], found.corners[1]);
        if (b[found.corners[0]] == a[k] && b[found.corners[1]] == a[(k + 1) % 3]) return found;
    }
    return std::nullopt;
}

void number_charts(const Mesh& mesh, DisjointSets& charts, ChartMetrics& metrics) {
    const std::vector<double> areas = triangle_areas(mesh).areas;
    std::vector<char> has_area;
    metrics.of_triangle.resize(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t root = charts.find(t);
        if (root == t) {
            metrics.of_triangle[t] = metrics.count++;
            has_area.push_back(0);
        } else {
            metrics.of_triangle[t] = metrics.of_triangle[root];
        }
        if (areas[t] > 0.0) has_area[metrics.of_triangle[t]] = 1;
    }
    metrics.with_area = std::uint32_t(std::count(has_area.begin(), has_area.end(), 1));
}

std::uint64_t distinct_vertices(const Mesh& mesh, const Atlas& atlas) {
    std::vector<std::tuple<std::uint32_t, double, double>> vertices;
    vertices.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            vertices.emplace_back(mesh.triangles[t][k], atlas.corners[t][k].x,
                                  atlas.corners[t][k].y);
    std::sort(vertices.begin(), vertices.end());
    return std::uint64_t(std::unique(vertices.begin(), vertices.end()) - vertices.begin());
}

}  // namespace

std::vector<MeshEdge> mesh_edges(const Mesh& mesh, const Connectivity& connectivity) {
    std::vector<MeshEdge> edges;
    edges.reserve(mesh.triangles.size() * 3 / 2);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t other = connectivity.neighbours[t][k];
            std::optional<EdgeSide> back;
            if (other >= 0) back = opposite(mesh, connectivity, t, k, std::size_t(other));
            if (back && std::size_t(other) < t) continue;  // listed from its other side
            edges.push_back({side(t, k), back.value_or(EdgeSide{}), back.has_value()});
        }
    }
    return edges;
}

bool joined(const Atlas& atlas, const MeshEdge& edge) {
    if (!edge.interior) return false;
    const auto& a = atlas.corners[edge.first.triangle];
    const auto& b = atlas.corners[edge.second.triangle];
    return a[edge.first.corners[0]] == b[edge.second.corners[0]] &&
           a[edge.first.corners[1]] == b[edge.second.corners[1]];
}

double edge_length(const Mesh& mesh, const MeshEdge& edge) {
    const Triangle& t = mesh.triangles[edge.first.triangle];
    return glm::length(mesh.positions[t[edge.first.corners[1]]] -
                       mesh.positions[t[edge.first.corners[0]]]);
}

ChartMetrics measure_charts(const Mesh& mesh, const Atlas& atlas, std::span<const MeshEdge> edges) {
    ChartMetrics metrics;
    DisjointSets charts(mesh.triangles.size());
    double length = 0.0;
    for (const MeshEdge& edge : edges) {
        if (!edge.interior) continue;
        const double here = edge_length(mesh, edge);
        length += here;
        if (joined(atlas, edge)) {
            charts.join(edge.first.triangle, edge.second.triangle);
        } else {
            metrics.seam_length += here;
        }
    }
    if (length > 0.0) metrics.seam_share = metrics.seam_length / length;
    number_charts(mesh, charts, metrics);
    metrics.vertices = distinct_vertices(mesh, atlas);
    if (!mesh.positions.empty())
        metrics.vertex_ratio = double(metrics.vertices) / double(mesh.positions.size());
    return metrics;
}

}  // namespace burl
