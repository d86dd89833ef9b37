// Cells and places of points given as float64 coordinates, for every instruction set. The file is
// included once per instruction set (hence the toggled guard), after hwy/foreach_target.h.
#if defined(BURL_POINT_SITES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_POINT_SITES_INL_H
#undef BURL_POINT_SITES_INL_H
#else
#define BURL_POINT_SITES_INL_H
#endif

#include "procedural/noise/lattice_site.h"
#include "procedural/numbers/fixed_point-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// Coordinates of a vector of points along an axis, in units of 2^-32 cells.
struct PointAxis {
    Bit cell, part;  ///< upper and lower 32 bits

    /// The cells after so many doublings of the coordinate, at most 31.
    HWY_ATTR HWY_INLINE Bit Cells(int doublings) const {
        const Bit carried = hn::ShiftRightSame(hn::ShiftRight<1>(part), 31 - doublings);
        return hn::Or(hn::ShiftLeftSame(cell, doublings), carried);
    }
    /// Offsets from the cells' middles after so many doublings, in [-1/2, 1/2].
    HWY_ATTR HWY_INLINE Float Places(int doublings) const {
        const Bit place = hn::ShiftLeftSame(part, doublings);
        const auto centred = hn::BitCast(Ints(), hn::Xor(place, hn::Set(Bits(), 0x80000000u)));
        return hn::Mul(hn::ConvertTo(Floats(), centred), hn::Set(Floats(), 0x1p-32f));
    }
};

/// The coordinates frequency * x of a vector of points; those of size `limit` or more, and NaN,
/// count as 0.
HWY_ATTR HWY_INLINE PointAxis SplitPoints(const double* x, double frequency, double limit) {
    const Doubles d;
    const Double half = hn::Set(d, 0.5);
    const auto fixed = [&](const double* at) HWY_ATTR {
        const Double y = hn::Mul(hn::Set(d, frequency), hn::Load(d, at));
        const Double near = hn::IfThenElseZero(hn::Lt(hn::Abs(y), hn::Set(d, limit)), y);
        // The split is taken from the middle of a cell; the half cell is added back with a carry,
        // so that place 1/2 goes into the next cell.
        return hn::Add(FixedPoint(hn::Sub(near, half)), hn::Set(Longs(), std::uint64_t(1) << 31));
    };
#if HWY_TARGET == HWY_SCALAR
    const Long low = fixed(x);
    const Halves at(low, low);
#else
    const Halves at(fixed(x), fixed(x + hn::Lanes(d)));
#endif
    return {at.upper, at.lower};
}

/// Whether any of a vector of points has a coordinate that, times `frequency`, reaches `limit`.
HWY_ATTR HWY_INLINE bool AnyBeyond(const std::array<const double*, 3>& points, std::size_t j,
                                   double frequency, double limit) {
    const Doubles d;
    const Double factor = hn::Set(d, frequency), bound = hn::Set(d, limit);
    for (const double* axis : points)
        for (std::size_t i = 0; i < hn::Lanes(Floats()); i += hn::Lanes(d))
            if (!hn::AllTrue(d, hn::Lt(hn::Abs(hn::Mul(factor, hn::Load(d, axis + j + i))), bound)))
                return true;
    return false;
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
