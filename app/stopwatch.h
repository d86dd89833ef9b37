#pragma once
// Adds up the host's time that goes into parts of some work.
#include <chrono>

namespace burl {

/// Adds the seconds it lives to a sum.
class Stopwatch {
  public:
    explicit Stopwatch(double& sum) : sum_(sum) {}
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() {
        sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    double& sum_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// work(), whose seconds are added to `sum`.
template <class Work>
auto timed(double& sum, const Work& work) {
    const Stopwatch stopwatch(sum);
    return work();
}

}  // namespace burl
