#pragma once
// The paint of a recipe on the texels of one atlas, updated incrementally: a stroke that goes on, a
// new stroke or an undone one recomputes only the tiles it reaches. It is independent of the
// texture below, which may change under the paint.
#include <cstdint>
#include <span>
#include <vector>

#include "app/paint/tiles.h"

namespace burl {

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
