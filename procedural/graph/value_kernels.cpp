#include "procedural/graph/value_kernels.h"

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/graph/value_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/numbers/elementary-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

using Inputs = std::array<const double*, 4>;

HWY_ATTR HWY_INLINE Double Odd(Double x) {
    const Double half = hn::Mul(hn::Floor(x), hn::Set(Doubles(), 0.5));
    return hn::IfThenZeroElse(hn::Eq(half, hn::Floor(half)), hn::Set(Doubles(), 1.0));
}

HWY_ATTR HWY_INLINE Double Smoothstep(double low, double high, Double x) {
    const Doubles d;
    const Double one = hn::Set(d, 1.0);
    const auto above = hn::Ge(x, hn::Set(d, high));
    if (!(high > low)) return hn::IfThenElseZero(above, one);
    const Double u = hn::Div(hn::Sub(x, hn::Set(d, low)), hn::Set(d, high - low));
    const Double rest = hn::Sub(hn::Set(d, 3.0), hn::Add(u, u));
    const Double curve = hn::Mul(hn::Mul(u, u), rest);
    return hn::IfThenElse(above, one, hn::IfThenZeroElse(hn::Le(x, hn::Set(d, low)), curve));
}

HWY_ATTR HWY_INLINE Double Lerp(Double w, Double a, Double b) {
    return hn::Add(hn::Mul(hn::Sub(hn::Set(Doubles(), 1.0), w), a), hn::Mul(w, b));
}

/// Stores out[j] = function(j), whole vectors.
template <class Function>
HWY_ATTR HWY_INLINE void Fill(std::size_t count, double* out, const Function& function) {
    const Doubles d;
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) hn::Store(function(j), d, out + j);
}

HWY_ATTR void Apply(const ValueOperation& operation, const Inputs& in, std::size_t count,
                    double* out) {
    const Doubles d;
    const auto [p, q, r, s] = operation.parameters;
    // Copies, because lambdas capture no structured bindings.
    const double first = p, second = q;
    const Double vp = hn::Set(d, p), vq = hn::Set(d, q), vr = hn::Set(d, r), vs = hn::Set(d, s);
    const auto a = [&](std::size_t j) HWY_ATTR { return hn::Load(d, in[0] + j); };
    const auto b = [&](std::size_t j) HWY_ATTR { return hn::Load(d, in[1] + j); };
    const auto c = [&](std::size_t j) HWY_ATTR { return hn::Load(d, in[2] + j); };
    const auto e = [&](std::size_t j) HWY_ATTR { return hn::Load(d, in[3] + j); };
    const auto fill = [&](const auto& function) HWY_ATTR { Fill(count, out, function); };
    using J = std::size_t;
    switch (operation.op) {
        case ValueOp::constant:
            return fill([&](J) HWY_ATTR { return vp; });
        case ValueOp::affine:
            return fill([&](J j) HWY_ATTR {
                const Double xy = hn::Add(hn::Mul(vp, a(j)), hn::Mul(vq, b(j)));
                return hn::Add(hn::Add(xy, hn::Mul(vr, c(j))), vs);
            });
        case ValueOp::linear:
            return fill([&](J j) HWY_ATTR { return hn::Add(hn::Mul(vp, a(j)), vq); });
        case ValueOp::combine:
            return fill([&](J j) HWY_ATTR {
                return hn::Add(hn::Add(hn::Mul(vp, a(j)), hn::Mul(vq, b(j))), vr);
            });
        case ValueOp::add:
            return fill([&](J j) HWY_ATTR { return hn::Add(a(j), b(j)); });
        case ValueOp::multiply:
            return fill([&](J j) HWY_ATTR { return hn::Mul(a(j), b(j)); });
        case ValueOp::products:
            return fill([&](J j)
                            HWY_ATTR { return hn::Add(hn::Mul(a(j), b(j)), hn::Mul(c(j), e(j))); });
        case ValueOp::ratio:
            return fill([&](J j) HWY_ATTR {
                const Double below = b(j);
                return hn::IfThenElseZero(hn::Gt(below, hn::Zero(d)), hn::Div(a(j), below));
            });
        case ValueOp::minimum:
            return fill([&](J j) HWY_ATTR {
                const Double x = a(j), y = b(j);
                return hn::IfThenElse(hn::Lt(y, x), y, x);
            });
        case ValueOp::maximum:
            return fill([&](J j) HWY_ATTR {
                const Double x = a(j), y = b(j);
                return hn::IfThenElse(hn::Lt(x, y), y, x);
            });
        case ValueOp::absolute:
            return fill([&](J j) HWY_ATTR { return hn::Abs(a(j)); });
        case ValueOp::floor:
            return fill([&](J j) HWY_ATTR { return hn::Floor(a(j)); });
        case ValueOp::fract:
            return fill([&](J j) HWY_ATTR {
                const Double x = a(j);
                return hn::Sub(x, hn::Floor(x));
            });
        case ValueOp::odd:
            return fill([&](J j) HWY_ATTR { return Odd(a(j)); });
        case ValueOp::at_least:
            return fill([&](J j) HWY_ATTR {
                return hn::IfThenElseZero(hn::Ge(a(j), vp), hn::Set(d, 1.0));
            });
        case ValueOp::smoothstep:
            return fill([&](J j) HWY_ATTR { return Smoothstep(first, second, a(j)); });
        case ValueOp::lerp:
            return fill([&](J j) HWY_ATTR { return Lerp(a(j), b(j), c(j)); });
        case ValueOp::length:
            return fill([&](J j) HWY_ATTR {
                const Double x = a(j), y = b(j);
                return hn::Sqrt(hn::Add(hn::Mul(x, x), hn::Mul(y, y)));
            });
        case ValueOp::power:
            return fill([&](J j) HWY_ATTR { return Power(a(j), first); });
        case ValueOp::sine:
            return fill([&](J j) HWY_ATTR { return Sine(a(j)); });
        case ValueOp::angle:
            return fill([&](J j) HWY_ATTR { return Angle(a(j), b(j)); });
    }
}

