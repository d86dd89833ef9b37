#include "procedural/color/kernels.h"

#include <bit>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/color/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/numbers/set_bits-inl.h"
#include "procedural/numbers/vector_types-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

static_assert(sizeof(ColorCode) == 4 && sizeof(Rgb8) == 3);

/// The colour map's index of f, as map_index gives it.
HWY_ATTR HWY_INLINE Double MapIndex(Wrap wrap, Double f) {
    const Doubles d;
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0);
    // Both wraps give 0 for NaN, because comparisons with NaN are false.
    const auto part = hn::Sub(f, hn::Floor(f));
    const auto positive = hn::IfThenElseZero(hn::Gt(f, zero), f);
    return wrap == Wrap::repeat ? hn::IfThenElseZero(hn::Lt(part, one), part)
                                : hn::IfThenElse(hn::Lt(positive, one), positive, one);
}

HWY_ATTR void IndexColors(Wrap wrap, const double* f, std::size_t count, std::uint32_t entry_count,
                          std::int32_t* entries) {
    const Doubles d;
    const auto scale = hn::Set(d, double(entry_count));
    // The loop runs to the end of a vector of floats, because tables are looked up for all of it.
    const std::size_t lanes = hn::Lanes(Floats()), end = (count + lanes - 1) / lanes * lanes;
    for (std::size_t j = 0; j < end; j += hn::Lanes(d)) {
        const auto entry = hn::Mul(MapIndex(wrap, hn::LoadU(d, f + j)), scale);
        hn::StoreU(hn::DemoteTo(HalfInts(), entry), HalfInts(), entries + j);
    }
}

HWY_ATTR std::size_t LookUpCodes(const ColorCode* table, const std::int32_t* places,
                                 std::size_t count, ColorCode* codes, std::uint32_t* later) {
    const Bits d;
    const auto* words = reinterpret_cast<const std::uint32_t*>(table);
    auto* out = reinterpret_cast<std::uint32_t*>(codes);
    const auto flag = hn::Set(d, std::bit_cast<std::uint32_t>(ColorCode{{0, 0, 0}, true}));
    std::size_t found = 0;
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        const auto entry = hn::ShiftRight<place_bits>(hn::Load(Ints(), places + j));
        const auto code = hn::GatherIndex(d, words, entry);
        hn::Store(code, d, out + j);
        const auto several = hn::Eq(hn::And(code, flag), hn::Zero(d));
        found += SetPositions(several, std::uint32_t(j), later + found);
    }
    return found_below(count, later, found);
}

HWY_ATTR void PackPixels(const ColorCode* codes, std::size_t count, Rgb8* pixels) {
    std::size_t j = 0;
#if HWY_TARGET != HWY_SCALAR
    const hn::CappedTag<std::uint8_t, 16> d;
    HWY_ALIGN static constexpr std::uint8_t order[] = {0,  1,  2,  4,  5, 6, 8, 9,
                                                       10, 12, 13, 14, 0, 0, 0, 0};
    const auto colors = hn::Load(d, order);
    // Sixteen bytes at a time; the next store overwrites the last four.
    for (; j + 6 <= count; j += 4) {
        const auto four = hn::LoadU(d, reinterpret_cast<const std::uint8_t*>(codes + j));
        hn::StoreU(hn::TableLookupBytes(four, colors), d,
                   reinterpret_cast<std::uint8_t*>(pixels + j));
    }
#endif
    for (; j < count; ++j) pixels[j] = codes[j].color;
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(IndexColors);
HWY_EXPORT(LookUpCodes);
HWY_EXPORT(PackPixels);

void index_colors(Wrap wrap, const double* f, std::size_t count, std::uint32_t entry_count,
                  std::int32_t* entries) {
    HWY_DYNAMIC_DISPATCH(IndexColors)(wrap, f, count, entry_count, entries);
}

std::size_t look_up_codes(const ColorCode* table, const std::int32_t* places, std::size_t count,
                          ColorCode* codes, std::uint32_t* later) {
    return HWY_DYNAMIC_DISPATCH(LookUpCodes)(table, places, count, codes, later);
}

void pack_pixels(const ColorCode* codes, std::size_t count, Rgb8* pixels) {
    HWY_DYNAMIC_DISPATCH(PackPixels)(codes, count, pixels);
}

}  // namespace burl
#endif
