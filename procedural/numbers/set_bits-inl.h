// Positions of the lanes in which a vector's mask holds. The file is included once per instruction
// set (hence the toggled guard), after hwy/foreach_target.h.
#if defined(BURL_SET_BITS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_SET_BITS_INL_H
#undef BURL_SET_BITS_INL_H
#else
#define BURL_SET_BITS_INL_H
#endif

#include <algorithm>
#include <array>
#include <bit>

#include "procedural/numbers/vector_types-inl.h"

#ifndef BURL_SET_BITS_TABLE
#define BURL_SET_BITS_TABLE
namespace burl {

/// set_bits[byte]: the positions of the byte's set bits, ascending.
inline constexpr auto set_bits = [] {
    std::array<std::array<std::uint8_t, 8>, 256> table{};
    for (std::size_t byte = 0; byte < table.size(); ++byte)
        for (std::uint8_t bit = 0, i = 0; bit < 8; ++bit)
            if (byte >> bit & 1) table[byte][i++] = bit;
    return table;
}();

/// bits_up_to[byte][i]: the number of set bits among bits 0..i of the byte.
inline constexpr auto bits_up_to = [] {
    std::array<std::array<std::uint8_t, 8>, 256> table{};
    for (std::size_t byte = 0; byte < table.size(); ++byte)
        for (std::uint8_t bit = 0, count = 0; bit < 8; ++bit)
            table[byte][bit] = count = std::uint8_t(count + (byte >> bit & 1));
    return table;
}();

/// The number of the `found` ascending positions that are below `count`: the last vector of a
/// search reaches beyond it.
inline std::size_t found_below(std::size_t count, const std::uint32_t* positions,
                               std::size_t found) {
    while (found > 0 && positions[found - 1] >= count) --found;
    return found;
}

}  // namespace burl
#endif

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// numbers[k] = table[byte][k] + first for k = 0..7, or for as many as the vector has lanes.
template <class Table>
HWY_ATTR HWY_INLINE void StoreEight(const Table& table, std::uint8_t byte, std::size_t lanes,
                                    std::uint32_t first, std::uint32_t* numbers) {
    const hn::CappedTag<std::uint32_t, 8> d;
    const hn::Rebind<std::uint8_t, decltype(d)> bytes;
    for (std::size_t k = 0; k < std::min<std::size_t>(8, lanes); k += hn::Lanes(d)) {
        const auto small = hn::PromoteTo(d, hn::LoadU(bytes, &table[byte][k]));
        hn::StoreU(hn::Add(small, hn::Set(d, first)), d, numbers + k);
    }
}

/// The bits of a mask, eight lanes to a byte.
struct MaskBytes {
    std::uint8_t bytes[8] = {};

    template <class Mask>
    HWY_ATTR HWY_INLINE explicit MaskBytes(Mask mask) {
        hn::StoreMaskBits(Bits(), mask, bytes);
    }
};

/// Stores `first` + the number of every lane where the mask holds, ascending, and returns how many
/// there are. Writes up to 16 elements whatever the result. (Where no instruction does it, Highway
/// 1.0.3's Compress copies its table on every call with g++ 12.)
template <class Mask>
HWY_ATTR HWY_INLINE std::size_t SetPositions(Mask mask, std::uint32_t first,
                                             std::uint32_t* positions) {
    const Bits d;
#if HWY_TARGET <= HWY_AVX3
    HWY_ALIGN static constexpr std::uint32_t numbers[] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                          8, 9, 10, 11, 12, 13, 14, 15};
    const Bit lanes = hn::Add(hn::Load(d, numbers), hn::Set(d, first));
    hn::StoreU(hn::Compress(lanes, mask), d, positions);
    return hn::CountTrue(d, mask);
#else
    if (hn::AllFalse(d, mask)) return 0;
    const MaskBytes bits(mask);
    const std::size_t lanes = hn::Lanes(d);
    std::size_t count = 0;
    for (std::size_t lane = 0; lane < lanes; lane += 8) {
        const std::uint8_t byte = bits.bytes[lane / 8];
        StoreEight(set_bits, byte, lanes, first + std::uint32_t(lane), positions + count);
        count += std::size_t(std::popcount(byte));
    }
    return count;
#endif
}

/// counts[i] = `before` + the number of lanes 0..i in which the mask holds, for all lanes.
HWY_ATTR HWY_INLINE void CountUpTo(const MaskBytes& mask, std::uint32_t before,
                                   std::uint32_t* counts) {
    const std::size_t lanes = hn::Lanes(Bits());
    for (std::size_t lane = 0; lane < lanes; lane += 8) {
        const std::uint8_t byte = mask.bytes[lane / 8];
        StoreEight(bits_up_to, byte, lanes, before, counts + lane);
        before += std::uint32_t(std::popcount(byte));
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
