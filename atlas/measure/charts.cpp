#include "atlas/measure/charts.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "atlas/solid/weights.h"

namespace burl {

namespace {

/// Disjoint sets (union-find) whose representative is the lowest member.
class Components {
  public:
    explicit Components(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a), b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

void number_charts(const Mesh& mesh, Components& components, ChartMetrics& metrics) {
    const std::vector<double> areas = triangle_areas(mesh).areas;
    std::vector<char> has_area;
    metrics.of_triangle.resize(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t root = components.find(t);
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

ChartMetrics measure_charts(const Mesh& mesh, const Atlas& atlas, std::span<const MeshEdge> edges) {
    ChartMetrics metrics;
    Components components(mesh.triangles.size());
    double length = 0.0;
    for (const MeshEdge& edge : edges) {
        if (!edge.interior) continue;
        const double here = edge_length(mesh, edge);
        length += here;
        if (joined(atlas, edge)) {
            components.join(edge.first.triangle, edge.second.triangle);
        } else {
            metrics.seam_length += here;
        }
    }
    if (length > 0.0) metrics.seam_share = metrics.seam_length / length;
    number_charts(mesh, components, metrics);
    metrics.vertices = distinct_vertices(mesh, atlas);
    if (!mesh.positions.empty())
        metrics.vertex_ratio = double(metrics.vertices) / double(mesh.positions.size());
    return metrics;
}

}  // namespace burl
