#pragma once
// Which instruction set the kernels run on (Highway, chosen at run time), and how a test or a
// measurement holds them to another: results must not depend on it.
#include <cstdint>
#include <string>
#include <vector>

namespace burl {

/// Names of all that the kernels were compiled for and this machine has, the best first.
std::vector<std::string> simd_targets();

/// All kernels of the process use this one of them from here on.
void use_simd_target(const std::string& name);

/// Holds the kernels of the whole process to one of them while it lives: for tests and benchmarks,
/// where nothing else synthesises meanwhile.
class OnlySimdTarget {
  public:
    explicit OnlySimdTarget(const std::string& name);
    ~OnlySimdTarget();
    OnlySimdTarget(const OnlySimdTarget&) = delete;
    OnlySimdTarget& operator=(const OnlySimdTarget&) = delete;

  private:
    std::int64_t before_;
};

}  // namespace burl
