// Cells and places of points given as float64 coordinates, for every instruction set. Included once
// per instruction set (hence the toggled guard), after hwy/foreach_target.h.
#if defined(BURL_POINT_SITES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_POINT_SITES_INL_H
#undef BURL_POINT_SITES_INL_H
#else
#define BURL_POINT_SITES_INL_H
#endif

#include <bit>

#include "procedural/lattice_site.h"
#include "procedural/vector_types-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// Coordinates of a vector of points along an axis, in units of 2^-32 cells.
struct PointAxis {
    Bit cell, part;  ///< upper and lower 32 bits

    /// After doublings, at most 31.
    HWY_ATTR HWY_INLINE Bit Cells(int doublings) const {
        const Bit carried = hn::ShiftRightSame(hn::ShiftRight<1>(part), 31 - doublings);
        return hn::Or(hn::ShiftLeftSame(cell, doublings), carried);
    }
    /// From the cells' middles, in [-1/2, 1/2].
    HWY_ATTR HWY_INLINE Float Places(int doublings) const {
        const Bit place = hn::ShiftLeftSame(part, doublings);
        const auto centred = hn::BitCast(Ints(), hn::Xor(place, hn::Set(Bits(), 0x80000000u)));
        return hn::Mul(hn::ConvertTo(Floats(), centred), hn::Set(Floats(), 0x1p-32f));
    }
};

/// y, |y| < 2^51, as a fixed-point number.
HWY_ATTR HWY_INLINE hn::Vec<hn::RebindToUnsigned<Doubles>> FixedPoint(Double y) {
    const Doubles d;
    const hn::RebindToUnsigned<Doubles> bits;
    // Between 2^20 and 2^21 doubles are 2^-32 apart: a sum with this one is a fixed-point number.
    constexpr double fixed_magic = 0x1.8p20;
    constexpr auto zero = std::bit_cast<std::uint64_t>(fixed_magic);
    const Double from_middle = hn::Sub(y, hn::Set(d, 0.5));
    const Double shifted = hn::Add(from_middle, hn::Set(d, round_magic));
    const Double place = hn::Sub(from_middle, hn::Sub(shifted, hn::Set(d, round_magic)));
    const auto fixed = hn::BitCast(bits, hn::Add(place, hn::Set(d, fixed_magic)));
    // A sum: place 1/2 carries into the next cell.
    return hn::Add(hn::ShiftLeft<32>(hn::BitCast(bits, shifted)),
                   hn::Add(fixed, hn::Set(bits, (std::uint64_t(1) << 31) - zero)));
}

/// frequency * x of a vector of points; what reaches `limit` or is not a number counts as 0.
HWY_ATTR HWY_INLINE PointAxis SplitPoints(const double* x, double frequency, double limit) {
    const Doubles d;
    const auto fixed = [&](const double* at) HWY_ATTR {
        const Double y = hn::Mul(hn::Set(d, frequency), hn::Load(d, at));
        return FixedPoint(hn::IfThenElseZero(hn::Lt(hn::Abs(y), hn::Set(d, limit)), y));
    };
    const auto low = fixed(x);
#if HWY_TARGET == HWY_SCALAR
    const std::uint64_t bits = hn::GetLane(low);
    return {hn::Set(Bits(), std::uint32_t(bits >> 32)), hn::Set(Bits(), std::uint32_t(bits))};
#else
    const auto high = fixed(x + hn::Lanes(d));
    const Bit a = hn::BitCast(Bits(), low), b = hn::BitCast(Bits(), high);
    return {hn::ConcatOdd(Bits(), b, a), hn::ConcatEven(Bits(), b, a)};
#endif
}

/// Whether any of a vector of points has a coordinate that frequency takes to `limit` or further.
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
