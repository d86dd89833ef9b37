#pragma once
// Arithmetic for functions that are written once for plain numbers and for numbers with gradients:
// a function template of type T, double or Dual, takes what it needs from here. Elementary
// functions have the same bits everywhere (atlas/base/elementary.h).
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

#include "procedural/numbers/dual.h"

namespace burl::numeric {

inline double value_of(double x) {
    return x;
}
inline double value_of(const Dual& x) {
    return x.value;
}

/// The number f(x) for f(x) = `value` and f'(x) = `derivative`.
inline double chained(double, double value, double) {
    return value;
}
inline Dual chained(const Dual& x, double value, double derivative) {
    return chain(x, value, derivative);
}

template <class T>
double floor_of(const T& x) {
    return std::floor(value_of(x));
}
template <class T>
T sine_of(const T& x) {
    return chained(x, sine(value_of(x)), cosine(value_of(x)));
}
template <class T>
T cosine_of(const T& x) {
    return chained(x, cosine(value_of(x)), -sine(value_of(x)));
}
template <class T>
T absolute(const T& x) {
    return value_of(x) < 0.0 ? T(0.0) - x : x;
}
template <class T>
T smaller(const T& a, const T& b) {
    return value_of(b) < value_of(a) ? b : a;
}
template <class T>
T larger(const T& a, const T& b) {
    return value_of(a) < value_of(b) ? b : a;
}
/// The number x, at least `low` and at most `high`; `low` where x is not a number.
template <class T>
T clamped(const T& x, double low = 0.0, double high = 1.0) {
    if (!(value_of(x) > low)) return T(low);
    return value_of(x) < high ? x : T(high);
}
/// The lowest 32 bits of a whole number; 0 where it is beyond 2^62 or not a number.
inline std::uint32_t low_word(double whole) {
    return std::abs(whole) < 0x1p62 ? std::uint32_t(std::int64_t(whole)) : 0u;
}
/// The ratio a / b, and 0 where b is 0.
template <class T>
T quotient(const T& a, const T& b) {
    const double d = value_of(b);
    if (d == 0.0) return T(0.0);
    return a * chained(b, 1.0 / d, -1.0 / (d * d));
}
/// The root of x, and 0 where x is not above 0.
template <class T>
T root(const T& x) {
    if (!(value_of(x) > 0.0)) return T(0.0);
    const double r = std::sqrt(value_of(x));
    return chained(x, r, 0.5 / r);
}
/// The number e^x.
template <class T>
T exponential(const T& x) {
    const double e = binary_power(value_of(x) * std::numbers::log2e);
    return chained(x, e, e);
}
/// The natural logarithm of x, and 0 where x is not above 0.
template <class T>
T logarithm(const T& x) {
    if (!(value_of(x) >= 0x1p-1022)) return T(0.0);
    return chained(x, binary_log(value_of(x)) * std::numbers::ln2, 1.0 / value_of(x));
}
/// The power x^e; of a negative x that with a whole e, else 0.
template <class T>
T raised(const T& x, const T& e) {
    const double b = value_of(x), n = value_of(e);
    if (n == 0.0) return T(1.0);
    if (b == 0.0) return T(0.0);
    if (b < 0.0 && n != std::floor(n)) return T(0.0);
    const double positive = power(std::abs(b), n);
    const bool negative = b < 0.0 && std::fmod(n, 2.0) != 0.0;
    const double p = negative ? -positive : positive;
    const double by_exponent = b > 0.0 ? p * binary_log(b) * std::numbers::ln2 : 0.0;
    return T(p) + (chained(x, 0.0, n * p / b) + chained(e, 0.0, by_exponent));
}
/// The angle of the point (x, y), in radians, in (-pi, pi].
template <class T>
T angle_to(const T& y, const T& x) {
    const double px = value_of(x), py = value_of(y), square = px * px + py * py;
    const double angle = angle_of(py, px);
    if (!(square > 0.0)) return T(angle);
    return T(angle) + (chained(y, 0.0, px / square) + chained(x, 0.0, -py / square));
}
template <class T>
T blended(const T& w, const T& a, const T& b) {
    return (T(1.0) - w) * a + w * b;
}
/// The curve 3 x^2 - 2 x^3 for x in [0, 1].
template <class T>
T smooth(const T& x) {
    return x * x * (T(3.0) - T(2.0) * x);
}

/// Three numbers: a point, a vector or a colour.
template <class T>
struct Triple {
    T x = T(0.0), y = T(0.0), z = T(0.0);
};

/// The numbers of a list; those beyond it count as 0.
template <class T>
struct Numbers {
    std::span<const T> all;

    T operator[](std::size_t i) const { return i < all.size() ? all[i] : T(0.0); }
    Triple<T> triple(std::size_t i) const { return {(*this)[i], (*this)[i + 1], (*this)[i + 2]}; }
};

template <class T>
Triple<T> operator+(const Triple<T>& a, const Triple<T>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Triple<T> operator-(const Triple<T>& a, const Triple<T>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Triple<T> times(const T& factor, const Triple<T>& a) {
    return {factor * a.x, factor * a.y, factor * a.z};
}
template <class T>
T dot(const Triple<T>& a, const Triple<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
T length(const Triple<T>& a) {
    return root(dot(a, a));
}
/// The vector of length 1 along a, and 0 where a is 0.
template <class T>
Triple<T> unit(const Triple<T>& a) {
    return times(quotient(T(1.0), length(a)), a);
}

template <class T>
Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The direction a refracted at a surface with the normal n, which is used as it is given; 0 where
/// all light is reflected.
template <class T>
Triple<T> refracted(const Triple<T>& a, const Triple<T>& n, const T& ior) {
    const T toward = dot(n, a), k = T(1.0) - ior * ior * (T(1.0) - toward * toward);
    if (value_of(k) < 0.0) return {};
    return times(ior, a) - times(ior * toward + root(k), n);
}
/// The triple function(a.x, b.x), function(a.y, b.y), ...
template <class T, class Function>
Triple<T> each(const Triple<T>& a, const Triple<T>& b, const Function& function) {
    return {function(a.x, b.x), function(a.y, b.y), function(a.z, b.z)};
}
template <class T>
Triple<T> blended(const T& w, const Triple<T>& a, const Triple<T>& b) {
    return each(a, b, [&](const T& x, const T& y) { return blended(w, x, y); });
}
/// The triple without its gradient.
template <class T>
Triple<double> values_of(const Triple<T>& a) {
    return {value_of(a.x), value_of(a.y), value_of(a.z)};
}
inline Triple<double> floors(const Triple<double>& a) {
    return {std::floor(a.x), std::floor(a.y), std::floor(a.z)};
}
template <class T>
Triple<T> constants(const Triple<double>& a) {
    return {T(a.x), T(a.y), T(a.z)};
}

}  // namespace burl::numeric
