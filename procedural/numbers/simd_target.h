#pragma once
// The instruction set that the kernels run on (Highway, chosen at run time), and how a test or a
// measurement holds them to another one: results must not depend on it.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace burl {

/// The number of floats in the instruction set's vectors.
std::size_t simd_lanes();

/// Highway's name of the instruction set, such as "AVX3".
std::string simd_level();

/// Names of the instruction sets that the kernels were compiled for and this machine has, the best
/// first.
std::vector<std::string> simd_targets();

/// Makes all kernels of the process use the instruction set of this name from here on.
void use_simd_target(const std::string& name);

/// Holds the kernels of the whole process to one instruction set while it lives: for tests and
/// benchmarks, where no other thread synthesises meanwhile.
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
