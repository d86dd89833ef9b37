// Sine, angle, logarithm and powers of vectors of doubles as range reductions and polynomials in
// additions, multiplications, one division or square root, all of which IEEE 754 rounds: the same
// bits on every instruction set, which mathematical libraries do not give. Coefficients are
// Taylor's, so any second implementation can write them down (docs/reference/numerics.md). The file
// is included once per instruction set (hence the toggled guard), after hwy/foreach_target.h.
#if defined(BURL_ELEMENTARY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_ELEMENTARY_INL_H
#undef BURL_ELEMENTARY_INL_H
#else
#define BURL_ELEMENTARY_INL_H
#endif

#include <cstddef>

#include "procedural/numbers/vector_types-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// The polynomial coefficients[0] + x (coefficients[1] + x (...)).
template <std::size_t N>
HWY_ATTR HWY_INLINE Double Polynomial(const double (&coefficients)[N], Double x) {
    const Doubles d;
    Double sum = hn::Set(d, coefficients[N - 1]);
    for (std::size_t k = N - 1; k-- > 0;)
        sum = hn::Add(hn::Set(d, coefficients[k]), hn::Mul(x, sum));
    return sum;
}

/// sin(x), x in radians, to within 1e-13 + 2^-50 |x|; 0 from |x| = 2^50 on.
HWY_ATTR HWY_INLINE Double Sine(Double x) {
    const Doubles d;
    // pi as a sum of three parts. The first two have 24 bits, so that multiples of them up to 2^29
    // are exact.
    constexpr double pi_1 = 4 * 7.85398125648498535156e-1, pi_2 = 4 * 3.77489470793079817668e-8,
                     pi_3 = 4 * 2.69515142907905952645e-15;
    static constexpr double series[] = {1.0,
                                        -1.0 / 6,
                                        1.0 / 120,
                                        -1.0 / 5040,
                                        1.0 / 362880,
                                        -1.0 / 39916800,
                                        1.0 / 6227020800.0,
                                        -1.0 / 1307674368000.0,
                                        1.0 / 355687428096000.0,
                                        -1.0 / 121645100408832000.0};
    const auto magic = hn::Set(d, round_magic);
    const Double shifted = hn::Add(hn::Mul(x, hn::Set(d, 0.31830988618379067)), magic);
    const Double turns = hn::Sub(shifted, magic);
    Double rest = hn::Sub(x, hn::Mul(turns, hn::Set(d, pi_1)));
    rest = hn::Sub(rest, hn::Mul(turns, hn::Set(d, pi_2)));
    rest = hn::Sub(rest, hn::Mul(turns, hn::Set(d, pi_3)));
    rest = hn::IfThenElseZero(hn::Lt(hn::Abs(x), hn::Set(d, 0x1p50)), rest);
    const hn::RebindToUnsigned<Doubles> bits;
    const auto odd = hn::BitCast(d, hn::ShiftLeft<63>(hn::BitCast(bits, shifted)));
    return hn::Xor(hn::Mul(rest, Polynomial(series, hn::Mul(rest, rest))), odd);
}

/// The angle of (x, y) in [-pi, pi] radians, to within 1e-13; 0 at the origin.
HWY_ATTR HWY_INLINE Double Angle(Double y, Double x) {
    const Doubles d;
    constexpr double pi = 3.141592653589793, eighth = 0.41421356237309503;  // tan(pi / 8)
    static constexpr double series[] = {1.0,       -1.0 / 3, 1.0 / 5,   -1.0 / 7, 1.0 / 9,
                                        -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17};
    const Double ax = hn::Abs(x), ay = hn::Abs(y), zero = hn::Zero(d);
    const auto steep = hn::Gt(ay, ax);
    const Double high = hn::IfThenElse(steep, ay, ax), low = hn::IfThenElse(steep, ax, ay);
    const Double q = hn::IfThenElseZero(hn::Gt(high, zero), hn::Div(low, high));
    // The nearest of the angles 0, pi / 8 and pi / 4, to which the series adds the rest.
    const auto first = hn::Gt(q, hn::Set(d, 0.19891236737965801)),
               second = hn::Gt(q, hn::Set(d, 0.66817863791929891));
    const Double t =
        hn::IfThenElse(second, hn::Set(d, 1.0), hn::IfThenElseZero(first, hn::Set(d, eighth)));
    const Double near =
        hn::IfThenElse(second, hn::Set(d, pi / 4), hn::IfThenElseZero(first, hn::Set(d, pi / 8)));
    const Double r = hn::Div(hn::Sub(q, t), hn::Add(hn::Set(d, 1.0), hn::Mul(q, t)));
    Double angle = hn::Add(near, hn::Mul(r, Polynomial(series, hn::Mul(r, r))));
    angle = hn::IfThenElse(steep, hn::Sub(hn::Set(d, pi / 2), angle), angle);
    angle = hn::IfThenElse(hn::Lt(x, zero), hn::Sub(hn::Set(d, pi), angle), angle);
    return hn::CopySign(angle, y);
}

