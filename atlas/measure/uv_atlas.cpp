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
        solid.maps.push_back(affine_map(atlas.corners[t],
                                        {positions[a], positions[b], positions[c]}, {0, 0},
                                        {solid.size, solid.size}));
    }
    return solid;
}

}  // namespace burl
