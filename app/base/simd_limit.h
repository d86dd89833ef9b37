#pragma once
// Limits the instruction set of all kernels, so that benchmarks can measure a lesser machine.
#include <string>

namespace burl {

/// Makes all kernels of the process use `level`, one of simd_targets(): instruction sets that this
/// machine has and the kernels are compiled for. Throws Error(usage) naming them for any other.
void limit_simd(const std::string& level);

}  // namespace burl
