#pragma once
// A texture cut into squares of texels that know which part of solid space they show, so that a
// brush finds the few it reaches. Texels that are neighbours in the texture are near one another on
// the surface, but for a tile that lies across several blocks, whose box is large and costs time.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "app/paint/brush.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/row_window.h"

namespace burl {

class PaintTiles {
  public:
    static constexpr std::uint32_t side = 16;  ///< texels

    /// Of some rows, the first of them a multiple of `side`: the first tile is the one there.
    /// `solid` must outlive this. `threads` 0: all.
    PaintTiles(const SolidAtlas& solid, int threads, const RowWindow& rows = {});

    std::uint32_t size() const { return solid_->size; }  ///< of the texture, in texels
    std::uint32_t columns() const { return columns_; }
    std::size_t count() const { return boxes_.size(); }
    /// Of the solid points of a tile's texels; low > high: it has none.
    const Box3& box(std::size_t tile) const { return boxes_[tile]; }

    /// Adds to `reached` those that the brush may cover some of.
    void add_reached(const PaintBrush& brush, std::vector<bool>& reached) const;

    /// Calls visit(x, y, solid point, width) for the tile's texels that have a point; the width is
    /// the longer step to a neighbour, in solid units.
    template <class Visit>
    void for_each_texel(std::size_t tile, const Visit& visit) const {
        const auto column = std::uint32_t(tile % columns_), row = row_of(tile);
        for (std::uint32_t y = row * side; y < end(row); ++y)
            for_each_piece(column * side, end(column), y,
                           [&](std::uint32_t first, std::uint32_t last, const TexelMap& map) {
                               const double width =
                                   std::max(glm::length(map.step_x), glm::length(map.step_y));
                               for (std::uint32_t x = first; x < last; ++x)
                                   visit(x, y, map(x, y), width);
                           });
    }

  private:
    std::uint32_t row_of(std::size_t tile) const {
        return first_row_ + std::uint32_t(tile / columns_);
    }
    std::uint32_t end(std::uint32_t index) const {
        return std::min(solid_->size, (index + 1) * side);
    }
    /// Calls visit(first, last + 1, map) for the parts of spans within texels [begin, end) of a
    /// row.
    template <class Visit>
    void for_each_piece(std::uint32_t begin, std::uint32_t end, std::uint32_t y,
                        const Visit& visit) const {
        const std::span<const Span> row = solid_->row(y);
        auto span = std::partition_point(row.begin(), row.end(),
                                         [&](const Span& s) { return s.x + s.count <= begin; });
        for (; span != row.end() && span->x < end; ++span)
            visit(std::max(begin, span->x), std::min(end, span->x + span->count),
                  solid_->maps[span->map]);
    }
    void measure(std::size_t tile);

    const SolidAtlas* solid_;
    std::uint32_t columns_, first_row_;  ///< in tiles
    std::vector<Box3> boxes_;
};

}  // namespace burl
