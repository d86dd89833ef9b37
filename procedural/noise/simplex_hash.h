#pragma once
// Tables with which a byte shuffle of 16 entries computes the bit-pattern hash of simplex noise
// (Perlin 2001, appendix B, shuffle) and the gradient that it names, for all lanes of a vector at
// once: the sum of eight patterns, each chosen by three bits, has no closed form in arithmetic.
#include <array>
#include <cstddef>
#include <cstdint>

#include "procedural/noise/simplex_noise.h"

namespace burl {

using ByteTable = std::array<std::uint8_t, 16>;

/// Entry 1 << bit: the weight that bit 4 * half + bit of the coordinate along `axis` has in the
/// number of its pattern. From bit to bit the weights 4, 2 and 1 rotate among the coordinates.
constexpr ByteTable pattern_bits(std::size_t axis, std::size_t half) {
    ByteTable table{};
    for (std::size_t bit = 0; bit < 4; ++bit)
        table[std::size_t(1) << bit] = std::uint8_t(4u >> ((axis + 9 - (4 * half + bit)) % 3));
    return table;
}

/// The appendix's eight bit patterns as a table of 16 bytes.
constexpr ByteTable pattern_table() {
    ByteTable table{};
    for (std::size_t i = 0; i < bit_patterns.size(); ++i) table[i] = bit_patterns[i];
    return table;
}

/// The role of an axis in a gradient, by the appendix's p, q and r; `none` for a byte without an
/// axis.
enum class SimplexRole : std::uint8_t { p, q, r, none };

/// Entry (hash & 3) | byte << 2, where bytes 3, 2 and 1 of a lane are the components along x, y and
/// z: the component's SimplexRole, plus 8 where the gradient points to a corner of the cube.
constexpr ByteTable role_table() {
    ByteTable table{};
    for (std::size_t turn = 0; turn < 4; ++turn) {
        table[turn] = std::uint8_t(SimplexRole::none);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t p = turn == 1 ? 0 : turn == 2 ? 1 : 2;
            table[turn | (3 - axis) << 2] = std::uint8_t((axis + 3 - p) % 3);
        }
        for (std::size_t byte = 0; byte < 4; ++byte) table[turn | byte << 2] |= turn ? 0 : 8;
    }
    return table;
}

/// Entry role | (hash & 4), where `role` is an entry of role_table: the mask of those of the hash's
/// bits 3, 4 and 5, moved to 0, 1 and 2, that are set before the parity of all three gives the
/// sign; 128 for a component that is 0.
constexpr ByteTable sign_bits() {
    ByteTable table{};
    for (std::uint8_t i = 0; i < 16; ++i) {
        const auto role = SimplexRole(i & 3);
        const bool whole = i & 8, second = i & 4;
        const bool zero = role == SimplexRole::none ||
                          (role == SimplexRole::q && second && !whole) ||
                          (role == SimplexRole::r && !second && !whole);
        table[i] = zero ? 128 : role == SimplexRole::p ? 2 : role == SimplexRole::q ? 1 : 0;
    }
    return table;
}

/// Entry bits | (hash >> 3 & 7), where `bits` is an entry of sign_bits: the top byte of the float 2
/// or -2.
constexpr ByteTable sign_table() {
    ByteTable table{};
    for (std::uint8_t i = 0; i < 8; ++i) table[i] = (i ^ i >> 1 ^ i >> 2) & 1 ? 0xc0 : 0x40;
    return table;
}

/// The shuffle after which byte i is the former byte (i & keep) ^ flip.
constexpr ByteTable byte_order(std::size_t keep, std::size_t flip) {
    ByteTable table{};
    for (std::size_t i = 0; i < 16; ++i) table[i] = std::uint8_t((i & keep) ^ flip);
    return table;
}

/// The gradient of a hash by the tables above: the top bytes of the floats that are twice its
/// components along x, y and z, in bytes 3, 2 and 1; 0 for a component that is 0.
constexpr std::uint32_t simplex_code(std::uint32_t hash) {
    std::uint32_t code = 0;
    for (std::uint32_t byte = 1; byte < 4; ++byte) {
        const std::uint32_t role = role_table()[(hash & 3) | byte << 2];
        const std::uint32_t bits = sign_bits()[role | (hash & 4)];
        if (bits < 128) code |= std::uint32_t(sign_table()[bits | (hash >> 3 & 7)]) << 8 * byte;
    }
    return code;
}

}  // namespace burl
