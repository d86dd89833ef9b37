#pragma once
// Forward-mode differentiation: a number with its gradient with respect to the solid point (s, t,
// r). Every node of a texture graph computes with dual numbers, so that filters know the slope of
// any graph. Where a function has a kink or a jump the slope is the one to its right or 0, never
// NaN.
#include <algorithm>
#include <cmath>

#include "atlas/base/elementary.h"
#include "atlas/base/vec.h"

namespace burl {

/// A number and its gradient with respect to the solid point.
struct Dual {
    double value = 0.0;
    Vec3d slope{0.0};

    Dual() = default;
    Dual(double constant) : value(constant) {}  // implicit, for formulas
    Dual(double v, const Vec3d& s) : value(v), slope(s) {}
};

inline Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.slope + b.slope};
}
inline Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.slope - b.slope};
}
inline Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.value * b.slope + b.value * a.slope};
}

/// The dual f(x) for f(x) = `value` and f'(x) = `derivative`; a derivative that is not finite
/// counts as 0.
inline Dual chain(const Dual& x, double value, double derivative) {
    return {value, std::isfinite(derivative) ? derivative * x.slope : Vec3d(0.0)};
}

inline Dual dual_sin(const Dual& x) {
    return chain(x, sine(x.value), cosine(x.value));
}

/// |x|; the slope at 0 is that of x.
inline Dual dual_abs(const Dual& x) {
    return x.value < 0.0 ? Dual(-x.value, -x.slope) : x;
}

/// The smaller of a and b with its slope; a where they are equal.
inline Dual dual_min(const Dual& a, const Dual& b) {
    return b.value < a.value ? b : a;
}

/// The larger of a and b with its slope; a where they are equal.
inline Dual dual_max(const Dual& a, const Dual& b) {
    return a.value < b.value ? b : a;
}

/// floor(x), whose slope is 0.
inline Dual dual_floor(const Dual& x) {
    return std::floor(x.value);
}

/// x - floor(x), with the slope of x.
inline Dual dual_fract(const Dual& x) {
    return {x.value - std::floor(x.value), x.slope};
}

/// x^e for a constant e >= 0; a negative x counts as 0 unless e is whole.
inline Dual dual_power(const Dual& x, double e) {
    if (e == 0.0) return 1.0;
    if (x.value < 0.0 && e != std::floor(e)) return 0.0;
    return chain(x, power(x.value, e), e * power(x.value, e - 1.0));
}

/// The smooth step: 0 up to low, 1 from high on, 3u^2 - 2u^3 between; a step at `high` where high
/// <= low.
inline Dual dual_smoothstep(const Dual& low, const Dual& high, const Dual& x) {
    const double width = high.value - low.value;
    if (x.value >= high.value || !(width > 0.0)) return x.value >= high.value ? 1.0 : 0.0;
    if (x.value <= low.value) return 0.0;
    const double u = (x.value - low.value) / width;
    const Vec3d slope = (x.slope - low.slope - u * (high.slope - low.slope)) / width;
    return {u * u * (3.0 - 2.0 * u), 6.0 * u * (1.0 - u) * slope};
}

/// sqrt(x^2 + y^2); the slope at 0 is 0.
inline Dual dual_length(const Dual& x, const Dual& y) {
    const double length = length_of(x.value, y.value);
    if (!(length > 0.0)) return length;
    return {length, (x.value / length) * x.slope + (y.value / length) * y.slope};
}

/// The angle of (x, y) in (-pi, pi] radians. The slope is continuous across the seam, and 0 at the
/// origin.
inline Dual dual_angle(const Dual& y, const Dual& x) {
    const double length = length_of(x.value, y.value);
    if (!(length > 0.0)) return 0.0;
    return {angle_of(y.value, x.value),
            ((x.value / length) * y.slope - (y.value / length) * x.slope) / length};
}

/// (1 - w) a + w b, which is exactly a at w = 0 and b at w = 1.
inline Dual dual_lerp(const Dual& w, const Dual& a, const Dual& b) {
    return (Dual(1.0) - w) * a + w * b;
}

}  // namespace burl
