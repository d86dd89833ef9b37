#include "app/scene/coarse_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

namespace burl {

namespace {

constexpr int most_tries = 6;
constexpr double most_excess = 1.25;  // of triangles
constexpr double most_cells = 2e6;    // along an axis, so that three numbers fit 64 bits

/// The box of the positions that triangles use, and the area of the triangles.
struct Extent {
    Vec3d low{std::numeric_limits<double>::infinity()};
    Vec3d high{-std::numeric_limits<double>::infinity()};
    double area = 0.0;
};

Extent extent_of(const Surface& surface) {
    Extent extent;
    for (const Triangle& t : surface.triangles) {
        const Vec3d &a = surface.positions[t[0]], &b = surface.positions[t[1]],
                    &c = surface.positions[t[2]];
        extent.area += 0.5 * glm::length(glm::cross(b - a, c - a));
        extent.low = glm::min(extent.low, glm::min(a, glm::min(b, c)));
        extent.high = glm::max(extent.high, glm::max(a, glm::max(b, c)));
    }
    return extent;
}

/// The vertices of a surface in cells of a cubic grid.
struct Clusters {
    std::vector<std::uint32_t> cells;  ///< one per vertex
    std::vector<std::uint32_t> stand;  ///< per cell the vertex that stands for all
};

/// The bits of a number, two zeros after each.
std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 32) & 0x1f00000000ffff;
    bits = (bits | bits << 16) & 0x1f0000ff0000ff;
    bits = (bits | bits << 8) & 0x100f00f00f00f00f;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
    return (bits | bits << 2) & 0x1249249249249249;
}

/// Numbers the cells, of this side, that hold vertices, along a Z-order curve: neighbours have
/// near numbers, so that those who draw find vertices again that they have just worked out.
std::vector<std::uint32_t> cells_of(const Surface& surface, const Vec3d& low, double side,
                                    std::size_t& count) {
    std::vector<std::uint64_t> keys(surface.positions.size());
    for (std::size_t v = 0; v < keys.size(); ++v) {
        const Vec3d at = glm::clamp((surface.positions[v] - low) / side, 0.0, most_cells);
        keys[v] = spread(std::uint64_t(at.x)) << 2 | spread(std::uint64_t(at.y)) << 1 |
                  spread(std::uint64_t(at.z));
    }
    std::unordered_map<std::uint64_t, std::uint32_t> numbers;
    for (const std::uint64_t key : keys) numbers.try_emplace(key);
    std::vector<std::uint64_t> curve;
    for (const auto& [key, number] : numbers) curve.push_back(key);
    std::ranges::sort(curve);
    for (std::size_t i = 0; i < curve.size(); ++i) numbers[curve[i]] = std::uint32_t(i);
    std::vector<std::uint32_t> cells(keys.size());
    for (std::size_t v = 0; v < keys.size(); ++v) cells[v] = numbers[keys[v]];
    count = curve.size();
    return cells;
}

Clusters clusters_of(const Surface& surface, const Vec3d& low, double side) {
    Clusters clusters;
    std::size_t count = 0;
    clusters.cells = cells_of(surface, low, side, count);
    std::vector<Vec4d> sums(count, Vec4d(0.0));
    for (std::size_t v = 0; v < clusters.cells.size(); ++v)
        sums[clusters.cells[v]] += Vec4d(surface.positions[v], 1.0);
    clusters.stand.resize(count);
    std::vector<double> nearest(count, std::numeric_limits<double>::infinity());
    for (std::uint32_t v = 0; v < clusters.cells.size(); ++v) {
        const std::uint32_t cell = clusters.cells[v];
        const Vec3d away = surface.positions[v] - Vec3d(sums[cell]) / sums[cell].w;
        const double distance = glm::dot(away, away);
        if (!(distance < nearest[cell])) continue;
        nearest[cell] = distance;
        clusters.stand[cell] = v;
    }
    return clusters;
}

/// The triangles between three cells, each once.
std::vector<Triangle> triangles_of(const Surface& surface, const Clusters& clusters) {
    std::vector<Triangle> triangles;
    for (const Triangle& t : surface.triangles) {
        Triangle between{clusters.cells[t[0]], clusters.cells[t[1]], clusters.cells[t[2]]};
        if (between[0] == between[1] || between[1] == between[2] || between[2] == between[0])
            continue;
        std::rotate(between.begin(), std::ranges::min_element(between), between.end());
        triangles.push_back(between);
    }
    std::ranges::sort(triangles);
    const auto repeated = std::ranges::unique(triangles);
    triangles.erase(repeated.begin(), repeated.end());
    return triangles;
}

/// The entries of these vertices; none where there are none.
template <class T>
std::vector<T> picked(const std::vector<T>& all, const std::vector<std::uint32_t>& vertices) {
    std::vector<T> some;
    if (all.empty()) return some;
    some.reserve(vertices.size());
    for (const std::uint32_t v : vertices) some.push_back(all[v]);
    return some;
}

Surface with_vertices(const Surface& surface, const std::vector<std::uint32_t>& vertices) {
    Surface some;
    some.positions = picked(surface.positions, vertices);
    some.normals = picked(surface.normals, vertices);
    some.uvs = picked(surface.uvs, vertices);
    some.tangents = picked(surface.tangents, vertices);
    some.colors = picked(surface.colors, vertices);
    some.blocks = picked(surface.blocks, vertices);
    some.target.positions = picked(surface.target.positions, vertices);
    some.target.normals = picked(surface.target.normals, vertices);
    some.target.tangents = picked(surface.target.tangents, vertices);
    some.target_share = surface.target_share;
    some.material = surface.material;
    some.placements = surface.placements;
    return some;
}

}  // namespace

Surface coarse_surface(const Surface& surface, std::size_t most) {
    const Extent extent = extent_of(surface);
    if (surface.triangles.size() <= most || !(extent.area > 0.0)) return surface;
    const Vec3d size = extent.high - extent.low;
    const double least = std::max({size.x, size.y, size.z}) / most_cells;
    double side = std::max(least, std::sqrt(3.0 * extent.area / double(most)));
    Surface coarse;
    for (int tries = 0; tries < most_tries; ++tries) {
        const Clusters clusters = clusters_of(surface, extent.low, side);
        coarse = with_vertices(surface, clusters.stand);
        coarse.triangles = triangles_of(surface, clusters);
        const double excess = double(coarse.triangles.size()) / double(most);
        if (excess <= most_excess) break;
        side *= std::max(1.1, std::sqrt(excess));
    }
    return coarse;
}

}  // namespace burl
