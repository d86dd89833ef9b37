// Cells and places of a stream's texels for every instruction set: what the direct kernel and the
// sharing one have in common. Included once per instruction set (hence the toggled guard), after
// hwy/foreach_target.h.
#if defined(BURL_STREAM_SITES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_STREAM_SITES_INL_H
#undef BURL_STREAM_SITES_INL_H
#else
#define BURL_STREAM_SITES_INL_H
#endif

#include "procedural/noise_corners-inl.h"
#include "procedural/stream_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// Cells of a vector of texels after doublings: the upper halves of their coordinates.
HWY_ATTR HWY_INLINE Bit CellsOf(const std::uint64_t* at, int doublings) {
    const hn::RebindToUnsigned<Doubles> d;
    const auto low = hn::ShiftLeftSame(hn::Load(d, at), doublings);
#if HWY_TARGET == HWY_SCALAR
    return hn::Set(Bits(), std::uint32_t(hn::GetLane(low) >> 32));
#else
    const auto high = hn::ShiftLeftSame(hn::Load(d, at + hn::Lanes(d)), doublings);
    return hn::ConcatOdd(Bits(), hn::BitCast(Bits(), high), hn::BitCast(Bits(), low));
#endif
}

/// Places of a vector of texels, from the cells' middles: the lower halves.
HWY_ATTR HWY_INLINE Float PlacesOf(const std::uint64_t* at, int doublings) {
    const hn::RebindToUnsigned<Doubles> d;
    const auto low = hn::ShiftLeftSame(hn::Load(d, at), doublings);
#if HWY_TARGET == HWY_SCALAR
    const Bit part = hn::Set(Bits(), std::uint32_t(hn::GetLane(low) & 0xffffffffu));
#else
    const auto high = hn::ShiftLeftSame(hn::Load(d, at + hn::Lanes(d)), doublings);
    const Bit part = hn::ConcatEven(Bits(), hn::BitCast(Bits(), high), hn::BitCast(Bits(), low));
#endif
    const auto centred = hn::BitCast(Ints(), hn::Xor(part, hn::Set(Bits(), 0x80000000u)));
    return hn::Mul(hn::ConvertTo(Floats(), centred), hn::Set(Floats(), 0x1p-32f));
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