/// log2(x) of a normal number x > 0, to within 1e-13 + 2^-52 |log2(x)|.
HWY_ATTR HWY_INLINE Double Log2(Double x) {
    const Doubles d;
    const hn::RebindToUnsigned<Doubles> bits;
    constexpr double two_over_ln2 = 2.8853900817779268;
    static constexpr double series[] = {1.0,      1.0 / 3,  1.0 / 5,  1.0 / 7, 1.0 / 9,
                                        1.0 / 11, 1.0 / 13, 1.0 / 15, 1.0 / 17};
    const auto all = hn::BitCast(bits, x);
    // An integer below 2^52, written into the low bits of the double 2^52, makes 2^52 plus it.
    const auto exponent_bits =
        hn::Or(hn::ShiftRight<52>(all), hn::BitCast(bits, hn::Set(d, 0x1p52)));
    Double exponent = hn::Sub(hn::BitCast(d, exponent_bits), hn::Set(d, 0x1p52 + 1023.0));
    const auto fraction = hn::And(all, hn::Set(bits, 0x000fffffffffffffull));
    Double m = hn::BitCast(d, hn::Or(fraction, hn::BitCast(bits, hn::Set(d, 1.0))));
    const auto upper = hn::Gt(m, hn::Set(d, 1.4142135623730951));
    m = hn::IfThenElse(upper, hn::Mul(m, hn::Set(d, 0.5)), m);
    exponent = hn::Add(exponent, hn::IfThenElseZero(upper, hn::Set(d, 1.0)));
    const Double one = hn::Set(d, 1.0), s = hn::Div(hn::Sub(m, one), hn::Add(m, one));
    const Double log =
        hn::Mul(hn::Mul(s, hn::Set(d, two_over_ln2)), Polynomial(series, hn::Mul(s, s)));
    return hn::Add(exponent, log);
}

/// 2^x to a relative error of 1e-13; 0 below -1022, infinite from 1023.5 on.
HWY_ATTR HWY_INLINE Double Exp2(Double x) {
    const Doubles d;
    const hn::RebindToUnsigned<Doubles> bits;
    static constexpr double series[] = {1.0,         1.0,          1.0 / 2,       1.0 / 6,
                                        1.0 / 24,    1.0 / 120,    1.0 / 720,     1.0 / 5040,
                                        1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800};
    const auto low = hn::Lt(x, hn::Set(d, -1022.0)), high = hn::Ge(x, hn::Set(d, 1023.5));
    const Double y = hn::IfThenZeroElse(high, hn::IfThenZeroElse(low, x));
    const auto magic = hn::Set(d, round_magic);
    const Double shifted = hn::Add(y, magic), whole = hn::Sub(shifted, magic);
    const Double rest = hn::Mul(hn::Sub(y, whole), hn::Set(d, 0.69314718055994531));
    const auto exponent = hn::Add(hn::BitCast(bits, shifted), hn::Set(bits, 1023));
    const Double scale = hn::BitCast(d, hn::ShiftLeft<52>(exponent));
    const Double power = hn::Mul(scale, Polynomial(series, rest));
    return hn::IfThenElse(high, hn::Inf(d), hn::IfThenZeroElse(low, power));
}

/// x^e for e >= 0, to a relative error of 1e-13 (1 + |e log2(x)|). Where e is not whole, the result
/// is 0 for x below 2^-1022, negative x included.
HWY_ATTR HWY_INLINE Double Power(Double x, double e) {
    const Doubles d;
    const auto whole = std::size_t(e);
    if (double(whole) != e) {
        const auto normal = hn::Ge(x, hn::Set(d, 0x1p-1022));
        const Double safe = hn::IfThenElse(normal, x, hn::Set(d, 1.0));
        return hn::IfThenElseZero(normal, Exp2(hn::Mul(hn::Set(d, e), Log2(safe))));
    }
    Double result = hn::Set(d, 1.0), square = x;
    for (std::size_t bit = whole; bit > 0; bit >>= 1) {
        if (bit & 1) result = hn::Mul(result, square);
        square = hn::Mul(square, square);
    }
    return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
