#include "atlas/uv/borders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "atlas/uv/claims.h"

namespace burl {

namespace {

/// An edge whichever way it runs, its lower end first.
struct KeyedEdge {
    Vec2d low{0.0}, high{0.0};
    bool turned = false;  ///< whether the triangle has the higher end first
    std::uint32_t triangle = 0, corner = 0;

    auto key() const { return std::tuple(low.x, low.y, high.x, high.y); }
};

KeyedEdge keyed(const Atlas& atlas, std::uint32_t t, std::uint32_t k) {
    const auto& corners = atlas.corners[t];
    // All triangles the same way round, mirrored ones, too.
    const bool mirrored = cross(corners[1] - corners[0], corners[2] - corners[0]) < 0.0;
    const Vec2d a = corners[k], b = corners[(k + 1) % 3];
    const bool swaps = std::tuple(b.x, b.y) < std::tuple(a.x, a.y);
    return {swaps ? b : a, swaps ? a : b, swaps != mirrored, t, k};
}

BorderEdge border_edge(const Atlas& atlas, const KeyedEdge& one) {
    const auto& corners = atlas.corners[one.triangle];
    BorderEdge edge{one.triangle, one.corner, corners[one.corner], corners[(one.corner + 1) % 3]};
    const Vec2d along = edge.to - edge.from, inside = corners[(one.corner + 2) % 3] - edge.from;
    const double length = glm::length(along);
    if (!(length > 0.0)) return edge;
    edge.height = std::abs(cross(along, inside)) / length;
    const double side = cross(along, inside) > 0.0 ? 1.0 : -1.0;
    edge.out = side * Vec2d(along.y, -along.x) / length;
    return edge;
}

}  // namespace

double BorderEdge::share(const Vec2d& at) const {
    const Vec2d along = to - from;
    const double squared = glm::dot(along, along);
    return squared > 0.0 ? std::clamp(glm::dot(at - from, along) / squared, 0.0, 1.0) : 0.0;
}

double BorderEdge::distance(const Vec2d& at) const {
    return glm::length(from + share(at) * (to - from) - at);
}

std::vector<BorderEdge> border_edges(const Atlas& atlas) {
    const double texture_area = double(atlas.options.columns()) * atlas.options.rows();
    std::vector<KeyedEdge> all;
    for (std::uint32_t t = 0; t < atlas.corners.size(); ++t)
        if (has_texture_area(atlas.corners[t], texture_area))
            for (std::uint32_t k = 0; k < 3; ++k) all.push_back(keyed(atlas, t, k));
    std::ranges::sort(all, {}, [](const KeyedEdge& one) {
        return std::tuple(one.key(), one.triangle, one.corner);
    });
    std::vector<BorderEdge> edges;
    for (std::size_t first = 0; first < all.size();) {
        std::size_t end = first, turned = 0;
        while (end < all.size() && all[end].key() == all[first].key()) turned += all[end++].turned;
        if (turned == 0 || turned == end - first)
            for (std::size_t i = first; i < end; ++i) edges.push_back(border_edge(atlas, all[i]));
        first = end;
    }
    std::ranges::sort(edges, {},
                      [](const BorderEdge& one) { return std::pair(one.triangle, one.corner); });
    return edges;
}

BorderZone zone_of(const BorderEdge& edge, const Vec2d& at) {
    const double distance = edge.distance(at), share = edge.share(at);
    if (distance <= edge.way()) return BorderZone::near;
    const bool far = distance > border_texels_of_charts;
    if (share <= 0.0) return far ? BorderZone::far_from : BorderZone::at_from;
    if (share >= 1.0) return far ? BorderZone::far_to : BorderZone::at_to;
    return far ? BorderZone::far_beside : BorderZone::beside;
}

TexelMap zone_map(const BorderEdge& edge, const TexelMap& map, BorderZone zone) {
    const auto step = [&](const Vec2d& by) { return by.x * map.step_x + by.y * map.step_y; };
    const Vec2d along = edge.to - edge.from;
    const double squared = glm::dot(along, along);
    const bool at_to = zone == BorderZone::at_to || zone == BorderZone::far_to;
    const bool beside = zone == BorderZone::beside || zone == BorderZone::far_beside;
    const double way = zone >= BorderZone::far_beside ? 0.0 : edge.way();
    const Vec2d place = at_to ? edge.to : edge.from;
    TexelMap result;
    result.anchor_x = std::int32_t(std::floor(place.x));
    result.anchor_y = std::int32_t(std::floor(place.y));
    const Vec2d from_anchor = place - Vec2d(result.anchor_x + 0.5, result.anchor_y + 0.5);
    result.origin = map(result.anchor_x, result.anchor_y) + step(from_anchor + edge.out * way);
    if (!beside || !(squared > 0.0)) return result;
    const Vec3d change = step(along) / squared;
    result.step_x = along.x * change;
    result.step_y = along.y * change;
    result.origin -= from_anchor.x * result.step_x + from_anchor.y * result.step_y;
    return result;
}

}  // namespace burl
