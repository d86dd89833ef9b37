#pragma once
// Sine, angle, binary logarithm and power of single numbers, by the range reductions and
// polynomials that the vector and the shader versions use, too (elementary-inl.h,
// shaders/numbers/elementary.glsl): all three give the same bits, which mathematical libraries do
// not.
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace burl {

/// The polynomial coefficients[0] + x (coefficients[1] + x (...)).
template <std::size_t N>
double polynomial(const double (&coefficients)[N], double x) {
    double sum = coefficients[N - 1];
    for (std::size_t k = N - 1; k-- > 0;) sum = coefficients[k] + x * sum;
    return sum;
}

/// sin(x), x in radians, to within 1e-13 + 2^-50 |x|; 0 from |x| = 2^50 on.
inline double sine(double x) {
    constexpr double series[] = {1.0,
                                 -1.0 / 6,
                                 1.0 / 120,
                                 -1.0 / 5040,
                                 1.0 / 362880,
                                 -1.0 / 39916800,
                                 1.0 / 6227020800.0,
                                 -1.0 / 1307674368000.0,
                                 1.0 / 355687428096000.0,
                                 -1.0 / 121645100408832000.0};
    // pi as a sum of three parts, of which the first two have 24 bits.
    constexpr double pi_1 = 4 * 7.85398125648498535156e-1, pi_2 = 4 * 3.77489470793079817668e-8,
                     pi_3 = 4 * 2.69515142907905952645e-15, magic = 0x1.8p52;
    const double shifted = x * 0.31830988618379067 + magic, turns = shifted - magic;
    double rest = x - turns * pi_1;
    rest = rest - turns * pi_2;
    rest = rest - turns * pi_3;
    if (!(std::abs(x) < 0x1p50)) rest = 0.0;
    const double result = rest * polynomial(series, rest * rest);
    return (std::bit_cast<std::uint64_t>(shifted) & 1) == 0 ? result : -result;
}

/// cos(x), x in radians: the sine of x + pi / 2.
inline double cosine(double x) {
    return sine(x + 1.5707963267948966);
}

/// The angle of (x, y) in (-pi, pi] radians, to within 1e-13; 0 at the origin.
inline double angle_of(double y, double x) {
    constexpr double pi = 3.141592653589793, eighth = 0.41421356237309503;  // tan(pi / 8)
    constexpr double series[] = {1.0,       -1.0 / 3, 1.0 / 5,   -1.0 / 7, 1.0 / 9,
                                 -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17};
    const double ax = std::abs(x), ay = std::abs(y);
    const bool steep = ay > ax;
    const double high = steep ? ay : ax, low = steep ? ax : ay, q = high > 0.0 ? low / high : 0.0;
    // The nearest of the angles 0, pi / 8 and pi / 4, to which the series adds the rest.
    const bool first = q > 0.19891236737965801, second = q > 0.66817863791929891;
    const double t = second ? 1.0 : first ? eighth : 0.0;
    const double near = second ? pi / 4 : first ? pi / 8 : 0.0;
    const double r = (q - t) / (1.0 + q * t);
    double angle = near + r * polynomial(series, r * r);
    if (steep) angle = pi / 2 - angle;
    if (x < 0.0) angle = pi - angle;
    return y < 0.0 ? -angle : angle;
}

/// log2(x) of a normal number x > 0, to within 1e-13 + 2^-52 |log2(x)|; 1024 or more where x is
/// infinite or NaN.
inline double binary_log(double x) {
    constexpr double series[] = {1.0,      1.0 / 3,  1.0 / 5,  1.0 / 7, 1.0 / 9,
                                 1.0 / 11, 1.0 / 13, 1.0 / 15, 1.0 / 17};
    const auto bits = std::bit_cast<std::uint64_t>(x);
    double exponent = double(bits >> 52) - 1023.0;
    double m = std::bit_cast<double>((bits & 0x000fffffffffffff) | 0x3ff0000000000000);
    if (m > 1.4142135623730951) m *= 0.5, exponent += 1.0;
    const double s = (m - 1.0) / (m + 1.0), z = s * s;
    return exponent + s * 2.8853900817779268 * polynomial(series, z);
}

/// 2^x to a relative error of 1e-13; 0 below -1022, infinite from 1023.5 on.
inline double binary_power(double x) {
    constexpr double series[] = {1.0,         1.0,          1.0 / 2,       1.0 / 6,
                                 1.0 / 24,    1.0 / 120,    1.0 / 720,     1.0 / 5040,
                                 1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800};
    if (x < -1022.0) return 0.0;
    if (!(x < 1023.5)) return std::numeric_limits<double>::infinity();
    const double whole = std::nearbyint(x);
    const double scale = std::bit_cast<double>(std::uint64_t(std::int64_t(whole) + 1023) << 52);
    return scale * polynomial(series, (x - whole) * 0.69314718055994531);
}

/// x^e to a relative error of 1e-13 (1 + |e log2(x)|): by repeated squaring where e is whole and
/// not negative; otherwise by logarithms, and 0 for x below 2^-1022.
inline double power(double x, double e) {
    if (e < 0.0 || e != std::floor(e))
        return x >= 0x1p-1022 ? binary_power(e * binary_log(x)) : 0.0;
    double result = 1.0, square = x;
    for (auto bit = std::uint64_t(e); bit > 0; bit >>= 1) {
        if (bit & 1) result = result * square;
        square = square * square;
    }
    return result;
}

/// sqrt(x^2 + y^2); the squares must not overflow.
inline double length_of(double x, double y) {
    return std::sqrt(x * x + y * y);
}

}  // namespace burl
