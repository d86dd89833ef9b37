#pragma once
// Bytes that a test program holds by operator new, which its own takes the place of where the C
// library says how large a block is: peaks that, unlike the process's size, depend on nothing else.
#include <cstddef>

namespace burl {

/// False where bytes are not counted.
bool counts_bytes();
/// Starts looking for a peak, from what is held now on.
void begin_peak();
/// The most bytes held at a time since, beyond those held then.
std::size_t peak_bytes();

}  // namespace burl
