#pragma once
// The paint of a recipe on the texels of one atlas, updated incrementally: a stroke that goes on, a
// new stroke or an undone one recomputes only the tiles it reaches. It is independent of the
// texture below, which may change under the paint.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "app/paint/brush.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/row_window.h"

namespace burl {

/// A texture divided into square tiles of texels, each with the bounding box of its solid points,
/// so that a brush finds the few tiles it reaches. Neighbouring texels are near one another on the
/// surface, except in tiles across several blocks, whose larger boxes only cost time.
class PaintTiles {
  public:
    static constexpr std::uint32_t side = 16;  ///< the side of a tile in texels

    /// Tiles of some rows of the texture, of which the first is a multiple of `side`; tile 0 begins
    /// there. `solid` must outlive this. 0 threads means all.
    PaintTiles(const SolidAtlas& solid, int threads, const RowWindow& rows = {});

    std::uint32_t columns() const { return columns_; }
    std::size_t count() const { return boxes_.size(); }
    /// The bounding box of the solid points of a tile's texels; low > high where it has none.
    const Box3& box(std::size_t tile) const { return boxes_[tile]; }

    /// Sets `reached` for the tiles that the brush may cover in part.
    void add_reached(const PaintBrush& brush, std::vector<bool>& reached) const;

    /// The segments of the brush that may come within its radius of the tile.
    std::vector<PaintSegment> segments_at(const PaintBrush& brush, std::size_t tile) const;

    /// Calls visit(x, y, solid point, width) for the tile's texels in spans. The width is the
    /// distance to the farther of the neighbours in x and y, in solid units.
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
    /// Calls visit(first, last + 1, map) for the parts of a row's spans within texels [begin, end).
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
    std::uint32_t columns_, first_row_;  ///< counts of tiles
    std::vector<Box3> boxes_;
};

/// The work of the last update().
struct PaintWork {
    /// The number of texels in the tiles that were recomputed.
    std::uint64_t texels = 0;
    /// The tiles whose paint may have changed, in ascending order.
    std::vector<std::uint32_t> tiles{};
};

class PaintLayer {
  public:
    /// A layer without paint on some rows of the atlas, as PaintTiles takes them. `solid` must
    /// outlive the layer. 0 threads means all; the number does not affect results.
    PaintLayer(const SolidAtlas& solid, int threads, const RowWindow& rows = {})
        : tiles_(solid, threads, rows), threads_(threads), paint_(tiles_.count()) {}

    const PaintTiles& tiles() const { return tiles_; }
    /// Makes the layer hold the paint of these strokes, bit for bit as if computed from nothing.
    PaintWork update(std::span<const PaintStroke> strokes);
    /// The paint of a tile, side x side texels in row order (PaintTiles::side); empty where there
    /// is none.
    std::span<const PaintLight> paint(std::size_t tile) const { return paint_[tile].all; }
    /// The tiles that have paint, in ascending order.
    std::vector<std::uint32_t> painted_tiles() const;
    std::size_t bytes() const;

  private:
    struct TilePaint {
        /// The paint of all strokes but the last, in tiles that the last one reaches.
        std::vector<PaintLight> below{};
        std::vector<PaintLight> all{};
    };
    /// The paint that strokes from `first` on are laid over.
    enum class Start { nothing, below, all };
    struct Change {
        Start start = Start::nothing;
        std::size_t first = 0;
        bool open = true;  ///< whether the last stroke is among those that differ
        std::vector<bool> reached{};
    };
    Change change_to(std::span<const PaintStroke> strokes) const;
    void add_reached(std::span<const PaintStroke> strokes, std::vector<bool>& reached) const;
    void redo(std::size_t tile, const Change& change, std::span<const PaintBrush> brushes);

    PaintTiles tiles_;
    int threads_;
    std::vector<PaintStroke> strokes_;
    bool open_ = false;  ///< whether `below` is stored wherever the last stroke reaches
    std::vector<TilePaint> paint_;
};

}  // namespace burl
