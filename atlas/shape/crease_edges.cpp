#include "atlas/shape/crease_edges.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "atlas/base/each_index.h"
#include "atlas/base/elementary.h"

namespace burl {

namespace {

/// One triangle's edge between points low < high.
struct FaceEdge {
    std::uint32_t low = 0, high = 0, triangle = 0;
    bool rising = false;  ///< whether the triangle runs from `low` to `high`
    bool same_points(const FaceEdge& e) const { return low == e.low && high == e.high; }
};

std::vector<FaceEdge> sorted_edges(std::span<const Triangle> triangles) {
    std::vector<FaceEdge> edges;
    edges.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        if (a == b || b == c || c == a) continue;
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
            edges.push_back({std::min(from, to), std::max(from, to), t, from < to});
    }
    std::ranges::sort(edges, {}, [](const FaceEdge& e) {
        return std::tuple(e.low, e.high, e.triangle, e.rising);
    });
    return edges;
}

/// Whether the edge that these triangles share is a crease or border.
bool is_crease(const ShapeScene& shape, std::span<const FaceEdge> faces, double least_cosine) {
    for (const FaceEdge& face : faces)
        if (shape.areas()[face.triangle] == 0.0) return false;
    if (faces.size() != 2) return true;
    const double cosine =
        glm::dot(shape.normals()[faces[0].triangle], shape.normals()[faces[1].triangle]);
    const bool same_side = faces[0].rising != faces[1].rising;
    return (same_side ? cosine : -cosine) < least_cosine;
}

std::vector<Segment> crease_segments(const ShapeScene& shape, double angle) {
    const std::vector<FaceEdge> edges = sorted_edges(shape.triangles());
    const double half = sine(0.5 * angle), least_cosine = 1.0 - 2.0 * half * half;
    std::vector<Segment> segments;
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        while (end < edges.size() && edges[end].same_points(edges[i])) ++end;
        if (is_crease(shape, std::span(edges).subspan(i, end - i), least_cosine))
            segments.push_back({shape.points()[edges[i].low], shape.points()[edges[i].high]});
    }
    return segments;
}

/// The way to a point from the nearest place of a segment.
Vec3d way_from(const Segment& segment, const Vec3d& p) {
    const Vec3d along = segment[1] - segment[0], off = p - segment[0];
    const double square = glm::dot(along, along);
    const double at = square > 0.0 ? std::clamp(glm::dot(off, along) / square, 0.0, 1.0) : 0.0;
    return off - at * along;
}

/// The way to a point from the nearest place known, and its squared length.
struct NearestEdge {
    double square = 0.0;
    Vec3d way{0.0};  ///< 0 where no edge is nearer than the square at first

    void take(const Vec3d& other) {
        if (const double length = glm::dot(other, other); length < square)
            square = length, way = other;
    }
};

/// Gives `best` the segments below the node that are nearer.
void search(const CreaseEdges& edges, std::uint32_t number, const Vec3d& p, NearestEdge& best) {
    const BoxNode& node = edges.tree().nodes[number];
    if (node.second == 0) {
        for (std::uint32_t i = node.begin; i < node.end; ++i)
            best.take(way_from(edges.segments()[edges.tree().items[i]], p));
        return;
    }
    std::array<std::uint32_t, 2> children{number + 1, node.second};
    std::array<double, 2> off{square_distance(edges.tree().nodes[children[0]].box, p),
                              square_distance(edges.tree().nodes[children[1]].box, p)};
    if (off[1] < off[0]) std::swap(off[0], off[1]), std::swap(children[0], children[1]);
    for (std::size_t k = 0; k < 2; ++k)
        if (off[k] < best.square) search(edges, children[k], p, best);
}

/// Calls visit(i, nearest edge within `farthest`) for all points.
template <class Visit>
void for_nearest(const ShapeScene& shape, const CreaseEdges& edges,
                 std::span<const ShapePoint> points, double farthest, const Visit& visit) {
    const double limit = std::clamp(farthest / shape.diagonal(), 0.0, 1.0);
    const auto work = [&](std::size_t i) {
        NearestEdge best{limit * limit};
        if (edges.count() > 0) search(edges, 0, shape.to_unit(points[i].position), best);
        visit(i, best);
    };
    for_each_index(points.size(), work, points_at_a_time);
}

}  // namespace

CreaseEdges::CreaseEdges(const ShapeScene& shape, double angle)
    : segments_(crease_segments(shape, angle)) {
    std::vector<Box3> boxes(segments_.size());
    std::ranges::transform(segments_, boxes.begin(), [](const Segment& s) { return box_of(s); });
    tree_ = build_box_tree(boxes);
}

void edge_distance(const ShapeScene& shape, const CreaseEdges& edges,
                   std::span<const ShapePoint> points, double farthest, std::span<float> values) {
    for_nearest(shape, edges, points, farthest, [&](std::size_t i, const NearestEdge& edge) {
        values[i] = float(shape.diagonal() * std::sqrt(edge.square));
    });
}

void edge_distance_slopes(const ShapeScene& shape, const CreaseEdges& edges,
                          std::span<const ShapePoint> points, double farthest,
                          std::span<Vec3d> slopes) {
    for_nearest(shape, edges, points, farthest, [&](std::size_t i, const NearestEdge& edge) {
        const double length = glm::length(edge.way);
        slopes[i] = length > 0.0 ? edge.way / length : Vec3d(0.0);
    });
}

}  // namespace burl
