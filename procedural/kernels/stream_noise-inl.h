// Lattice noise as noise.h defines it at the texels of a stream, for every instruction set: the
// common part of the direct kernel and the sharing one, in the fewest operations that keep a
// float's accuracy. The file is included once per instruction set (hence the toggled guard), after
// hwy/foreach_target.h.
#if defined(BURL_STREAM_NOISE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_STREAM_NOISE_INL_H
#undef BURL_STREAM_NOISE_INL_H
#else
#define BURL_STREAM_NOISE_INL_H
#endif

#include <type_traits>

#include "procedural/kernels/noise_corners-inl.h"
#include "procedural/kernels/stream_sites-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// Twice the place about the cell's middle, t in [-1, 1], from s = 2^32 times the place.
HWY_ATTR HWY_INLINE Float TwicePlace(Float s) {
    return hn::Mul(s, hn::Set(Floats(), 0x1p-31f));
}

/// The fade v = 2 w - 1, w being the upper corner's weight, from s as PlacesOf gives it.
HWY_ATTR HWY_INLINE Float FadeOf(LinearFade, Float s) {
    return TwicePlace(s);
}
HWY_ATTR HWY_INLINE Float FadeOf(SmoothFade, Float s) {  // t (3/2 - t^2 / 2), t = 2^-31 s
    const Floats d;
    const Float square = hn::Mul(s, s);
    return hn::Mul(s, hn::Sub(hn::Set(d, 0x3p-32f), hn::Mul(hn::Set(d, 0x1p-94f), square)));
}
HWY_ATTR HWY_INLINE Float FadeOf(QuinticFade, Float s) {  // t (15/8 - t^2 (5/4 - 3/8 t^2))
    const Floats d;
    const Float t = TwicePlace(s), square = hn::Mul(t, t);
    const Float rest = hn::Sub(hn::Set(d, 1.25f), hn::Mul(hn::Set(d, 0.375f), square));
    return hn::Mul(t, hn::Sub(hn::Set(d, 1.875f), hn::Mul(square, rest)));
}

/// Four times the interpolation of a plane's four lattice values, as coefficients of 1, v_x, v_y
/// and v_x v_y.
struct PlaneValues {
    Float one, x, y, xy;

    HWY_ATTR HWY_INLINE PlaneValues(Float one_, Float x_, Float y_, Float xy_)
        : one(one_), x(x_), y(y_), xy(xy_) {}
    /// The coefficients for the values at (0,0), (1,0), (0,1) and (1,1).
    static HWY_ATTR HWY_INLINE PlaneValues Of(Float a, Float b, Float e, Float f) {
        const Float low = hn::Add(a, b), high = hn::Add(e, f);
        const Float low_x = hn::Sub(b, a), high_x = hn::Sub(f, e);
        return {hn::Add(low, high), hn::Add(low_x, high_x), hn::Sub(high, low),
                hn::Sub(high_x, low_x)};
    }
    HWY_ATTR HWY_INLINE Float operator()(Float fx, Float fy) const {
        return hn::Add(hn::Add(one, hn::Mul(fx, x)), hn::Mul(fy, hn::Add(y, hn::Mul(fx, xy))));
    }
};

/// 2^31 times the lattice value of a hash: its upper 24 bits, without a shift.
HWY_ATTR HWY_INLINE Float ValueOf(Bit h) {
    const Bit upper = hn::And(h, hn::Set(Bits(), 0xffffff00u));
    return hn::ConvertTo(Floats(), hn::BitCast(Ints(), upper));
}

/// The hashes of a plane's four corners, mixed; h is that of the lowest corner before mixing.
struct PlaneHashes {
    Bit a, b, e, f;

