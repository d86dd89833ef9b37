#pragma once
// The instruction set that the kernels run on.
#include <cstddef>
#include <string>

namespace burl {

/// Floats in its vectors.
std::size_t simd_lanes();

/// Its name, such as "AVX3".
std::string simd_level();

}  // namespace burl
