#pragma once
// The edges of a scene's triangles, each once, and the borders of charts among them: edges whose
// two sides are apart in the texture.
#include <cstdint>
#include <span>
#include <vector>

#include "app/scene/scene.h"

namespace burl {

/// A line segment in scene coordinates, in its surface's first placement.
struct SurfaceLine {
    Vec3d from{0.0}, to{0.0};
};

/// A border edge of a chart.
struct BorderLine {
    SurfaceLine line{};
    Vec2d from_uv{0.0}, to_uv{0.0};  ///< the texture coordinates of the ends, on the chart's side
    Vec3d normal{0.0};               ///< the normal of the chart's triangle, of any length
    /// The changes of both ends and of the normal at weight 1 of the surface's morph target.
    SurfaceLine change{};
    Vec3d normal_change{0.0};

    /// The border at a weight of the morph target.
    BorderLine at(double share) const;
};

struct SurfaceLines {
    std::vector<SurfaceLine> edges;  ///< all edges of triangles, at rest
    /// Per edge the change at weight 1 of the morph target; empty where no surface has one.
    std::vector<SurfaceLine> changes;
    /// Grouped by chart; an edge between two charts is listed for each.
    std::vector<BorderLine> borders;
    /// The borders of chart c have the indices border_begin[c] up to border_begin[c + 1].
    std::vector<std::size_t> border_begin;
    /// Per surface and triangle, the chart's number.
    std::vector<std::vector<std::uint32_t>> charts;

    std::span<const BorderLine> outline(std::uint32_t chart) const {
        return {borders.data() + border_begin[chart], borders.data() + border_begin[chart + 1]};
    }
};

/// The edges and charts of a scene. Charts are connected groups of a surface's triangles; an edge
/// connects its two triangles where it has equal texture coordinates on both sides. A surface
/// without texture coordinates has charts bounded by its own borders.
SurfaceLines surface_lines(const Scene& scene);

}  // namespace burl
