// Coordinates in 32.32 fixed point from vectors of doubles. The file is included once per
// instruction set (hence the toggled guard), after hwy/foreach_target.h.
#if defined(BURL_FIXED_POINT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_FIXED_POINT_INL_H
#undef BURL_FIXED_POINT_INL_H
#else
#define BURL_FIXED_POINT_INL_H
#endif

#include <bit>

#include "procedural/numbers/vector_types-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

using Longs = hn::RebindToUnsigned<Doubles>;
using Long = hn::Vec<Longs>;

/// Doubles between 2^20 and 2^21 are 2^-32 apart, so the low bits of fixed_magic + y are y in units
/// of 2^-32.
constexpr double fixed_magic = 0x1.8p20;
constexpr auto fixed_zero = std::bit_cast<std::uint64_t>(fixed_magic);

/// The integer nearest to y, |y| < 2^51, and the rest of y.
struct NearestInteger {
    Long integer;  ///< the integer modulo 2^32 in the upper 32 bits; the lower 32 are 0
    /// y less the integer, in [-1/2, 1/2].
    Double rest;

    HWY_ATTR HWY_INLINE explicit NearestInteger(Double y) {
        const Double magic = hn::Set(Doubles(), round_magic), shifted = hn::Add(y, magic);
        integer = hn::ShiftLeft<32>(hn::BitCast(Longs(), shifted));
        rest = hn::Sub(y, hn::Sub(shifted, magic));
    }
};

/// y, |y| < 2^51, in units of 2^-32, modulo 2^64.
HWY_ATTR HWY_INLINE Long FixedPoint(Double y) {
    const NearestInteger nearest(y);
    const Double sum = hn::Add(nearest.rest, hn::Set(Doubles(), fixed_magic));
    return hn::Add(nearest.integer,
                   hn::Sub(hn::BitCast(Longs(), sum), hn::Set(Longs(), fixed_zero)));
}

/// The upper and lower 32 bits of 64-bit integers, as many as a vector of floats has lanes: those
/// of `low`, then those of `high` (with SCALAR only those of `low`).
struct Halves {
    Bit upper, lower;

    HWY_ATTR HWY_INLINE Halves(Long low, Long high) {
#if HWY_TARGET == HWY_SCALAR
        (void)high;
        upper = hn::Set(Bits(), std::uint32_t(hn::GetLane(low) >> 32));
        lower = hn::Set(Bits(), std::uint32_t(hn::GetLane(low) & 0xffffffffu));
#else
        const Bit a = hn::BitCast(Bits(), low), b = hn::BitCast(Bits(), high);
        upper = hn::ConcatOdd(Bits(), b, a);
        lower = hn::ConcatEven(Bits(), b, a);
#endif
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
