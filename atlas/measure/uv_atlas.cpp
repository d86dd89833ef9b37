#include "atlas/measure/uv_atlas.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "atlas/base/image.h"
#include "atlas/measure/charts.h"
#include "atlas/solid/texel_rows.h"

namespace burl {

namespace {

constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

double determinant(const std::array<Vec2d, 3>& corners) {
    return cross(corners[1] - corners[0], corners[2] - corners[0]);
}

std::int32_t nearest_texel(double coordinate, std::uint32_t size) {
    return std::int32_t(std::clamp(std::floor(coordinate), 0.0, size - 1.0));
}

/// The affine map of a triangle, anchored at the texel nearest to its first corner; constant for a
/// triangle without area in the texture.
TexelMap texel_map(const std::array<Vec2d, 3>& corners, const std::array<Vec3d, 3>& points,
                   std::uint32_t size) {
    TexelMap map;
    map.origin = points[0];
    const double det = determinant(corners);
    if (det == 0.0 || !std::isfinite(det)) return map;
    const Vec2d u = corners[1] - corners[0], v = corners[2] - corners[0];
    const Vec3d along_u = points[1] - points[0], along_v = points[2] - points[0];
    map.step_x = (along_u * v.y - along_v * u.y) / det;
    map.step_y = (along_v * u.x - along_u * v.x) / det;
    map.anchor_x = nearest_texel(corners[0].x, size);
    map.anchor_y = nearest_texel(corners[0].y, size);
    map.origin += (map.anchor_x + 0.5 - corners[0].x) * map.step_x +
                  (map.anchor_y + 0.5 - corners[0].y) * map.step_y;
    return map;
}

Image<std::uint32_t> owners(const Atlas& atlas) {
    const std::uint32_t size = atlas.options.size;
    Image<std::uint32_t> owner(size, size, nobody);
    for (std::uint32_t t = 0; t < atlas.corners.size(); ++t) {
        const double det = determinant(atlas.corners[t]);
        if (det == 0.0 || !std::isfinite(det)) continue;
        visit_slices(atlas.corners[t], size, 0.0, [&](std::uint32_t row, const Interval& x) {
            const TexelRun run = centres_within(x.low, x.high, size);
            for (std::uint32_t& texel : owner.row(row).subspan(run.first, run.count))
                texel = std::min(texel, t);
        });
    }
    return owner;
}

/// Appends runs of equal owners as spans.
void append_spans(std::span<const std::uint32_t> row, std::vector<Span>& spans) {
    for (std::uint32_t x = 0; x < row.size();) {
        std::uint32_t end = x + 1;
        while (end < row.size() && row[end] == row[x]) ++end;
        if (row[x] != nobody) spans.push_back({x, end - x, row[x]});
        x = end;
    }
}

}  // namespace

Atlas atlas_from_uvs(const Mesh& mesh, const Connectivity& connectivity, std::uint32_t size) {
    Atlas atlas;
    atlas.options.size = size;
    atlas.corners.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            atlas.corners[t][k] = mesh.corners.uvs[3 * t + k] * double(size);
    const ChartMetrics charts = measure_charts(mesh, atlas, mesh_edges(mesh, connectivity));
    atlas.charts = charts.of_triangle;
    atlas.chart_count = charts.count;
    atlas.notes.texels_total = std::uint64_t{size} * size;
    return atlas;
}

SolidAtlas rasterize_uvs(const Mesh& mesh, const Atlas& atlas, std::span<const Vec3d> positions) {
    SolidAtlas solid;
    solid.size = atlas.options.size;
    const Image<std::uint32_t> owner = owners(atlas);
    solid.row_begin.push_back(0);
    for (std::size_t y = 0; y < solid.size; ++y) {
        append_spans(owner.row(y), solid.spans);
        solid.row_begin.push_back(solid.spans.size());
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        solid.maps.push_back(
            texel_map(atlas.corners[t], {positions[a], positions[b], positions[c]}, solid.size));
    }
    return solid;
}

}  // namespace burl
