#include "procedural/maps/span_map.h"

#include <algorithm>

#include "procedural/batch/point_map.h"
#include "procedural/batch/row_tasks.h"

namespace burl {

Image<MapTexel> fill_span_map(const SolidAtlas& solid, const TexelArea& area, int threads) {
    Image<MapTexel> image(area.width, area.height, {no_owner, 0, 0, 0});
    for_row_ranges(area.height, std::size_t{1} << 13, threads, [&](const RowRange& rows) {
        for (std::size_t y = rows.begin(); y != rows.end(); ++y)
            for (const Span& span : solid.row(area.y + y)) {
                const std::uint32_t begin = std::max(span.x, area.x),
                                    end = std::min(span.x + span.count, area.x + area.width);
                const WholeSpan whole = solid.whole(span);
                if (begin < end)
                    std::fill_n(&image(begin - area.x, y), end - begin,
                                MapTexel(span.map, whole.x, whole.count, 0));
            }
    });
    return image;
}

}  // namespace burl
