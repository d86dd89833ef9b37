#include "app/paint/tiles.h"

#include <limits>

#include "procedural/batch/row_tasks.h"

namespace burl {

PaintTiles::PaintTiles(const SolidAtlas& solid, int threads, const RowWindow& window)
    : solid_(&solid),
      columns_((solid.size + side - 1) / side),
      first_row_(std::uint32_t(window.of(solid.size).first / side)),
      boxes_((window.of(solid.size).count() + side - 1) / side * columns_) {
    for_row_ranges(boxes_.size() / columns_, 4 * columns_, threads, [&](const RowRange& rows) {
        for (std::size_t tile = rows.begin() * columns_; tile < rows.end() * columns_; ++tile)
            measure(tile);
    });
}

/// Within a span the solid points lie on a straight line, so its two ends bound them.
void PaintTiles::measure(std::size_t tile) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box3 box{Vec3d(infinity), Vec3d(-infinity)};
    const auto column = std::uint32_t(tile % columns_), row = row_of(tile);
    for (std::uint32_t y = row * side; y < end(row); ++y)
        for_each_piece(column * side, end(column), y,
                       [&](std::uint32_t first, std::uint32_t last, const TexelMap& map) {
                           for (const std::uint32_t x : {first, last - 1}) {
                               const Vec3d point = map(x, y);
                               box.low = glm::min(box.low, point);
                               box.high = glm::max(box.high, point);
                           }
                       });
    boxes_[tile] = box;
}

void PaintTiles::add_reached(const PaintBrush& brush, std::vector<bool>& reached) const {
    for (std::size_t tile = 0; tile < boxes_.size(); ++tile) {
        const Box3& box = boxes_[tile];
        if (reached[tile] || !(box.low.x <= box.high.x)) continue;
        if (!may_reach(brush.hull(), brush.radius(), box)) continue;
        reached[tile] = std::ranges::any_of(brush.segments(), [&](const PaintSegment& s) {
            return may_reach(s, brush.radius(), box);
        });
    }
}

}  // namespace burl
