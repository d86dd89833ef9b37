#pragma once
// Parallel loops over indices whose iterations are independent of one another (oneTBB).
#include <cstddef>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace burl {

/// Calls work(i) once for every i < count, on several threads, `grain` calls or more at a time.
/// Each call may write only data of its own; then the result does not depend on the number of
/// threads.
template <class Work>
void for_each_index(std::size_t count, const Work& work, std::size_t grain = 4096) {
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, count, grain), [&](const Range& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
    });
}

}  // namespace burl
