#pragma once
// Loops over the rows of an image, shared out among threads.
#include <algorithm>
#include <cstddef>
#include <stop_token>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

namespace burl {

using RowRange = tbb::blocked_range<std::size_t>;

/// Calls work(rows) for ranges that make up rows 0 to size - 1, `size` texels each, with at least
/// about `texels` texels to a range. The ranges decide only which thread works, never the result.
/// `threads` 0 means all; one thread takes all rows as one range, without oneTBB. Where `stop` can
/// be requested, ranges are about `texels` long, and those that have not begun when it is are left
/// out, so that the result must not be used.
template <class Work>
void for_row_ranges(std::size_t size, std::size_t texels, int threads, const Work& work,
                    const std::stop_token& stop = {}) {
    const std::size_t grain = std::max<std::size_t>(1, texels / (size + 1));
    if (threads == 1 && !stop.stop_possible()) return work(RowRange(0, size, grain));
    const auto most =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    tbb::task_arena arena(threads > 0 ? std::min(threads, int(most)) : tbb::task_arena::automatic);
    const RowRange rows(0, size, grain);
    if (!stop.stop_possible()) return arena.execute([&] { tbb::parallel_for(rows, work); });
    const auto unless_stopped = [&](const RowRange& range) {
        if (!stop.stop_requested()) work(range);
    };
    arena.execute([&] { tbb::parallel_for(rows, unless_stopped, tbb::simple_partitioner()); });
}

/// Calls work(rows) as for_row_ranges() does for the `count` rows of a window of an image of `size`
/// texels a side, in ranges as long as those of the whole image.
template <class Work>
void for_window_ranges(std::size_t size, std::size_t count, std::size_t texels, int threads,
                       const Work& work, const std::stop_token& stop = {}) {
    for_row_ranges(count, texels * (count + 1) / (size + 1), threads, work, stop);
}

/// Groups of consecutive rows with at least about `texels` texels each. Groups do not depend on the
/// number of threads, so decisions that are taken per batch of one group do not, either.
struct RowGroups {
    std::size_t size = 0, rows = 1;
    RowGroups(std::size_t rows_in_all, std::size_t texels)
        : size(rows_in_all), rows(std::max<std::size_t>(1, texels / (rows_in_all + 1))) {}

    std::size_t count() const { return (size + rows - 1) / rows; }
    /// The first row of a group, `size` after the last one.
    std::size_t begin(std::size_t group) const { return std::min(size, group * rows); }
};

}  // namespace burl
