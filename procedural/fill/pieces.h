#pragma once
// The spans of an atlas's rows, cut into pieces that fill batches.
#include <algorithm>
#include <span>
#include <vector>

#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/row_tasks.h"
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

/// Adds row y's texels to the batch; `maps` is a list or MovedMaps. Calls full(), which must empty
/// the batch, whenever the batch is full.
template <class Maps, class Full>
void add_row(const SolidAtlas& solid, const Maps& maps, std::size_t y, FieldBatch& batch,
             const Full& full) {
    const auto spans = solid.row(y);
    for (const Span& span : spans) {
        if (&spans.back() - &span >= map_prefetch)
            prefetch(stored(maps, (&span)[map_prefetch].map));
        const TexelMap& texel = maps[span.map];
        const WholeSpan whole = solid.whole(span);
        const std::size_t before = span.x - whole.x, end = before + span.count;
        const Vec3d start = texel(whole.x, std::int64_t(y));
        for (std::size_t done = before; done < end;) {
            const std::size_t count = std::min(end - done, batch_capacity - batch.count);
            add_piece(whole, texel, start, y, done, count, batch);
            done += count;
            if (batch.count == batch_capacity) full();
        }
    }
}

}  // namespace burl
