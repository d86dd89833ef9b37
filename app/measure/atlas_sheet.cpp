#include "app/measure/atlas_sheet.h"

#include <algorithm>
#include <cmath>

#include "app/measure/metrics_pictures.h"
#include "atlas/solid/level.h"
#include "procedural/batch/row_tasks.h"
#include "procedural/color/srgb.h"

namespace burl {

namespace {

constexpr std::size_t texels_per_task = 8192;

/// An image with color(map's number, x, y) in every texel of a span, and gap_color elsewhere.
template <class Color>
Image<Rgb8> fill(const SolidAtlas& solid, const Color& color) {
    Image<Rgb8> image(solid.size, solid.size, encoded(gap_color));
    for_row_ranges(solid.size, texels_per_task, 0, [&](const RowRange& rows) {
        for (std::size_t y = rows.begin(); y != rows.end(); ++y)
            for (const Span& span : solid.row(y))
                for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                    image(x, y) = color(span.map, x, y);
    });
    return image;
}

Image<Rgb8> coordinates(const SolidAtlas& solid, const Box3& box) {
    const Vec3d size = box.size();
    const double longest = std::max({size.x, size.y, size.z, 1e-300});
    return fill(solid, [&](std::uint32_t map, std::uint32_t x, std::size_t y) {
        const Vec3d share = (solid.maps[map](x, std::int64_t(y)) - box.low) / longest;
        const Vec3d codes = glm::round(255.0 * glm::clamp(share, Vec3d(0.0), Vec3d(1.0)));
        return Rgb8{std::uint8_t(codes.x), std::uint8_t(codes.y), std::uint8_t(codes.z)};
    });
}

std::vector<Rgb8> triangle_colors(const AtlasSheet& sheet, SheetMode mode) {
    std::vector<Rgb8> colors;
    for (std::size_t t = 0; t < sheet.charts.size(); ++t)
        colors.push_back(encoded(mode == SheetMode::charts ? chart_color(sheet.charts[t])
                                                           : scale_color(sheet.scales[t])));
    return colors;
}

}  // namespace

AtlasSheet atlas_sheet(Pipeline& pipeline) {
    const Affine3 map = solid_from_mesh(pipeline.mesh(), pipeline.recipe().solid.space);
    const Box3 box = bounding_box(pipeline.mesh());
    return {pipeline.solid(),
            {map(box.low), map(box.high)},
            pipeline.atlas().charts,
            relative_scales(pipeline.atlas_mesh(), pipeline.atlas())};
}

std::optional<TexelFacts> texel_facts(const AtlasSheet& sheet, std::int64_t x, std::int64_t y) {
    const std::int64_t size = sheet.solid.size;
    if (x < 0 || y < 0 || x >= size || y >= size) return {};
    for (const Span& span : sheet.solid.row(std::size_t(y))) {
        if (x < span.x || x >= std::int64_t(span.x) + span.count) continue;
        const std::uint32_t triangle = sheet.solid.triangle_of(span.map);
        return TexelFacts{triangle, sheet.charts[triangle], sheet.scales[triangle],
                          sheet.solid.maps[span.map](x, y)};
    }
    return {};
}

std::vector<Image<Rgb8>> sheet_levels(const AtlasSheet& sheet, SheetMode mode) {
    const std::vector<Rgb8> colors = triangle_colors(sheet, mode);
    std::vector<Image<Rgb8>> levels;
    for (std::uint32_t level = 0;; ++level) {
        const SolidAtlas coarse = level > 0 ? solid_level(sheet.solid, level) : SolidAtlas{};
        const SolidAtlas& solid = level > 0 ? coarse : sheet.solid;
        levels.push_back(mode == SheetMode::solid
                             ? coordinates(solid, sheet.box)
                             : fill(solid, [&](std::uint32_t map, std::uint32_t, std::size_t) {
                                   return colors[solid.triangle_of(map)];
                               }));
        if (solid.size <= 1) return levels;
    }
}

}  // namespace burl
