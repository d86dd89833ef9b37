// Lattice noise with its gradient for every instruction set, for the kernels `direct` and `share`.
// The derivatives follow DNoise (Perlin 1985). The file is included once per instruction set (hence
// the toggled guard), after hwy/foreach_target.h.
#if defined(BURL_NOISE_GRADIENT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_NOISE_GRADIENT_INL_H
#undef BURL_NOISE_GRADIENT_INL_H
#else
#define BURL_NOISE_GRADIENT_INL_H
#endif

#include "procedural/kernels/slope_kernels.h"
#include "procedural/kernels/stream_noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// Adds `weight` times the gradient whose number is in the upper four bits of h to sum[0..3); its
/// components are 1, -1 or 0, on the axes from which PerlinCorner takes its terms.
#if HWY_TARGET <= HWY_AVX3
HWY_ATTR HWY_INLINE void AddCornerGradient(Bit h, Float weight, Float* sum) {
    const PerlinGradient gradient(h);
    for (int axis = 0; axis < 3; ++axis)
        sum[axis] = hn::Add(sum[axis], hn::Mul(gradient.along[axis], weight));
}
#else
HWY_ATTR HWY_INLINE void AddCornerGradient(Bit h, Float weight, Float* sum) {
    const Floats d;
    const auto as_float = [d](Bit bits) HWY_ATTR { return hn::BitCast(d, bits); };
    const auto bit31_set = [d](Bit bits) HWY_ATTR {
        return hn::RebindMask(d, hn::Lt(hn::BitCast(Ints(), bits), hn::Zero(Ints())));
    };
    const Bit bit30 = hn::ShiftLeft<1>(h), bit29 = hn::ShiftLeft<2>(h), bit28 = hn::ShiftLeft<3>(h);
    const auto not_below_8 = bit31_set(h), not_below_4 = bit31_set(hn::Or(h, bit30));
    const auto is_12_or_14 = bit31_set(hn::AndNot(bit28, hn::And(h, bit30)));
    const Float sign = hn::SignBit(d);
    const Float a = hn::Xor(weight, hn::And(as_float(bit28), sign));
    const Float b = hn::Xor(weight, hn::And(as_float(bit29), sign));
    const Float b_on_x = hn::IfThenElseZero(is_12_or_14, b);
    const Float b_on_y = hn::IfThenZeroElse(not_below_4, b);
    const Float b_on_z = hn::Sub(hn::IfThenElseZero(not_below_4, b), b_on_x);
    sum[0] = hn::Add(sum[0], hn::IfThenElse(not_below_8, b_on_x, a));
    sum[1] = hn::Add(sum[1], hn::IfThenElse(not_below_8, a, b_on_y));
    sum[2] = hn::Add(sum[2], b_on_z);
}
#endif

/// The noise of a vector of texels divided by stream_unit, with the bits of NoiseOf, and its
/// derivatives along the axes of the octave's lattice.
struct NoiseGradient {
    Float noise, along[3];
};

/// The slope of the fade v per cell at 2^-32 s from the cell's middle.
template <class FadeFunction>
HWY_ATTR HWY_INLINE Float FadeSlope(Float s) {
    const Float slope = FadeFunction().Slope(TwicePlace(s));
    return hn::Add(slope, slope);
}

template <class FadeFunction>
HWY_ATTR HWY_INLINE NoiseGradient GradientOf(const StreamPlaces<FadeFunction>& at,
                                             const PlaneValues& low, const PlaneValues& high) {
    const Float fx = at.fade[0], fy = at.fade[1], fz = at.fade[2];
    const auto along_x = [&](const PlaneValues& plane)
                             HWY_ATTR { return hn::Add(plane.x, hn::Mul(fy, plane.xy)); };
    const auto along_y = [&](const PlaneValues& plane)
                             HWY_ATTR { return hn::Add(plane.y, hn::Mul(fx, plane.xy)); };
    const Float below = low(fx, fy), above = high(fx, fy);
    return {TwiceLerp(fz, below, above),
            {hn::Mul(FadeSlope<FadeFunction>(at.s[0]), TwiceLerp(fz, along_x(low), along_x(high))),
             hn::Mul(FadeSlope<FadeFunction>(at.s[1]), TwiceLerp(fz, along_y(low), along_y(high))),
             hn::Mul(FadeSlope<FadeFunction>(at.s[2]), hn::Sub(above, below))}};
}

