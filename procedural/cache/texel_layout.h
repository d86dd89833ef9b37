#pragma once
// Layout of cached numbers per texel of an atlas: row by row, compacted to the texels of spans, and
// the scatter of compacted rows back into an image.
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/texel_batch.h"

namespace burl {

/// Allocates `bytes` aligned to a cache line, or to large pages (2 MiB, by madvise) where it is at
/// least two of them; the whole array is read for every texture. To be freed by std::free. Throws
/// std::bad_alloc.
void* allot_cache(std::size_t bytes);

/// Array of uninitialised numbers, aligned as by allot_cache.
template <class T>
class CacheArray {
  public:
    CacheArray() = default;
    explicit CacheArray(std::size_t count)
        : data_(static_cast<T*>(allot_cache(count * sizeof(T)))) {}
    T* data() const { return data_.get(); }

  private:
    struct Free {
        void operator()(T* data) const { std::free(data); }
    };
    std::unique_ptr<T, Free> data_;
};

/// Layout of an array that holds one number per texel of a span, ordered by row, then x.
class TexelLayout {
  public:
    /// Run of consecutive texels of a row, across spans.
    struct Run {
        std::uint32_t x = 0, count = 0;
    };

    explicit TexelLayout(const SolidAtlas& solid);

    /// The length of an array in this layout. Rows begin at multiples of batch_padding, so that no
    /// vector reaches from one row into the next.
    std::size_t size() const { return begin_.back(); }
    /// The number of texels in spans.
    std::size_t texels() const { return texels_; }
    /// The index of the first number of row y.
    std::size_t begin(std::size_t y) const { return begin_[y]; }
    /// The runs of row y, from left to right.
    std::span<const Run> runs(std::size_t y) const {
        return {runs_.data() + run_begin_[y], run_begin_[y + 1] - run_begin_[y]};
    }
    /// Calls visit(at, count) for batches of at most batch_capacity texels of row y, `at` being the
    /// index of the batch's first number.
    template <class Visit>
    void for_each_batch(std::size_t y, const Visit& visit) const {
        std::size_t left = 0;
        for (const Run& run : runs(y)) left += run.count;
        for (std::size_t at = begin_[y], count = 0; left > 0; left -= count, at += count) {
            count = std::min(left, batch_capacity);
            visit(at, count);
        }
    }

  private:
    std::vector<Run> runs_;
    std::vector<std::size_t> run_begin_;  ///< N+1 offsets into runs_, row by row
    std::vector<std::size_t> begin_;      ///< N+1 offsets into an array of numbers, row by row
    std::size_t texels_ = 0;
};

/// Scatters a row's compacted colours to their runs; the constructor fills the gaps between runs
/// with the background.
template <class Pixel>
class RowPainter {
  public:
    RowPainter(std::span<const TexelLayout::Run> runs, std::span<Pixel> row,
               const Pixel& background)
        : run_(runs.data()), row_(row) {
        std::size_t x = 0;
        for (const TexelLayout::Run& run : runs) {
            std::fill(row.begin() + std::ptrdiff_t(x), row.begin() + run.x, background);
            x = run.x + run.count;
        }
        std::fill(row.begin() + std::ptrdiff_t(x), row.end(), background);
    }

    /// Writes the next `count` texels: calls write(at, part, pixels) for every run that they touch,
    /// `at` counting from 0 in this call and `part` texels being consecutive in `pixels`.
    template <class Write>
    void operator()(std::size_t count, const Write& write) {
        for (std::size_t at = 0; at < count;) {
            const std::size_t part = std::min(count - at, run_->count - done_);
            write(at, part, &row_[run_->x + done_]);
            at += part;
            done_ += part;
            if (done_ == run_->count) ++run_, done_ = 0;
        }
    }

  private:
    const TexelLayout::Run* run_;
    std::size_t done_ = 0;  ///< texels of the current run that are written
    std::span<Pixel> row_;
};

}  // namespace burl
