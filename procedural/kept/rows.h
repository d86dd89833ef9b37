#pragma once
// Where numbers lie that are kept of an atlas's texels from one texture to the next: row by row
// without the texels that nobody owns, and back from there into an image.
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/texel_batch.h"

namespace burl {

/// Memory that begins on a line of the cache, in large pages where there is much of it and the
/// system lends them: it is read from end to end for every texture. For std::free.
void* allot_kept(std::size_t bytes);

/// Uninitialised numbers that begin on a line of the cache.
template <class T>
class KeptArray {
  public:
    KeptArray() = default;
    explicit KeptArray(std::size_t count) : data_(static_cast<T*>(allot_kept(count * sizeof(T)))) {}
    T* data() const { return data_.get(); }

  private:
    struct Free {
        void operator()(T* data) const { std::free(data); }
    };
    std::unique_ptr<T, Free> data_;
};

class KeptRows {
  public:
    /// Texels that follow one another in a row.
    struct Run {
        std::uint32_t x = 0, count = 0;
    };

    explicit KeptRows(const SolidAtlas& solid);

    /// Numbers an array of them holds: rows begin at multiples of batch_padding, so that no vector
    /// reaches from one into the next.
    std::size_t size() const { return begin_.back(); }
    /// Texels that somebody owns.
    std::size_t texels() const { return texels_; }
    /// Where a row's numbers begin.
    std::size_t begin(std::size_t y) const { return begin_[y]; }
    std::span<const Run> runs(std::size_t y) const {
        return {runs_.data() + run_begin_[y], run_begin_[y + 1] - run_begin_[y]};
    }
    /// Calls visit(first number, count) for the texels of a row, a batch at a time.
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
    std::vector<std::size_t> run_begin_;  ///< N+1 offsets into runs_
    std::vector<std::size_t> begin_;      ///< N+1 offsets
    std::size_t texels_ = 0;
};

/// Puts a row's colours, which come in order, where they belong, and the background between them.
template <class Pixel>
class RowPainter {
  public:
    RowPainter(std::span<const KeptRows::Run> runs, std::span<Pixel> row, const Pixel& background)
        : run_(runs.data()), row_(row) {
        std::size_t x = 0;
        for (const KeptRows::Run& run : runs) {
            std::fill(row.begin() + std::ptrdiff_t(x), row.begin() + run.x, background);
            x = run.x + run.count;
        }
        std::fill(row.begin() + std::ptrdiff_t(x), row.end(), background);
    }

    /// The next `count` texels: write(at, count, pixels) writes some of them, from number `at` on.
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
    const KeptRows::Run* run_;
    std::size_t done_ = 0;  ///< texels of the run
    std::span<Pixel> row_;
};

}  // namespace burl