/// The share of one plane of Perlin's corners: four times its interpolation, and the derivatives of
/// that by the fades along x and y.
struct PerlinPlane {
    Float value, along_x, along_y;
};

/// The share of the plane at distance `dz`; adds the corners' gradients, weighted by the fades and
/// by `weight`, the plane's, to own[0..3).
template <class FadeFunction>
HWY_ATTR HWY_INLINE PerlinPlane PlaneOf(const StreamPlaces<FadeFunction>& at, const PlaneHashes& h,
                                        Float dz, Float weight, Float* own) {
    const PerlinCorner corner;
    const Float one = hn::Set(Floats(), 1.0f), fx = at.fade[0], fy = at.fade[1];
    const Float x = TwicePlace(at.s[0]), y = TwicePlace(at.s[1]);
    const Float x0 = hn::Add(x, one), x1 = hn::Sub(x, one);
    const Float y0 = hn::Add(y, one), y1 = hn::Sub(y, one);
    const Float a = corner(h.a, x0, y0, dz), b = corner(h.b, x1, y0, dz);
    const Float e = corner(h.e, x0, y1, dz), f = corner(h.f, x1, y1, dz);
    const Float low = hn::Mul(weight, hn::Sub(one, fy)), high = hn::Mul(weight, hn::Add(one, fy));
    const Float left = hn::Sub(one, fx), right = hn::Add(one, fx);
    AddCornerGradient(h.a, hn::Mul(low, left), own);
    AddCornerGradient(h.b, hn::Mul(low, right), own);
    AddCornerGradient(h.e, hn::Mul(high, left), own);
    AddCornerGradient(h.f, hn::Mul(high, right), own);
    const Float at_low = TwiceLerp(fx, a, b), at_high = TwiceLerp(fx, e, f);
    return {TwiceLerp(fy, at_low, at_high), TwiceLerp(fy, hn::Sub(b, a), hn::Sub(f, e)),
            hn::Sub(at_high, at_low)};
}

template <class FadeFunction>
HWY_ATTR HWY_INLINE NoiseGradient GradientOf(const StreamPlaces<FadeFunction>& at,
                                             const PlaneHashes& low, const PlaneHashes& high) {
    const Floats d;
    const Float one = hn::Set(d, 1.0f), fz = at.fade[2], z = TwicePlace(at.s[2]);
    Float own[3] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    const PerlinPlane below = PlaneOf(at, low, hn::Add(z, one), hn::Sub(one, fz), own);
    const PerlinPlane above = PlaneOf(at, high, hn::Sub(z, one), hn::Add(one, fz), own);
    // Twice the corners' gradients, because the slopes are taken at twice the distance.
    const auto along = [&](int axis, Float change) HWY_ATTR {
        return hn::Add(hn::Mul(FadeSlope<FadeFunction>(at.s[axis]), change),
                       hn::Add(own[axis], own[axis]));
    };
    return {TwiceLerp(fz, below.value, above.value),
            {along(0, TwiceLerp(fz, below.along_x, above.along_x)),
             along(1, TwiceLerp(fz, below.along_y, above.along_y)),
             along(2, hn::Sub(above.value, below.value))}};
}

/// Adds the weighted noise and gradient of a vector of texels from number j on, the gradient in the
/// stream's coordinates.
HWY_ATTR HWY_INLINE void AddGradient(const StreamOctave& octave, const NoiseGradient& n,
                                     std::size_t j, float* sums, GradientSums& gradients) {
    const Floats d;
    AddScaled(hn::Set(d, octave.weight), n.noise, sums + j);
    const Float steepness = hn::Set(d, octave.weight * float(1u << octave.doublings));
    for (int axis = 0; axis < 3; ++axis)
        AddScaled(steepness, n.along[axis], gradients.along[axis] + j);
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
