#pragma once
// The spans of an atlas's rows, cut into pieces that fill batches.
#include <algorithm>
#include <span>
#include <vector>

#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/row_tasks.h"
#include "procedural/batch/row_window.h"
#include "procedural/field/sampler.h"

namespace burl {

/// The maps of texels followed by another map, each computed on access: a list of them would be as
/// large as the atlas's own.
class MovedMaps {
  public:
    /// The maps `maps` followed by `map`; `maps` must outlive the object.
    MovedMaps(std::span<const TexelMap> maps, const Affine3& map) : maps_(maps), map_(map) {}

    TexelMap operator[](std::size_t i) const {
        const TexelMap& m = maps_[i];
        return {map_(m.origin), map_.linear * m.step_x, map_.linear * m.step_y, m.anchor_x,
                m.anchor_y};
    }
    /// The map from which element i is computed.
    const TexelMap& source(std::size_t i) const { return maps_[i]; }

  private:
    std::span<const TexelMap> maps_;
    Affine3 map_;
};

/// The list of all moved maps, for callers that read each of them many times.
inline std::vector<TexelMap> moved_maps(const std::vector<TexelMap>& maps, const Affine3& map,
                                        int threads) {
    std::vector<TexelMap> result(maps.size());
    const MovedMaps moved(maps, map);
    for_row_ranges(maps.size(), 1, threads, [&](const RowRange& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) result[i] = moved[i];
    });
    return result;
}

/// The number of texels in a row's spans.
inline std::size_t texels_of(std::span<const Span> spans) {
    std::size_t count = 0;
    for (const Span& span : spans) count += span.count;
    return count;
}

/// The number of texels in the spans of rows `first` to `end` - 1.
inline std::size_t texels_of(const SolidAtlas& solid, std::size_t first, std::size_t end) {
    const Span* const spans = solid.spans.data();
    return texels_of(std::span(spans + solid.row_begin[first], spans + solid.row_begin[end]));
}

/// Fills the texels of a row that no span owns.
template <class Pixel>
void fill_gaps(std::span<const Span> spans, const Pixel& background, std::span<Pixel> row) {
    auto owned = row.begin();
    for (const Span& span : spans) {
        std::fill(owned, row.begin() + span.x, background);
        owned = row.begin() + span.x + span.count;
    }
    std::fill(owned, row.end(), background);
}

/// The number of spans ahead for which maps are prefetched: neighbouring spans show triangles from
/// all over the mesh, which hardware does not prefetch.
inline constexpr std::ptrdiff_t map_prefetch = 8;

inline void prefetch(const TexelMap& map) {
    const char* bytes = reinterpret_cast<const char*>(&map);
    __builtin_prefetch(bytes);
    __builtin_prefetch(bytes + sizeof(TexelMap) - 1);
}

/// The map in memory from which element i is read.
inline const TexelMap& stored(std::span<const TexelMap> maps, std::size_t i) {
    return maps[i];
}
inline const TexelMap& stored(const MovedMaps& maps, std::size_t i) {
    return maps.source(i);
}

/// Adds `count` texels of the span from number `first` on to the batch; `start` is the solid point
/// of texel 0 of the span.
inline void add_piece(const WholeSpan& span, const TexelMap& texel, const Vec3d& start,
                      std::size_t y, std::size_t first, std::size_t count, FieldBatch& batch) {
    // The piece is filled in place and not by emplace_back(), which clears it by `rep stos`, a
    // quarter of this function's time, as are copies of vectors just written.
    static constexpr Piece blank;
    batch.pieces.push_back(blank);
    Piece& piece = batch.pieces.back();
    piece.x = span.x + first;
    piece.y = y;
    piece.solid.start.x = start.x, piece.solid.start.y = start.y, piece.solid.start.z = start.z;
    piece.solid.step = texel.step_x;
    piece.solid.first = double(first);
    piece.solid.count = count;
    piece.down = texel.step_y;
    piece.length = double(span.count);
    batch.count += count;
}

/// The texels of some rows, read a batch at a time; `Maps` is MovedMaps or a list of TexelMap.
template <class Maps>
class PieceReader {
  public:
    /// The rows `rows`; the atlas and the maps must outlive the object.
    PieceReader(const SolidAtlas& solid, const Maps& maps, const RowWindow& rows)
        : solid_(solid), maps_(maps), y_(rows.first), end_(rows.end) {}

    /// Replaces the batch's pieces by the next texels, batch_capacity of them but for the last
    /// time; false if there are none left.
    bool read(FieldBatch& batch) {
        batch.pieces.clear();
        batch.count = 0;
        for (; y_ < end_; ++y_, number_ = 0) {
            const std::span<const Span> spans = solid_.row(y_);
            for (; number_ < spans.size(); ++number_, done_ = 0) {
                if (batch.count == batch_capacity) return true;
                if (std::ptrdiff_t(spans.size() - number_) > map_prefetch)
                    prefetch(stored(maps_, (&spans[number_])[map_prefetch].map));
                if (!add_rest(spans[number_], batch)) return true;
            }
        }
        return batch.count > 0;
    }

  private:
    /// Adds the texels of the span from number `done_` on; false if the batch has no room for all.
    bool add_rest(const Span& span, FieldBatch& batch) {
        const TexelMap& texel = maps_[span.map];
        const WholeSpan whole = solid_.whole(span);
        const std::size_t count =
            std::min<std::size_t>(span.count - done_, batch_capacity - batch.count);
        add_piece(whole, texel, texel(whole.x, std::int64_t(y_)), y_, span.x - whole.x + done_,
                  count, batch);
        done_ += count;
        return done_ == span.count;
    }

    const SolidAtlas& solid_;
    const Maps& maps_;
    std::size_t y_, end_;
    std::size_t number_ = 0;  ///< number in its row of the span to be read
    std::size_t done_ = 0;    ///< texels of that span that have been read
};

}  // namespace burl
