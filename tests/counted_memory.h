#pragma once
// Counts the bytes allocated by operator new, which the test program replaces where the C library
// reports block sizes. Unlike the size of the process, these peaks depend on nothing else.
#include <cstddef>

namespace burl {

/// Whether bytes are counted.
bool counts_bytes();
/// Begins to measure a peak, relative to the bytes allocated now.
void begin_peak();
/// The peak of allocated bytes since begin_peak(), beyond those allocated then.
std::size_t peak_bytes();

}  // namespace burl
