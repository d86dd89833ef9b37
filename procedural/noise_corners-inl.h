// Corners and fades of lattice noise for every instruction set: what the kernels of values and
// those of slopes share. Included once per instruction set (hence the toggled guard), after
// hwy/foreach_target.h; the noises are those of noise.h.
#if defined(BURL_NOISE_CORNERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_NOISE_CORNERS_INL_H
#undef BURL_NOISE_CORNERS_INL_H
#else
#define BURL_NOISE_CORNERS_INL_H
#endif

#include <hwy/highway.h>

#include "procedural/lattice_hash.h"
#include "procedural/noise_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Doubles = hn::ScalableTag<double>;
using Ints = hn::RebindToSigned<Floats>;
using Bits = hn::RebindToUnsigned<Floats>;
using HalfFloats = hn::Rebind<float, Doubles>;  // as many floats as there are doubles in a vector
using HalfInts = hn::Rebind<std::int32_t, Doubles>;
using HalfBits = hn::Rebind<std::uint32_t, Doubles>;
using Float = hn::Vec<Floats>;
using Bit = hn::Vec<Bits>;

// Fades as v = 2 w - 1 in [-1,1] of t = 2 u in [-1,1], u the place, and dv/dt. Written as t plus a
// correction that vanishes towards the ends they lose less than x^2 (3 - 2x) and x^3 (10 + x (6x -
// 15)) do.
struct LinearFade {
    HWY_ATTR Float operator()(Float t) const { return t; }
    HWY_ATTR Float Slope(Float) const { return hn::Set(Floats(), 1.0f); }
};
struct SmoothFade {  // t (3 - t^2) / 2
    HWY_ATTR Float operator()(Float t) const {
        const Float half = hn::Set(Floats(), 0.5f);
        const Float correction = hn::Sub(half, hn::Mul(half, hn::Mul(t, t)));
        return hn::Add(t, hn::Mul(t, correction));
    }
    HWY_ATTR Float Slope(Float t) const {
        const Float whole = hn::Set(Floats(), 1.5f);
        return hn::Sub(whole, hn::Mul(whole, hn::Mul(t, t)));
    }
};
struct QuinticFade {  // t (15 - 10 t^2 + 3 t^4) / 8
    HWY_ATTR Float operator()(Float t) const {
        const Floats d;
        const Float square = hn::Mul(t, t);
        const Float factor = hn::Sub(hn::Set(d, 0.875f), hn::Mul(hn::Set(d, 0.375f), square));
        const Float correction = hn::Mul(hn::Sub(hn::Set(d, 1.0f), square), factor);
        return hn::Add(t, hn::Mul(t, correction));
    }
    HWY_ATTR Float Slope(Float t) const {
        const Float rest = hn::Sub(hn::Set(Floats(), 1.0f), hn::Mul(t, t));
        return hn::Mul(hn::Set(Floats(), 1.875f), hn::Mul(rest, rest));
    }
};

/// Twice the interpolation between a and b at v in [-1,1]: (a + b) + v (b - a). The sum and the
/// difference of two 24-bit lattice values are exact.
HWY_ATTR HWY_INLINE Float TwiceLerp(Float v, Float a, Float b) {
    return hn::Add(hn::Add(a, b), hn::Mul(v, hn::Sub(b, a)));
}

HWY_ATTR HWY_INLINE Bit Mix(Bit h) {
    const Bits d;
    h = hn::Xor(h, hn::ShiftRight<16>(h));
    h = hn::Mul(h, hn::Set(d, LatticeHash::multiplier_1));
    h = hn::Xor(h, hn::ShiftRight<15>(h));
    return hn::Mul(h, hn::Set(d, LatticeHash::multiplier_2));
}

/// Hashes of the cells' lower four corners in z, not mixed yet; the upper four's are prime_z
/// higher.
HWY_ATTR HWY_INLINE void CornerHashes(Bit seed, const LatticeBatch& batch, std::size_t j, Bit& h00,
                                      Bit& h10, Bit& h01, Bit& h11) {
    const Bits bits;
    const Bit next_x = hn::Set(bits, LatticeHash::prime_x);
    const Bit next_y = hn::Set(bits, LatticeHash::prime_y);
    const auto cell = [&](int axis) HWY_ATTR {
        return hn::BitCast(bits, hn::Load(Ints(), batch.cells[axis] + j));
    };
    const Bit hx = hn::Add(hn::Mul(cell(0), next_x), seed);
    const Bit hz = hn::Mul(cell(2), hn::Set(bits, LatticeHash::prime_z));
    h00 = hn::Add(hn::Add(hx, hn::Mul(cell(1), next_y)), hz);
    h10 = hn::Add(h00, next_x);
    h01 = hn::Add(h00, next_y);
    h11 = hn::Add(h10, next_y);
}

/// 2^23 times the lattice value.
struct ValueCorner {
    HWY_ATTR HWY_INLINE Float operator()(Bit h, Float, Float, Float) const {
        return hn::ConvertTo(Floats(), hn::ShiftRight<8>(hn::BitCast(Ints(), h)));
    }
};

/// gradient_dot with the gradient's number in the upper four bits of h.
struct PerlinCorner {
    HWY_ATTR HWY_INLINE Float operator()(Bit h, Float x, Float y, Float z) const {
        const Floats d;
        const auto as_float = [d](Bit bits) HWY_ATTR { return hn::BitCast(d, bits); };
        // (Highway 1.0.3's IfNegativeThenElse is wrong for floats on SSSE3 and SCALAR.)
        const auto bit31_set = [d](Bit bits) HWY_ATTR {
            return hn::RebindMask(d, hn::Lt(hn::BitCast(Ints(), bits), hn::Zero(Ints())));
        };
        const Bit bit30 = hn::ShiftLeft<1>(h), bit29 = hn::ShiftLeft<2>(h),
                  bit28 = hn::ShiftLeft<3>(h);
        const auto not_below_4 = bit31_set(hn::Or(h, bit30));
        const auto is_12_or_14 = bit31_set(hn::AndNot(bit28, hn::And(h, bit30)));
        const Float a = hn::IfThenElse(bit31_set(h), y, x);
        const Float b = hn::IfThenElse(not_below_4, hn::IfThenElse(is_12_or_14, x, z), y);
        const Float sign = hn::SignBit(d);
        return hn::Add(hn::Xor(a, hn::And(as_float(bit28), sign)),
                       hn::Xor(b, hn::And(as_float(bit29), sign)));
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
