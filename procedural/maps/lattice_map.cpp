#include "procedural/maps/lattice_map.h"

#include <algorithm>
#include <bit>
#include <memory>

#include "procedural/fill/pieces.h"
#include "procedural/kernels/quadric_kernel.h"

namespace burl {

namespace {

/// The rows of the images that one thread fills.
class LatticeMapRows {
  public:
    LatticeMapRows(const std::optional<LatticeStreamKey>& stream,
                   const std::optional<Quadric>& quadric, const TexelArea& area, LatticeMap& map)
        : stream_(stream), quadric_(quadric), area_(area), map_(map) {
        if (!quadric) std::fill_n(batch_->field, batch_capacity, 0.0);
        if (stream) return;
        LatticeStream& lattice = batch_->streams.lattice;
        for (int axis = 0; axis < 3; ++axis) {
            std::fill_n(lattice.cells[axis], batch_capacity, 0u);
            std::fill_n(lattice.places[axis], batch_capacity, 0u);
        }
    }

    void add(const SolidAtlas& solid, std::span<const TexelMap> maps, std::size_t y) {
        const auto spans = solid.row(y);
        std::size_t owned = area_.x;
        for (const Span& span : spans) {
            if (std::size_t(&spans.back() - &span) >= map_prefetch)
                prefetch(maps[(&span)[map_prefetch].map]);
            const std::size_t begin = std::max(span.x, area_.x);
            const std::size_t end = std::min(span.x + span.count, area_.x + area_.width);
            if (begin >= end) continue;
            mark_gap(owned, begin, y);
            const WholeSpan whole = solid.whole(span);
            add(whole, maps[span.map], y, begin - whole.x, end - whole.x);
            owned = end;
        }
        mark_gap(owned, area_.x + area_.width, y);
    }

    void flush() {
        FieldBatch& batch = *batch_;
        if (batch.count == 0) return;
        if (stream_)
            fill_stream(stream_->lattice_from_solid, stream_->doublings, batch.pieces,
                        batch.streams.lattice, stream_->period);
        if (quadric_) {
            batch.parabolas.resize(batch.pieces.size());
            make_parabolas(*quadric_, 0.0, batch.pieces, batch.parabolas);
            fill_parabolas(batch.parabolas, batch.field);
        }
        std::size_t at = 0;
        for (const Piece& piece : batch.pieces) {
            store(piece, at);
            at += piece.solid.count;
        }
        batch.pieces.clear();
        batch.count = 0;
    }

  private:
    void mark_gap(std::size_t begin, std::size_t end, std::size_t y) {
        if (begin == end) return;
        std::fill_n(&map_.cells(begin - area_.x, y - area_.y), end - begin,
                    MapTexel(0, 0, 0, std::uint32_t(no_quadric >> 32)));
        std::fill_n(&map_.places(begin - area_.x, y - area_.y), end - begin,
                    MapTexel(0, 0, 0, std::uint32_t(no_quadric)));
    }

    /// Adds texels `done` to end - 1 of the span.
    void add(const WholeSpan& span, const TexelMap& texel, std::size_t y, std::size_t done,
             std::size_t end) {
        const Vec3d start = texel(span.x, std::int64_t(y));
        while (done < end) {
            const std::size_t count = std::min(end - done, batch_capacity - batch_->count);
            add_piece(span, texel, start, y, done, count, *batch_);
            done += count;
            if (batch_->count == batch_capacity) flush();
        }
    }

    void store(const Piece& piece, std::size_t at) {
        const LatticeStream& lattice = batch_->streams.lattice;
        MapTexel* cells = &map_.cells(piece.x - area_.x, piece.y - area_.y);
        MapTexel* places = &map_.places(piece.x - area_.x, piece.y - area_.y);
        for (std::size_t j = at; j < at + piece.solid.count; ++j) {
            const auto q = std::bit_cast<std::uint64_t>(batch_->field[j]);
            const auto &c = lattice.cells, &p = lattice.places;
            *cells++ = {c[0][j], c[1][j], c[2][j], std::uint32_t(q >> 32)};
            *places++ = {p[0][j], p[1][j], p[2][j], std::uint32_t(q)};
        }
    }

    const std::optional<LatticeStreamKey>& stream_;
    const std::optional<Quadric>& quadric_;
    const TexelArea& area_;
    LatticeMap& map_;
    std::unique_ptr<FieldBatch> batch_ = std::make_unique_for_overwrite<FieldBatch>();
};

}  // namespace

LatticeMap fill_lattice_map(const SolidAtlas& solid, std::span<const TexelMap> maps,
                            const std::optional<LatticeStreamKey>& stream,
                            const std::optional<Quadric>& quadric, const TexelArea& area,
                            int threads) {
    LatticeMap map{Image<MapTexel>::unset(area.width, area.height),
                   Image<MapTexel>::unset(area.width, area.height)};
    for_row_ranges(area.height, 8 * batch_capacity, threads, [&](const RowRange& rows) {
        LatticeMapRows filler(stream, quadric, area, map);
        for (std::size_t y = rows.begin(); y != rows.end(); ++y)
            filler.add(solid, maps, area.y + y);
        filler.flush();
    });
    return map;
}

}  // namespace burl
