#pragma once
// Loops whose rounds have nothing to do with one another, shared out among threads.
#include <cstddef>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace burl {

/// Calls work(i) for every i < count. What a call writes must be its own: then nothing depends on
/// who does what.
template <class Work>
void for_each_index(std::size_t count, const Work& work) {
    constexpr std::size_t grain = 4096;
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, count, grain), [&](const Range& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
    });
}

}  // namespace burl
