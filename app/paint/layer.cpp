#include "app/paint/layer.h"

#include <algorithm>
#include <limits>

#include "procedural/batch/row_tasks.h"

namespace burl {

namespace {

constexpr std::size_t tile_texels = std::size_t(PaintTiles::side) * PaintTiles::side;

/// Whether `now` is `before`, possibly with more points at its end.
bool goes_on(const PaintStroke& before, const PaintStroke& now) {
    PaintStroke brush = now;
    brush.points = before.points;
    return brush == before && !before.points.empty() && now.points.size() >= before.points.size() &&
           std::equal(before.points.begin(), before.points.end(), now.points.begin());
}

/// The part of a stroke that begins with its point `first`.
PaintStroke from_point(const PaintStroke& stroke, std::size_t first) {
    PaintStroke part = stroke;
    part.points.erase(part.points.begin(), part.points.begin() + std::ptrdiff_t(first));
    return part;
}

std::vector<PaintBrush> brushes_of(std::span<const PaintStroke> strokes) {
    return {strokes.begin(), strokes.end()};
}

std::size_t place_in_tile(std::uint32_t x, std::uint32_t y) {
    constexpr std::uint32_t side = PaintTiles::side;
    return std::size_t(y % side) * side + x % side;
}

/// Lays a stroke over a tile's paint and returns whether it may reach the tile.
bool lay_over(const PaintTiles& tiles, std::size_t tile, const PaintBrush& brush,
              std::vector<PaintLight>& paint) {
    const std::vector<PaintSegment> near = tiles.segments_at(brush, tile);
    if (near.empty()) return false;
    paint.resize(tile_texels, PaintLight(0.0f));
    tiles.for_each_texel(
        tile, [&](std::uint32_t x, std::uint32_t y, const Vec3d& point, double width) {
            double least = squared_distance(point, near[0]);
            for (std::size_t k = 1; k < near.size(); ++k)
                least = std::min(least, squared_distance(point, near[k]));
            PaintLight& texel = paint[place_in_tile(x, y)];
            if (const double coverage = brush.coverage(least, width); coverage > 0.0)
                texel = brush.over(texel, coverage);
        });
    return true;
}

}  // namespace

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

std::vector<PaintSegment> PaintTiles::segments_at(const PaintBrush& brush, std::size_t tile) const {
    const Box3& box = boxes_[tile];
    std::vector<PaintSegment> near;
    if (!(box.low.x <= box.high.x) || !may_reach(brush.hull(), brush.radius(), box)) return near;
    for (const PaintSegment& segment : brush.segments())
        if (may_reach(segment, brush.radius(), box)) near.push_back(segment);
    return near;
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

void PaintLayer::add_reached(std::span<const PaintStroke> strokes,
                             std::vector<bool>& reached) const {
    for (const PaintBrush& brush : brushes_of(strokes)) tiles_.add_reached(brush, reached);
}

PaintLayer::Change PaintLayer::change_to(std::span<const PaintStroke> strokes) const {
    Change change;
    change.reached.assign(tiles_.count(), false);
    const auto common =
        std::size_t(std::ranges::mismatch(strokes_, strokes).in1 - strokes_.begin());
    const bool same_count = strokes.size() == strokes_.size();
    if (open_ && same_count && common + 1 == strokes.size() &&
        goes_on(strokes_[common], strokes[common])) {
        change.start = Start::below;
        change.first = common;
        const PaintStroke rest = from_point(strokes[common], strokes_[common].points.size() - 1);
        add_reached({&rest, 1}, change.reached);
        return change;
    }
    change.open = common < strokes.size();
    if (common == strokes_.size()) {
        change.start = Start::all;
        change.first = common;
    }
    add_reached(std::span(strokes_).subspan(common), change.reached);
    add_reached(strokes.subspan(common), change.reached);
    return change;
}

void PaintLayer::redo(std::size_t tile, const Change& change, std::span<const PaintBrush> brushes) {
    TilePaint& old = paint_[tile];
    TilePaint now;
    const bool kept_below = change.start == Start::below && !old.below.empty();
    if (kept_below)
        now.all = std::move(old.below);
    else if (change.start != Start::nothing)
        now.all = std::move(old.all);
    for (std::size_t k = change.first; k < brushes.size(); ++k) {
        if (k + 1 == brushes.size()) now.below = now.all;
        const bool reaches = lay_over(tiles_, tile, brushes[k], now.all);
        if (k + 1 < brushes.size()) continue;
        if (!reaches)
            now.below.clear();
        else
            now.below.resize(tile_texels, PaintLight(0.0f));
    }
    old = std::move(now);
}

PaintWork PaintLayer::update(std::span<const PaintStroke> strokes) {
    PaintWork work;
    if (std::ranges::equal(strokes_, strokes)) return work;
    const Change change = change_to(strokes);
    if (change.start != Start::below) {  // `below` belongs to another stroke
        open_ = change.open;
        for (TilePaint& tile : paint_) tile.below = {};
    }
    for (std::uint32_t tile = 0; tile < tiles_.count(); ++tile)
        if (change.reached[tile]) work.tiles.push_back(tile);
    work.texels = work.tiles.size() * tile_texels;
    const std::vector<PaintBrush> brushes = brushes_of(strokes);
    for_row_ranges(work.tiles.size(), 4 * work.tiles.size(), threads_, [&](const RowRange& some) {
        for (std::size_t k = some.begin(); k < some.end(); ++k)
            redo(work.tiles[k], change, brushes);
    });
    strokes_.assign(strokes.begin(), strokes.end());
    return work;
}

std::vector<std::uint32_t> PaintLayer::painted_tiles() const {
    std::vector<std::uint32_t> painted;
    for (std::uint32_t tile = 0; tile < paint_.size(); ++tile)
        if (!paint_[tile].all.empty()) painted.push_back(tile);
    return painted;
}

std::size_t PaintLayer::bytes() const {
    std::size_t count = 0;
    for (const TilePaint& tile : paint_) count += tile.below.size() + tile.all.size();
    return count * sizeof(PaintLight);
}

}  // namespace burl
