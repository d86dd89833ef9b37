#pragma once
// The rows of an image shared out among threads.
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

/// Calls work(rows) for ranges that make up rows 0 to size - 1, `size` texels each, about `texels`
/// texels a range or more: that decides only who works, not what comes out. `threads` 0 means all.
/// Where somebody may ask to stop, ranges are about that long, and those that have not begun when
/// it happens are left out: what comes out is then worth nothing.
template <class Work>
void for_row_ranges(std::size_t size, std::size_t texels, int threads, const Work& work,
                    const std::stop_token& stop = {}) {
    const std::size_t grain = std::max<std::size_t>(1, texels / (size + 1));
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

/// Groups of so many rows that they have about so many texels or more: what is decided for a batch
/// of texels of one group does not depend on who else works.
struct RowGroups {
    std::size_t size = 0, rows = 1;
    RowGroups(std::size_t rows_in_all, std::size_t texels)
        : size(rows_in_all), rows(std::max<std::size_t>(1, texels / (rows_in_all + 1))) {}

    std::size_t count() const { return (size + rows - 1) / rows; }
    /// The first row of a group, `size` after the last one.
    std::size_t begin(std::size_t group) const { return std::min(size, group * rows); }
};

}  // namespace burl
