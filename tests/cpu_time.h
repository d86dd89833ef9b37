#pragma once
// Processor time for tests of how time grows with the size of a task: ratios, unlike seconds, are
// much the same on every machine and with every sanitizer.
#include <algorithm>
#include <ctime>

namespace burl::test {

/// Returns the program's processor time for `work`, in clock ticks: the least of three runs.
template <class Work>
double cpu_time(const Work& work) {
    std::clock_t least = 0;
    for (int run = 0; run < 3; ++run) {
        const std::clock_t start = std::clock();
        work();
        const std::clock_t taken = std::clock() - start;
        least = run == 0 ? taken : std::min(least, taken);
    }
    return double(least);
}

}  // namespace burl::test
