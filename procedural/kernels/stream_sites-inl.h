// Cells and places of a stream's texels, for every instruction set. The file is included once per
// instruction set (hence the toggled guard), after hwy/foreach_target.h.
#if defined(BURL_STREAM_SITES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_STREAM_SITES_INL_H
#undef BURL_STREAM_SITES_INL_H
#else
#define BURL_STREAM_SITES_INL_H
#endif

#include "procedural/kernels/stream_kernels.h"
#include "procedural/numbers/vector_types-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// The cells of a vector of texels from number j on, after doublings.
HWY_ATTR HWY_INLINE Bit CellsOf(const LatticeStream& stream, int axis, std::size_t j,
                                int doublings) {
    const Bit cells = hn::Load(Bits(), stream.cells[axis] + j);
    if (doublings == 0) return cells;
    const Bit places = hn::Load(Bits(), stream.places[axis] + j);
    return hn::Or(hn::ShiftLeftSame(cells, doublings), hn::ShiftRightSame(places, 32 - doublings));
}

/// The places of a vector of texels from number j on, after doublings, in units of 2^-32 cells;
/// `Stream` is any type that has places.
template <class Stream>
HWY_ATTR HWY_INLINE Bit PlaceBitsOf(const Stream& stream, int axis, std::size_t j, int doublings) {
    return hn::ShiftLeftSame(hn::Load(Bits(), stream.places[axis] + j), doublings);
}

/// 2^32 times the offset from the cell's middle, rounded to float, for texels from number j on.
template <class Stream>
HWY_ATTR HWY_INLINE Float PlacesOf(const Stream& stream, int axis, std::size_t j, int doublings) {
    const Bit places = PlaceBitsOf(stream, axis, j, doublings);
    const Bit centred = hn::Xor(places, hn::Set(Bits(), 0x80000000u));
    return hn::ConvertTo(Floats(), hn::BitCast(Ints(), centred));
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
