#pragma once
// The borders of a uv atlas's charts, and how the surface goes on beyond them.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/solid/solid_atlas.h"

namespace burl {

/// The number of texels by which a triangle's map goes on beyond its border, at most, and the
/// distance from which on texels show the border itself; measured in docs/lab/atlases.md.
inline constexpr double continued_texels_of_charts = 1.0, border_texels_of_charts = 1.5;

/// An edge with a triangle on one side only.
struct BorderEdge {
    std::uint32_t triangle = 0, corner = 0;  ///< from this corner to the next
    Vec2d from{0.0}, to{0.0};
    Vec2d out{0.0};       ///< unit vector away from the triangle, at right angles to the edge
    double height = 0.0;  ///< texels from the edge to the triangle's third corner

    /// The place on the edge nearest to `at`: 0 at `from`, 1 at `to`.
    double share(const Vec2d& at) const;
    double distance(const Vec2d& at) const;
    /// The texels that the triangle's map goes on for: no further than the triangle is high, since
    /// a sliver's map may be arbitrarily steep.
    double way() const { return std::min(continued_texels_of_charts, height); }
};

/// The border edges of all triangles with area, in their order. An edge is none where another
/// triangle has the same two places the other way round.
std::vector<BorderEdge> border_edges(const Atlas& atlas);

/// Zones of a border edge's surroundings: that to which the triangle's map goes on, and those
/// beyond, whose nearest place is within the edge or at one of its ends; far ones show the border.
enum class BorderZone { near, beside, at_from, at_to, far_beside, far_from, far_to };

/// The zone of the place `at`, of which the edge is the nearest one.
BorderZone zone_of(const BorderEdge& edge, const Vec2d& at);

/// The map of a zone but `near`: it shows what the triangle's map shows at the end of its way,
/// straight out from the nearest place of the edge, or that place; it is constant but along the
/// edge. `map` is the triangle's.
TexelMap zone_map(const BorderEdge& edge, const TexelMap& map, BorderZone zone);

}  // namespace burl
