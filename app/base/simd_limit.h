#pragma once
// The instruction set of all kernels, limited for a benchmark: how fast they are on a lesser
// machine.
#include <string>

namespace burl {

/// All kernels of the process use `level` from here on, a name as simd_level has it, of what this
/// machine has and the kernels are compiled for. Throws Error(usage), naming those.
void limit_simd(const std::string& level);

}  // namespace burl
