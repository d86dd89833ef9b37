#include "procedural/maps/point_map.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "procedural/batch/point_map.h"
#include "procedural/batch/row_tasks.h"
#include "procedural/noise/lattice_site.h"

namespace burl {

namespace {

/// The line of solid points that the span's texels show.
LatticeLine solid_line(const Span& span, const TexelMap& texel, std::size_t y) {
    return {texel(span.x, std::int64_t(y)), texel.step_x, 0.0, span.count};
}

LatticeLine mapped(const LatticeLine& line, const Affine3& map) {
    return {map(line.start), map.linear * line.step, line.first, line.count};
}

Vec3d point_on(const LatticeLine& line, std::uint32_t column) {
    return line.start + double(column) * line.step;
}

/// Calls visit(x, y, column) for the span's texels in the area: x and y count from the area's
/// corner, `column` from the span's start.
template <class Visit>
void for_texels(const Span& span, std::size_t y, const TexelArea& area, Visit visit) {
    const std::uint32_t begin = std::max(span.x, area.x),
                        end = std::min(span.x + span.count, area.x + area.width);
    for (std::uint32_t x = begin; x < end; ++x) visit(x - area.x, y - area.y, x - span.x);
}

/// Calls visit(y) for the area's rows, several at a time in parallel.
template <class Visit>
void for_rows(const TexelArea& area, int threads, Visit visit) {
    for_row_ranges(area.height, std::size_t{1} << 13, threads, [&](const RowRange& rows) {
        for (std::size_t y = rows.begin(); y != rows.end(); ++y) visit(area.y + y);
    });
}

/// Two doubles as halves, the lower first.
MapTexel halves(double a, double b) {
    const auto u = std::bit_cast<std::uint64_t>(a), v = std::bit_cast<std::uint64_t>(b);
    return {std::uint32_t(u), std::uint32_t(u >> 32), std::uint32_t(v), std::uint32_t(v >> 32)};
}

}  // namespace

PointMap fill_point_map(const SolidAtlas& solid, std::span<const TexelMap> maps, const Affine3& map,
                        bool in_lattice, const TexelArea& area, int threads) {
    const auto gap = std::bit_cast<double>(no_quadric);
    const MapTexel gap_z = halves(gap, 0.0);
    PointMap result{{area.width, area.height, halves(gap, gap)},
                    {area.width, area.height, {gap_z.x, gap_z.y, no_owner, 0}}};
    for_rows(area, threads, [&](std::size_t y) {
        for (const Span& span : solid.row(y)) {
            const LatticeLine solid_points = solid_line(span, maps[span.map], y);
            const LatticeLine line =
                in_lattice ? lattice_line(map, solid_points) : mapped(solid_points, map);
            for_texels(span, y, area, [&](std::size_t x, std::size_t row, std::uint32_t column) {
                const Vec3d p = point_on(line, column);
                const MapTexel z = halves(p.z, 0.0);
                result.xy(x, row) = halves(p.x, p.y);
                result.z_owner(x, row) = {z.x, z.y, span.map, 0};
            });
        }
    });
    return result;
}

Vec3d solid_base(const SolidAtlas& solid, const Affine3& map) {
    Vec3d low(std::numeric_limits<double>::infinity()), high = -low;
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y)) {
            const LatticeLine line = mapped(solid_line(span, solid.maps[span.map], y), map);
            for (const std::uint32_t column : {0u, span.count - 1}) {
                low = glm::min(low, point_on(line, column));
                high = glm::max(high, point_on(line, column));
            }
        }
    return solid.spans.empty() ? Vec3d(0.0) : 0.5 * low + 0.5 * high;
}

SolidMap fill_solid_map(const SolidAtlas& solid, const Affine3& map, const Vec3d& base,
                        const TexelArea& area, int threads) {
    SolidMap result{{area.width, area.height, Vec4f(0.0f)}, {area.width, area.height, no_owner}};
    for_rows(area, threads, [&](std::size_t y) {
        for (const Span& span : solid.row(y)) {
            const LatticeLine line = mapped(solid_line(span, solid.maps[span.map], y), map);
            for_texels(span, y, area, [&](std::size_t x, std::size_t row, std::uint32_t column) {
                result.local(x, row) = Vec4f(Vec3f(point_on(line, column) - base), 1.0f);
                result.owners(x, row) = span.map;
            });
        }
    });
    return result;
}

Image<MapTexel> fill_span_map(const SolidAtlas& solid, const TexelArea& area, int threads) {
    Image<MapTexel> image(area.width, area.height, {no_owner, 0, 0, 0});
    for_rows(area, threads, [&](std::size_t y) {
        for (const Span& span : solid.row(y)) {
            const WholeSpan whole = solid.whole(span);
            for_texels(span, y, area, [&](std::size_t x, std::size_t row, std::uint32_t) {
                image(x, row) = {span.map, whole.x, whole.count, 0};
            });
        }
    });
    return image;
}

}  // namespace burl
