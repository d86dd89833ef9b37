#pragma once
// The binary logarithm of one number, by the series that the vector and the shader versions use,
// too (elementary-inl.h, shaders/numbers/elementary.glsl): all three give the same bits, unlike the
// mathematical libraries' logarithms.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace burl {

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
    double sum = series[std::size(series) - 1];
    for (std::size_t k = std::size(series) - 1; k-- > 0;) sum = series[k] + z * sum;
    return exponent + s * 2.8853900817779268 * sum;
}

}  // namespace burl
