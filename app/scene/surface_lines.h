#pragma once
// The edges of a scene's triangles, each once, and which of them are borders of charts: where the
// two sides of an edge do not lie together in the texture.
#include <cstdint>
#include <span>
#include <vector>

#include "app/scene/scene.h"

namespace burl {

/// A straight line in the scene, where the first placement has it.
struct SurfaceLine {
    Vec3d from{0.0}, to{0.0};
};

struct BorderLine {
    SurfaceLine line{};
    Vec2d from_uv{0.0}, to_uv{0.0};  ///< of its ends, on one of its sides
    Vec3d normal{0.0};               ///< of the triangle on that side, of any length
    /// What is added at the end of the way to the surface's target.
    SurfaceLine change{};
    Vec3d normal_change{0.0};

    /// On its way there.
    BorderLine at(double share) const;
};

struct SurfaceLines {
    std::vector<SurfaceLine> edges;  ///< of triangles
    /// Per edge what is added at the end of the way to the surfaces' targets; empty: there are
    /// none.
    std::vector<SurfaceLine> changes;
    std::vector<BorderLine> borders;  ///< by chart; one between two charts is there for each
    /// Chart c has borders border_begin[c] up to border_begin[c + 1].
    std::vector<std::size_t> border_begin;
    std::vector<std::vector<std::uint32_t>> charts;  ///< per surface and triangle

    std::span<const BorderLine> outline(std::uint32_t chart) const {
        return {borders.data() + border_begin[chart], borders.data() + border_begin[chart + 1]};
    }
};

/// Two triangles of a surface lie together where they share two points and both have the same
/// texture coordinates on either side; charts are what hangs together so. Without texture
/// coordinates there is one chart without borders but the surface's own.
SurfaceLines surface_lines(const Scene& scene);

}  // namespace burl
