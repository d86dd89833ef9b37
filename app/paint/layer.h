#pragma once
// The paint of a recipe on the texels of one atlas, kept from one set of strokes to the next: a
// stroke that goes on, one more stroke, or strokes taken back redo only the tiles they reach. What
// lies below does not matter to it, so that the texture may change under the paint.
#include <cstdint>
#include <span>
#include <vector>

#include "app/paint/tiles.h"

namespace burl {

/// What the last update() went through.
struct PaintWork {
    std::uint64_t texels = 0;
    std::vector<std::uint32_t> tiles{};  ///< whose paint may have changed, in order
};

class PaintLayer {
  public:
    /// Of some rows, as PaintTiles. `solid` must outlive this. `threads` 0: all; no result depends
    /// on it.
    PaintLayer(const SolidAtlas& solid, int threads, const RowWindow& rows = {})
        : tiles_(solid, threads, rows), threads_(threads), paint_(tiles_.count()) {}

    const PaintTiles& tiles() const { return tiles_; }
    /// From now on the paint of these strokes, bit for bit as if they were the first.
    PaintWork update(std::span<const PaintStroke> strokes);
    /// A tile's paint, row by row of PaintTiles::side texels; empty where there is none.
    std::span<const PaintLight> paint(std::size_t tile) const { return paint_[tile].all; }
    /// Tiles that have paint, in order.
    std::vector<std::uint32_t> painted_tiles() const;
    std::size_t bytes() const;

  private:
    struct TilePaint {
        std::vector<PaintLight> below{};  ///< of all strokes but the last, where that reaches
        std::vector<PaintLight> all{};
    };
    /// Strokes from `first` on are laid over what `start` names.
    enum class Start { nothing, below, all };
    struct Change {
        Start start = Start::nothing;
        std::size_t first = 0;
        bool open = true;  ///< the last stroke is among those that differ
        std::vector<bool> reached{};
    };
    Change change_to(std::span<const PaintStroke> strokes) const;
    void add_reached(std::span<const PaintStroke> strokes, std::vector<bool>& reached) const;
    void redo(std::size_t tile, const Change& change, std::span<const PaintBrush> brushes);

    PaintTiles tiles_;
    int threads_;
    std::vector<PaintStroke> strokes_;
    bool open_ = false;  ///< `below` is there wherever the last stroke reaches
    std::vector<TilePaint> paint_;
};

}  // namespace burl
