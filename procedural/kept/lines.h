#pragma once
// Cache of the lines of an atlas's spans in texture space: while only octaves change, it spares the
// reading of every triangle's map and the building of pieces.
#include <vector>

#include "atlas/solid/solid_atlas.h"
#include "procedural/kept/rows.h"
#include "procedural/kernels/lattice_stream.h"

namespace burl {

/// Cached span lines of one atlas, filled row by row. Different rows may be used by different
/// threads at a time.
class KeptLines {
  public:
    /// `solid` must outlive this object. The cache is empty.
    explicit KeptLines(const SolidAtlas& solid) : solid_(&solid) {}

    /// The size of a full cache in bytes: 52 per span and span_padding spans more per row; the
    /// largest size_t for an atlas that was cut, which is not supported.
    std::size_t bytes_wanted() const;
    /// The size of the allotted arrays in bytes.
    std::size_t bytes() const { return known_.empty() ? 0 : bytes_wanted(); }
    /// Allots the arrays; their rows are filled on first use.
    void keep();
    /// Frees the arrays.
    void drop();
    bool kept() const { return !known_.empty(); }
    /// Marks all rows as invalid.
    void forget() { std::ranges::fill(known_, std::uint8_t(0)); }

    /// The number of texels in the longest span of row y.
    std::uint32_t longest(std::size_t y) const { return longest_[y]; }
    /// Calls visit(lines) for the texels of row y, in batches of at most batch_capacity texels. A
    /// row that is not valid is filled from the maps first; two threads must not use the same row
    /// at a time.
    template <class Visit>
    void for_each_batch(std::size_t y, const std::vector<TexelMap>& maps, const Visit& visit) {
        if (!known_[y]) fill_row(y, maps);
        const std::size_t end = begin(y) + solid_->row(y).size();
        std::size_t first = 0;
        for (std::size_t i = begin(y); i < end;) {
            SpanLines lines = lines_from(i);
            lines.first = first;
            for (; i < end && lines.texels < batch_capacity; ++lines.spans) {
                const std::size_t rest = counts_.data()[i] - first;
                const std::size_t texels = std::min(rest, batch_capacity - lines.texels);
                lines.texels += texels;
                first = texels == rest ? 0 : first + texels;
                if (first == 0) ++i;
            }
            visit(lines);
        }
    }

  private:
    /// The index of a row's first span in the arrays; span_padding spans follow every row, so that
    /// no vector reaches into the next.
    std::size_t begin(std::size_t y) const { return solid_->row_begin[y] + y * span_padding; }
    std::size_t numbers() const { return solid_->spans.size() + solid_->size * span_padding; }
    SpanLines lines_from(std::size_t number) const;
    void fill_row(std::size_t y, const std::vector<TexelMap>& maps);

    const SolidAtlas* solid_;
    KeptArray<double> start_[3], step_[3];
    KeptArray<std::uint32_t> counts_;
    std::vector<std::uint32_t> longest_;  ///< texels of every row's longest span
    std::vector<std::uint8_t> known_;     ///< flag of each row: whether its lines are valid
};

}  // namespace burl
