#include "app/paint/mask.h"

#include "app/paint/layer.h"
#include "procedural/batch/row_tasks.h"

namespace burl {

namespace {

/// A stroke's brush with those of its segments that may reach a tile.
struct NearBrush {
    const PaintBrush& brush;
    std::vector<PaintSegment> segments;
};

Dual coverage_at(std::span<const NearBrush> brushes, const Vec3d& point, double texel) {
    Dual covered;
    for (const auto& [brush, segments] : brushes)
        covered = brush.over(covered, brush.coverage(point, segments, texel));
    return covered;
}

void fill_tile(const PaintTiles& tiles, std::size_t tile, std::span<const PaintBrush> brushes,
               TexelField& field) {
    std::vector<NearBrush> near;
    for (const PaintBrush& brush : brushes)
        if (auto segments = tiles.segments_at(brush, tile); !segments.empty())
            near.push_back({brush, std::move(segments)});
    if (near.empty()) return;
    tiles.for_each_texel(tile,
                         [&](std::uint32_t x, std::uint32_t y, const Vec3d& point, double width) {
                             const Dual covered = coverage_at(near, point, width);
                             field.values(x, y) = float(covered.value);
                             if (field.slopes.width() > 0)
                                 field.slopes(x, y) = Vec3f(covered.slope);
                         });
}

}  // namespace

TexelField paint_mask(const SolidAtlas& solid, std::span<const PaintStroke> strokes, bool slopes,
                      int threads, const std::stop_token& stop) {
    TexelField field{Image<float>(solid.size, solid.size, 0.0f)};
    if (slopes) field.slopes = Image<Vec3f>(solid.size, solid.size, Vec3f(0.0f));
    if (strokes.empty()) return field;
    const PaintTiles tiles(solid, threads);
    const std::vector<PaintBrush> brushes(strokes.begin(), strokes.end());
    const std::size_t columns = tiles.columns();
    for_row_ranges(
        tiles.count() / columns, 4 * columns, threads,
        [&](const RowRange& rows) {
            for (std::size_t tile = rows.begin() * columns; tile < rows.end() * columns; ++tile)
                fill_tile(tiles, tile, brushes, field);
        },
        stop);
    return field;
}

std::vector<Dual> paint_mask_at(std::span<const Vec3d> points,
                                std::span<const PaintStroke> strokes) {
    const std::vector<PaintBrush> brushes(strokes.begin(), strokes.end());
    std::vector<NearBrush> all;
    for (const PaintBrush& brush : brushes)
        if (!brush.segments().empty())
            all.push_back({brush, {brush.segments().begin(), brush.segments().end()}});
    std::vector<Dual> values;
    for (const Vec3d& point : points) values.push_back(coverage_at(all, point, 0.0));
    return values;
}

}  // namespace burl
