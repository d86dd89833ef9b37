#include "atlas/measure/mismatch.h"

#include <cmath>

#include "atlas/base/random_unit.h"
#include "atlas/measure/bilinear.h"
#include "atlas/measure/surface_mean.h"

namespace burl {

namespace {

Vec2d on_side(const Atlas& atlas, const EdgeSide& side, double t) {
    const auto& corners = atlas.corners[side.triangle];
    return (1.0 - t) * corners[side.corners[0]] + t * corners[side.corners[1]];
}

}  // namespace

SeamPoints seam_points(const Mesh& mesh, const Atlas& atlas, std::span<const MeshEdge> edges,
                       std::size_t count, std::uint64_t seed) {
    SeamPoints points;
    double interior = 0.0, seams = 0.0;
    for (const MeshEdge& edge : edges) {
        if (!edge.interior) continue;
        interior += edge_length(mesh, edge);
        if (!joined(atlas, edge)) seams += edge_length(mesh, edge);
    }
    if (!(seams > 0.0)) return points;
    points.share = seams / interior;
    double below = 0.0;
    std::size_t next = 0;
    const auto wanted = [&] {
        return seams * (double(next) + random_unit(seed, next)) / double(count);
    };
    for (const MeshEdge& edge : edges) {
        if (!edge.interior || joined(atlas, edge)) continue;
        const double length = edge_length(mesh, edge);
        for (; next < count && wanted() < below + length; ++next) {
            const double t = (wanted() - below) / length;
            points.places.push_back(
                {on_side(atlas, edge.first, t), on_side(atlas, edge.second, t)});
        }
        below += length;
    }
    return points;
}

double mismatch(const SeamPoints& points, const Image<Vec3f>& level, std::uint32_t size) {
    if (points.places.empty()) return 0.0;
    const double scale = double(level.width()) / size;
    double squares = 0.0;
    for (const auto& [a, b] : points.places) {
        squares += mean_square(bilinear(level, a * scale) - bilinear(level, b * scale));
    }
    return std::sqrt(points.share * squares / double(points.places.size()));
}

}  // namespace burl