    HWY_ATTR HWY_INLINE PlaneHashes(Bit a_, Bit b_, Bit e_, Bit f_) : a(a_), b(b_), e(e_), f(f_) {}
    HWY_ATTR HWY_INLINE explicit PlaneHashes(Bit h) : a(h), b(h), e(h), f(h) {
        const Bit next_x = hn::Set(Bits(), LatticeHash::prime_x);
        const Bit above = hn::Add(h, hn::Set(Bits(), LatticeHash::prime_y));
        a = Mix(h), b = Mix(hn::Add(h, next_x));
        e = Mix(above), f = Mix(hn::Add(above, next_x));
    }
};

HWY_ATTR HWY_INLINE PlaneValues ValuesOf(const PlaneHashes& h) {
    return PlaneValues::Of(ValueOf(h.a), ValueOf(h.b), ValueOf(h.e), ValueOf(h.f));
}

/// The hash one plane further along z, before mixing.
HWY_ATTR HWY_INLINE Bit NextPlane(Bit h) {
    return hn::Add(h, hn::Set(Bits(), LatticeHash::prime_z));
}

/// The places of a vector of texels on the three axes (2^32 times the offset from the cell's
/// middle), and their fades.
template <class FadeFunction>
struct StreamPlaces {
    Float s[3], fade[3];

    template <class Stream>
    HWY_ATTR HWY_INLINE StreamPlaces(const Stream& stream, std::size_t j, int doublings) {
        for (int axis = 0; axis < 3; ++axis) {
            s[axis] = PlacesOf(stream, axis, j, doublings);
            fade[axis] = FadeOf(FadeFunction(), s[axis]);
        }
    }
};

/// Value noise divided by stream_unit, from the values of the two planes of corners.
template <class FadeFunction>
HWY_ATTR HWY_INLINE Float NoiseOf(const StreamPlaces<FadeFunction>& at, const PlaneValues& low,
                                  const PlaneValues& high) {
    return TwiceLerp(at.fade[2], low(at.fade[0], at.fade[1]), high(at.fade[0], at.fade[1]));
}

/// Perlin's noise divided by stream_unit, from the hashes of the two planes of corners: slopes
/// through the corners at twice the distance.
template <class FadeFunction>
HWY_ATTR HWY_INLINE Float NoiseOf(const StreamPlaces<FadeFunction>& at, const PlaneHashes& low,
                                  const PlaneHashes& high) {
    const PerlinCorner corner;
    const Float one = hn::Set(Floats(), 1.0f);
    const Float x = TwicePlace(at.s[0]), y = TwicePlace(at.s[1]), z = TwicePlace(at.s[2]);
    const Float x0 = hn::Add(x, one), x1 = hn::Sub(x, one);
    const Float y0 = hn::Add(y, one), y1 = hn::Sub(y, one);
    const auto plane = [&](const PlaneHashes& h, Float dz) HWY_ATTR {
        const Float at_low =
            TwiceLerp(at.fade[0], corner(h.a, x0, y0, dz), corner(h.b, x1, y0, dz));
        const Float at_high =
            TwiceLerp(at.fade[0], corner(h.e, x0, y1, dz), corner(h.f, x1, y1, dz));
        return TwiceLerp(at.fade[1], at_low, at_high);
    };
    return TwiceLerp(at.fade[2], plane(low, hn::Add(z, one)), plane(high, hn::Sub(z, one)));
}

/// The two planes of corners of a vector of texels, as NoiseOf takes them.
template <class Plane>
struct Planes {
    Plane low, high;
};

/// The planes of corners from a vector's CellHash.
template <class Corner>
HWY_ATTR HWY_INLINE auto PlanesOf(Bit h) {
    const PlaneHashes low(h), high(NextPlane(h));
    if constexpr (std::is_same_v<Corner, ValueCorner>)
        return Planes<PlaneValues>{ValuesOf(low), ValuesOf(high)};
    else
        return Planes<PlaneHashes>{low, high};
}

HWY_ATTR HWY_INLINE void AddScaled(Float weight, Float term, float* sum) {
    const Floats d;
    hn::Store(hn::Add(hn::Load(d, sum), hn::Mul(weight, term)), d, sum);
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
