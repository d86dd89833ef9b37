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

/// Upper and lower halves of a vector of coordinates after doublings.
HWY_ATTR HWY_INLINE void SplitFixed(const std::uint64_t* at, int doublings, Bit& cell, Bit& part) {
    const hn::RebindToUnsigned<Doubles> d;
    const auto low = hn::ShiftLeftSame(hn::Load(d, at), doublings);
#if HWY_TARGET == HWY_SCALAR
    const std::uint64_t x = hn::GetLane(low);
    cell = hn::Set(Bits(), std::uint32_t(x >> 32));
    part = hn::Set(Bits(), std::uint32_t(x & 0xffffffffu));
#else
    const auto high = hn::ShiftLeftSame(hn::Load(d, at + hn::Lanes(d)), doublings);
    const Bits bits;
    cell = hn::ConcatOdd(bits, hn::BitCast(bits, high), hn::BitCast(bits, low));
    part = hn::ConcatEven(bits, hn::BitCast(bits, high), hn::BitCast(bits, low));
#endif
}

/// A vector of texels: cells, and places from the cells' middles.
struct StreamSite {
    Bit cell[3];
    Float place[3];

    HWY_ATTR HWY_INLINE StreamSite(const LatticeStream& stream, int doublings, std::size_t j) {
        for (int axis = 0; axis < 3; ++axis) {
            Bit part;
            SplitFixed(stream.at[axis] + j, doublings, cell[axis], part);
            const auto centred = hn::BitCast(Ints(), hn::Xor(part, hn::Set(Bits(), 0x80000000u)));
            place[axis] = hn::Mul(hn::ConvertTo(Floats(), centred), hn::Set(Floats(), 0x1p-32f));
        }
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
