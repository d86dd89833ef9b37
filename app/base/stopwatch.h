#pragma once
// Time measurement for parts of a computation.
#include <chrono>
#include <ctime>

namespace burl {

/// Processor time of the calling thread since it started, in seconds.
inline double thread_seconds() {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Wall-clock seconds since `start`.
inline double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The result of work(), whose wall-clock seconds are added to `sum`.
template <class Work>
auto timed(double& sum, const Work& work) {
    const struct Stopwatch {
        double& sum;
        std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
        ~Stopwatch() { sum += seconds_since(start); }
    } stopwatch{sum};
    return work();
}

}  // namespace burl
