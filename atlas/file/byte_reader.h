#pragma once
// Numbers read from binary files, in either byte order and at any alignment.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace burl {

/// The number stored at `bytes`; `swapped` says that its byte order is not this machine's.
template <typename Value>
Value load(const char* bytes, bool swapped = false) {
    std::array<char, sizeof(Value)> raw;
    std::memcpy(raw.data(), bytes, sizeof(Value));
    if (swapped) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<Value>(raw);
}

/// Whether this machine stores the highest byte of a number first.
inline constexpr bool big_endian_machine = std::endian::native == std::endian::big;

}  // namespace burl
