#pragma once
// MaterialX's nodes of arithmetic by their definitions (its specification, "Standard Nodes", and
// its library's node graphs). Operations give 0 where they are not defined. They differ by at most
// 1e-6 from MaterialX's shaders in float32, beside values above 1 relatively, at 10,000 points; but
// those with a sine by 4e-4 and acos by 5e-5, which the shaders' renderer has no better, and dodge
// near its pole by 1e-3 (tests/peers/materialx_points.py; a table of values holds them).
#include "procedural/numbers/numeric.h"

namespace burl::materialx {

using namespace numeric;

/// The operations of numbers; those before `ifgreater` are also those of each channel of vectors.
enum class MathOp {
    add,
    subtract,
    multiply,
    divide,
    modulo,
    power,
    safepower,
    absval,
    sign,
    floor,
    ceil,
    round,
    fract,
    sin,
    cos,
    tan,
    asin,
    acos,
    atan2,
    sqrt,
    ln,
    exp,
    min,
    max,
    clamp,
    smoothstep,
    mix,
    trianglewave,
    burn,
    dodge,
    screen,
    overlay,
    difference,
    plus,
    minus,
    ifgreater,
    ifgreatereq,
    ifequal
};

inline double sign_of(double x) {
    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0;
}

/// The rest of a / b, with the sign of b.
template <class T>
T modulo(const T& a, const T& b) {
    return value_of(b) == 0.0 ? T(0.0) : a - T(floor_of(quotient(a, b))) * b;
}

template <class T>
T angle_of_side(MathOp op, const T& x) {
    if (!(std::abs(value_of(x)) <= 1.0)) return T(0.0);
    const T other = root(T(1.0) - x * x);
    return op == MathOp::asin ? angle_to(x, other) : angle_to(other, x);
}

template <class T>
T trigonometry(MathOp op, const T& a, const T& b) {
    switch (op) {
        case MathOp::sin:
            return sine_of(a);
        case MathOp::cos:
            return cosine_of(a);
        case MathOp::tan:
            return quotient(sine_of(a), cosine_of(a));
        case MathOp::atan2:
            return angle_to(a, b);
        default:
            return angle_of_side(op, a);
    }
}

template <class T>
T rounding(MathOp op, const T& a) {
    switch (op) {
        case MathOp::sign:
            return T(sign_of(value_of(a)));
        case MathOp::floor:
            return T(floor_of(a));
        case MathOp::ceil:
            return T(std::ceil(value_of(a)));
        case MathOp::round:
            return T(floor_of(a + T(0.5)));
        default:
            return a - T(floor_of(a));
    }
}

/// The smooth step from `low` to `high`; a step at `high` where these are equal or reversed.
template <class T>
T smoothstep(const T& x, const T& low, const T& high) {
    if (value_of(x) >= value_of(high)) return T(1.0);
    if (value_of(x) <= value_of(low)) return T(0.0);
    return smooth(quotient(x - low, high - low));
}

/// The distance of x from the nearest whole number.
template <class T>
T triangle_wave(const T& x) {
    const T part = absolute(x) - T(std::floor(std::abs(value_of(x))));
    return T(0.5) - absolute(part - T(0.5));
}

template <class T>
T shaped(MathOp op, const T& a, const T& b, const T& c) {
    switch (op) {
        case MathOp::min:
            return smaller(a, b);
        case MathOp::max:
            return larger(a, b);
        case MathOp::clamp:
            return smaller(larger(a, b), c);
        case MathOp::smoothstep:
            return smoothstep(a, b, c);
        case MathOp::mix:
            return blended(c, a, b);
        default:
            return triangle_wave(a);
    }
}

/// The node of compositing that lays `front` over `back` with the weight w. Burn is 0 where `front`
/// is 0, dodge where `front` is 1, whatever w.
template <class T>
T composited(MathOp op, const T& back, const T& front, const T& w) {
    const T one = T(1.0);
    switch (op) {
        case MathOp::burn:
            if (value_of(front) == 0.0) return T(0.0);
            return blended(w, back, one - quotient(one - back, front));
        case MathOp::dodge:
            if (value_of(front) == 1.0) return T(0.0);
            return blended(w, back, quotient(back, one - front));
        case MathOp::screen:
            return blended(w, back, one - (one - front) * (one - back));
        case MathOp::overlay: {
            const bool light = value_of(back) >= 0.5;
            const T both =
                light ? one - T(2.0) * (one - front) * (one - back) : T(2.0) * front * back;
            return blended(w, back, both);
        }
        case MathOp::difference:
            return blended(w, back, absolute(back - front));
        case MathOp::plus:
            return blended(w, back, back + front);
        default:
            return blended(w, back, back - front);
    }
}

/// Whether the condition holds: 1 or 0.
template <class T>
T comparison(MathOp op, const T& a, const T& b) {
    const double x = value_of(a), y = value_of(b);
    const bool holds = op == MathOp::ifgreater ? x > y : op == MathOp::ifequal ? x == y : x >= y;
    return T(holds ? 1.0 : 0.0);
}

template <class T>
T powers(MathOp op, const T& a, const T& b) {
    switch (op) {
        case MathOp::power:
            return raised(a, b);
        case MathOp::safepower:
            return T(sign_of(value_of(a))) * raised(absolute(a), b);
        case MathOp::sqrt:
            return root(a);
        case MathOp::ln:
            return logarithm(a);
        case MathOp::exp:
            return exponential(a);
        default:
            return absolute(a);
    }
}

/// MaterialX's node of that category at one channel, its inputs in their order but for `mix` and
/// the nodes of compositing: background, foreground, mix.
template <class T>
T math(MathOp op, const T& a, const T& b, const T& c) {
    if (op >= MathOp::ifgreater) return comparison(op, a, b);
    if (op >= MathOp::burn) return composited(op, a, b, c);
    if (op >= MathOp::min) return shaped(op, a, b, c);
    if (op >= MathOp::sin && op <= MathOp::atan2) return trigonometry(op, a, b);
    if (op >= MathOp::sign && op <= MathOp::fract) return rounding(op, a);
    switch (op) {
        case MathOp::add:
            return a + b;
        case MathOp::subtract:
            return a - b;
        case MathOp::multiply:
            return a * b;
        case MathOp::divide:
            return quotient(a, b);
        case MathOp::modulo:
            return modulo(a, b);
        default:
            return powers(op, a, b);
    }
}

}  // namespace burl::materialx
