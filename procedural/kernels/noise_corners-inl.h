// Corners and fades of lattice noise as noise.h defines it, for the kernels of values and those of
// slopes. The file is included once per instruction set (hence the toggled guard), after
// hwy/foreach_target.h.
#if defined(BURL_NOISE_CORNERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_NOISE_CORNERS_INL_H
#undef BURL_NOISE_CORNERS_INL_H
#else
#define BURL_NOISE_CORNERS_INL_H
#endif

#include "procedural/batch/texel_batch.h"
#include "procedural/noise/perlin_noise.h"
#include "procedural/numbers/lattice_hash.h"
#include "procedural/numbers/vector_types-inl.h"

#ifndef BURL_PERLIN_GRADIENTS
#define BURL_PERLIN_GRADIENTS
namespace burl {

/// The 16 gradients of Perlin's noise as one array per axis.
struct PerlinGradients {
    alignas(64) float components[3][16] = {};
    constexpr PerlinGradients() {
        for (std::uint32_t number = 0; number < 16; ++number)
            for (std::size_t axis = 0; axis < 3; ++axis)
                components[axis][number] = perlin_gradient<float, 3>(number)[axis];
    }
};
inline constexpr PerlinGradients perlin_gradients;

}  // namespace burl
#endif

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

// Fades v = 2 w - 1 in [-1, 1] as functions of t = 2 u in [-1, 1], where w is the upper corner's
// weight and u the place, and their slopes dv/dt. Written as t plus a correction that vanishes
// towards the ends they lose less than x^2 (3 - 2x) and x^3 (10 + x (6x - 15)) do.
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

/// Twice the interpolation between a and b at v in [-1, 1]: (a + b) + v (b - a). The sum and the
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

/// The hash of the cells' lowest corners before mixing. The other corners' hashes are prime_x,
/// prime_y and prime_z higher.
HWY_ATTR HWY_INLINE Bit CellHash(Bit seed, Bit x, Bit y, Bit z) {
    const Bits d;
    const Bit hx = hn::Add(hn::Mul(x, hn::Set(d, LatticeHash::prime_x)), seed);
    const Bit hz = hn::Mul(z, hn::Set(d, LatticeHash::prime_z));
    return hn::Add(hn::Add(hx, hn::Mul(y, hn::Set(d, LatticeHash::prime_y))), hz);
}

/// A corner of value noise: 2^23 times the lattice value.
struct ValueCorner {
    HWY_ATTR HWY_INLINE Float operator()(Bit h, Float, Float, Float) const {
        return hn::ConvertTo(Floats(), hn::ShiftRight<8>(hn::BitCast(Ints(), h)));
    }
};

#if HWY_TARGET <= HWY_AVX3  // sixteen lanes: the gradients' components fit a vector
/// The gradient whose number is in the upper four bits of h.
struct PerlinGradient {
    Float along[3];

    HWY_ATTR HWY_INLINE explicit PerlinGradient(Bit h)
        : along{Component(h, 0), Component(h, 1), Component(h, 2)} {}

  private:
    static HWY_ATTR HWY_INLINE Float Component(Bit h, int axis) {
        const Floats d;
        return hn::TableLookupLanes(hn::Load(d, perlin_gradients.components[axis]),
                                    hn::IndicesFromVec(d, hn::ShiftRight<28>(h)));
    }
};
#endif

/// A corner of Perlin's noise: g . (x, y, z) for the gradient g whose number is in the upper four
/// bits of h.
struct PerlinCorner {
#if HWY_TARGET <= HWY_AVX3
    HWY_ATTR HWY_INLINE Float operator()(Bit h, Float x, Float y, Float z) const {
        // A component that is 0 adds a zero, which changes no bit but the sign of a zero.
        const PerlinGradient g(h);
        return hn::Add(hn::Add(hn::Mul(g.along[0], x), hn::Mul(g.along[1], y)),
                       hn::Mul(g.along[2], z));
    }
#else
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
#endif
};

/// Eight times the interpolation of the corners, for a vector of texels.
template <class Corner, class FadeFunction>
HWY_ATTR HWY_INLINE Float EightfoldNoise(Bit h00, Float x, Float y, Float z) {
    const Floats d;
    const Bits bits;
    const Corner corner;
    const FadeFunction fade;
    const Float half = hn::Set(d, 0.5f);
    const Float x0 = hn::Add(x, half), y0 = hn::Add(y, half), z0 = hn::Add(z, half);
    const Float x1 = hn::Sub(x, half), y1 = hn::Sub(y, half), z1 = hn::Sub(z, half);
    const Float fx = fade(hn::Add(x, x)), fy = fade(hn::Add(y, y)), fz = fade(hn::Add(z, z));

    const Bit next_x = hn::Set(bits, LatticeHash::prime_x);
    const Bit h10 = hn::Add(h00, next_x);
    const Bit h01 = hn::Add(h00, hn::Set(bits, LatticeHash::prime_y));
    const Bit h11 = hn::Add(h01, next_x);
    const auto plane = [&](Bit hz, Float dz) HWY_ATTR {
        const Float a = corner(Mix(hn::Add(h00, hz)), x0, y0, dz);
        const Float b = corner(Mix(hn::Add(h10, hz)), x1, y0, dz);
        const Float low = TwiceLerp(fx, a, b);
        const Float e = corner(Mix(hn::Add(h01, hz)), x0, y1, dz);
        const Float f = corner(Mix(hn::Add(h11, hz)), x1, y1, dz);
        return TwiceLerp(fy, low, TwiceLerp(fx, e, f));
    };
    const Float low = plane(hn::Zero(bits), z0);
    return TwiceLerp(fz, low, plane(hn::Set(bits, LatticeHash::prime_z), z1));
}

/// Returns visit<Corner, FadeFunction>() for the corner and fade of the noise.
template <class Visit>
HWY_ATTR auto with_noise(NoiseKind kind, Fade fade, const Visit& visit) {
    if (kind == NoiseKind::perlin) return visit.template operator()<PerlinCorner, QuinticFade>();
    if (fade == Fade::linear) return visit.template operator()<ValueCorner, LinearFade>();
    if (fade == Fade::smooth) return visit.template operator()<ValueCorner, SmoothFade>();
    return visit.template operator()<ValueCorner, QuinticFade>();
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