/// x repeated or clamped to [0, 1]; 0 where x is not finite.
HWY_ATTR HWY_INLINE Double MapArgument(ColorPieces::Argument argument, Double x) {
    const Doubles d;
    const Double zero = hn::Zero(d), one = hn::Set(d, 1.0);
    const Double finite = hn::IfThenElseZero(hn::Eq(hn::Sub(x, x), zero), x);
    if (argument == ColorPieces::Argument::clamp) return hn::Min(hn::Max(finite, zero), one);
    const Double part = hn::Sub(finite, hn::Floor(finite));
    // Just below a whole number the fraction rounds to 1, which is the next period's 0.
    return hn::IfThenElseZero(hn::Lt(part, one), part);
}

template <std::size_t degree>
HWY_ATTR void LookUpOf(const ColorPieces& pieces, const double* x, std::size_t count,
                       const std::array<double*, 3>& out) {
    const Doubles d;
    const hn::RebindToSigned<Doubles> ints;
    constexpr std::size_t stride = 1 + 3 * (degree + 1);
    const double* table = pieces.table.data();
    const Double step = hn::Set(d, double(stride));
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        const Double t = MapArgument(pieces.argument, hn::Load(d, x + j));
        Double at = hn::Zero(d);
        for (std::size_t i = 1; i < pieces.begins.size(); ++i)
            at = hn::Add(at, hn::IfThenElseZero(hn::Ge(t, hn::Set(d, pieces.begins[i])), step));
        const auto index = hn::ConvertTo(ints, at);
        const Double u = hn::Sub(t, hn::GatherIndex(d, table, index));
        for (std::size_t c = 0; c < 3; ++c) {
            const double* first = table + 1 + c * (degree + 1);
            Double sum = hn::GatherIndex(d, first + degree, index);
            for (std::size_t k = degree; k-- > 0;)
                sum = hn::Add(hn::GatherIndex(d, first + k, index), hn::Mul(u, sum));
            hn::Store(sum, d, out[c] + j);
        }
    }
}

HWY_ATTR void LookUp(const ColorPieces& pieces, const double* x, std::size_t count,
                     const std::array<double*, 3>& out) {
    if (pieces.degree == 1)
        LookUpOf<1>(pieces, x, count, out);
    else
        LookUpOf<3>(pieces, x, count, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(Apply);
HWY_EXPORT(LookUp);

void apply(const ValueOperation& operation, const std::array<const double*, 4>& inputs,
           std::size_t count, double* out) {
    HWY_DYNAMIC_DISPATCH(Apply)(operation, inputs, count, out);
}

void look_up(const ColorPieces& pieces, const double* x, std::size_t count,
             const std::array<double*, 3>& out) {
    HWY_DYNAMIC_DISPATCH(LookUp)(pieces, x, count, out);
}

}  // namespace burl
#endif
