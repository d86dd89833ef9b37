#pragma once
// The lines of an atlas's spans, kept from one texture to the next: where only octaves move, they
// spare a look at every triangle's map and the making of pieces.
#include <vector>

#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/span_lines.h"
#include "procedural/kept/rows.h"

namespace burl {

class KeptLines {
  public:
    /// `solid` must outlive it. Nothing is kept yet.
    explicit KeptLines(const SolidAtlas& solid) : solid_(&solid) {}

    /// What it takes to keep them: 52 bytes a span and a little a row; nobody keeps those of an
    /// atlas that was cut.
    std::size_t bytes_wanted() const;
    std::size_t bytes() const { return known_.empty() ? 0 : bytes_wanted(); }
    /// From now on they are kept, or no longer.
    void keep();
    void drop();
    bool kept() const { return !known_.empty(); }
    /// The texels are others from now on.
    void forget() { std::ranges::fill(known_, std::uint8_t(0)); }

    /// Texels of a row's longest span.
    std::uint32_t longest(std::size_t y) const { return longest_[y]; }
    /// Calls visit(lines) for the texels of a row, a batch at a time. Rows that are not known are
    /// filled from the maps first: one thread to a row.
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
    /// Where a row's numbers begin: with room after it, so that no vector reaches into the next.
    std::size_t begin(std::size_t y) const { return solid_->row_begin[y] + y * span_padding; }
    std::size_t numbers() const { return solid_->spans.size() + solid_->size * span_padding; }
    SpanLines lines_from(std::size_t number) const;
    void fill_row(std::size_t y, const std::vector<TexelMap>& maps);

    const SolidAtlas* solid_;
    KeptArray<double> start_[3], step_[3];
    KeptArray<std::uint32_t> counts_;
    std::vector<std::uint32_t> longest_;  ///< per row
    std::vector<std::uint8_t> known_;     ///< which rows are
};

}  // namespace burl
