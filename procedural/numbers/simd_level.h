#pragma once
// The instruction set that the kernels run on.
#include <cstddef>
#include <string>

namespace burl {

/// The number of floats in the instruction set's vectors.
std::size_t simd_lanes();

/// Highway's name of the instruction set, such as "AVX3".
std::string simd_level();

}  // namespace burl
