#pragma once
// The operations of Blender's nodes Math, Vector Math and Map Range, as its manual describes them.
// Operations give 0 where they are not defined.
#include "procedural/numbers/numeric.h"

namespace burl::blender {

using namespace numeric;

enum class MathOp {
    add,
    subtract,
    multiply,
    divide,
    multiply_add,
    power,
    logarithm,
    sqrt,
    inverse_sqrt,
    absolute,
    exponent,
    minimum,
    maximum,
    less_than,
    greater_than,
    sign,
    compare,
    smooth_min,
    smooth_max,
    round,
    floor,
    ceil,
    trunc,
    fract,
    modulo,
    wrap,
    snap,
    pingpong,
    sine,
    cosine,
    tangent,
    arcsine,
    arccosine,
    arctangent,
    arctan2,
    sinh,
    cosh,
    tanh,
    radians,
    degrees
};

template <class T>
T flag(bool set) {
    return T(set ? 1.0 : 0.0);
}

/// The smaller of a and b, rounded off by a cubic where they differ by less than c (Quilez).
template <class T>
T smooth_smaller(const T& a, const T& b, const T& c) {
    if (value_of(c) == 0.0) return smaller(a, b);
    const T h = quotient(larger(c - absolute(a - b), T(0.0)), c);
    return smaller(a, b) - T(1.0 / 6.0) * h * h * h * c;
}

template <class T>
T wrapped(const T& x, const T& high, const T& low) {
    const T range = high - low;
    if (value_of(range) == 0.0) return low;
    return x - T(floor_of(quotient(x - low, range))) * range;
}

/// The rest of a / b, with the sign of a.
template <class T>
T modulo(const T& a, const T& b) {
    if (value_of(b) == 0.0) return T(0.0);
    return a - T(std::trunc(value_of(a) / value_of(b))) * b;
}

template <class T>
T pingpong(const T& a, const T& b) {
    if (value_of(b) == 0.0) return T(0.0);
    const T turns = quotient(a - b, T(2.0) * b);
    return absolute((turns - T(floor_of(turns))) * T(2.0) * b - b);
}

/// The side of a right triangle of longest side 1 beside x.
template <class T>
T other_side(const T& x) {
    return root(T(1.0) - x * x);
}

template <class T>
T trigonometry(MathOp op, const T& a, const T& b) {
    const T side = clamped(a, -1.0, 1.0);
    switch (op) {
        case MathOp::sine:
            return sine_of(a);
        case MathOp::cosine:
            return cosine_of(a);
        case MathOp::tangent:
            return quotient(sine_of(a), cosine_of(a));
        case MathOp::arcsine:
            return angle_to(side, other_side(side));
        case MathOp::arccosine:
            return angle_to(other_side(side), side);
        case MathOp::arctangent:
            return angle_to(a, T(1.0));
        case MathOp::arctan2:
            return angle_to(a, b);
        case MathOp::radians:
            return T(std::numbers::pi / 180.0) * a;
        case MathOp::degrees:
            return T(180.0 / std::numbers::pi) * a;
        default:
            break;
    }
    const T up = exponential(a), down = exponential(T(0.0) - a);
    if (op == MathOp::sinh) return T(0.5) * (up - down);
    if (op == MathOp::cosh) return T(0.5) * (up + down);
    if (std::abs(value_of(a)) > 20.0) return T(value_of(a) < 0.0 ? -1.0 : 1.0);
    return quotient(up - down, up + down);
}

template <class T>
T rounding(MathOp op, const T& a, const T& b, const T& c) {
    switch (op) {
        case MathOp::round:
            return T(floor_of(a + T(0.5)));
        case MathOp::floor:
            return T(floor_of(a));
        case MathOp::ceil:
            return T(std::ceil(value_of(a)));
        case MathOp::trunc:
            return T(std::trunc(value_of(a)));
        case MathOp::fract:
            return a - T(floor_of(a));
        case MathOp::modulo:
            return modulo(a, b);
        case MathOp::wrap:
            return wrapped(a, b, c);
        case MathOp::snap:
            return T(floor_of(quotient(a, b))) * b;
        default:
            return pingpong(a, b);
    }
}

template <class T>
T comparison(MathOp op, const T& a, const T& b, const T& c) {
    const double x = value_of(a), y = value_of(b);
    switch (op) {
        case MathOp::minimum:
            return smaller(a, b);
        case MathOp::maximum:
            return larger(a, b);
        case MathOp::less_than:
            return flag<T>(x < y);
        case MathOp::greater_than:
            return flag<T>(x > y);
        case MathOp::sign:
            return T(x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0);
        case MathOp::compare:
            return flag<T>(std::abs(x - y) <= std::max(value_of(c), 1e-5));
        case MathOp::smooth_min:
            return smooth_smaller(a, b, c);
        default:
            return T(0.0) - smooth_smaller(T(0.0) - a, T(0.0) - b, c);
    }
}

/// Blender's Math node.
template <class T>
T math(MathOp op, const T& a, const T& b, const T& c) {
    if (op >= MathOp::sine) return trigonometry(op, a, b);
    if (op >= MathOp::round) return rounding(op, a, b, c);
    if (op >= MathOp::minimum) return comparison(op, a, b, c);
    switch (op) {
        case MathOp::add:
            return a + b;
        case MathOp::subtract:
            return a - b;
        case MathOp::multiply:
            return a * b;
        case MathOp::divide:
            return quotient(a, b);
        case MathOp::multiply_add:
            return a * b + c;
        case MathOp::power:
            return raised(a, b);
        case MathOp::logarithm:
            return quotient(logarithm(a), logarithm(b));
        case MathOp::sqrt:
            return root(a);
        case MathOp::inverse_sqrt:
            return quotient(T(1.0), root(a));
        case MathOp::absolute:
            return absolute(a);
        default:
            return exponential(a);
    }
}

enum class VectorOp {
    add,
    subtract,
    multiply,
    divide,
    multiply_add,
    cross_product,
    project,
    reflect,
    refract,
    faceforward,
    dot_product,
    distance,
    length,
    scale,
    normalize,
    absolute,
    minimum,
    maximum,
    floor,
    ceil,
    fraction,
    modulo,
    wrap,
    snap,
    sine,
    cosine,
    tangent
};

/// The operation that Math has, too, on each coordinate; `add` where there is none.
constexpr MathOp by_coordinate(VectorOp op) {
    switch (op) {
        case VectorOp::subtract:
            return MathOp::subtract;
        case VectorOp::multiply:
            return MathOp::multiply;
        case VectorOp::divide:
            return MathOp::divide;
        case VectorOp::multiply_add:
            return MathOp::multiply_add;
        case VectorOp::absolute:
            return MathOp::absolute;
        case VectorOp::minimum:
            return MathOp::minimum;
        case VectorOp::maximum:
            return MathOp::maximum;
        case VectorOp::floor:
            return MathOp::floor;
        case VectorOp::ceil:
            return MathOp::ceil;
        case VectorOp::fraction:
            return MathOp::fract;
        case VectorOp::modulo:
            return MathOp::modulo;
        case VectorOp::wrap:
            return MathOp::wrap;
        case VectorOp::snap:
            return MathOp::snap;
        case VectorOp::sine:
            return MathOp::sine;
        case VectorOp::cosine:
            return MathOp::cosine;
        case VectorOp::tangent:
            return MathOp::tangent;
        default:
            return MathOp::add;
    }
}

/// Blender's Vector Math node; a number comes as three equal ones.
template <class T>
Triple<T> vector_math(VectorOp op, const Triple<T>& a, const Triple<T>& b, const Triple<T>& c,
                      const T& scale) {
    const auto all = [](const T& x) { return Triple<T>{x, x, x}; };
    switch (op) {
        case VectorOp::cross_product:
            return cross(a, b);
        case VectorOp::project:
            return times(quotient(dot(a, b), dot(b, b)), b);
        case VectorOp::reflect:
            return a - times(T(2.0) * dot(unit(b), a), unit(b));
        case VectorOp::refract:
            return refracted(a, unit(b), scale);
        case VectorOp::faceforward:
            return value_of(dot(c, b)) < 0.0 ? a : times(T(-1.0), a);
        case VectorOp::dot_product:
            return all(dot(a, b));
        case VectorOp::distance:
            return all(length(a - b));
        case VectorOp::length:
            return all(length(a));
        case VectorOp::scale:
            return times(scale, a);
        case VectorOp::normalize:
            return unit(a);
        default:
            break;
    }
    const MathOp each = by_coordinate(op);
    return {math(each, a.x, b.x, c.x), math(each, a.y, b.y, c.y), math(each, a.z, b.z, c.z)};
}

enum class RangeCurve { linear, stepped, smoothstep, smootherstep };

template <class T>
struct Range {
    T from_low, from_high, to_low, to_high, steps;
};

/// Blender's Map Range node, before it clamps; 0 where the first range has no width.
template <class T>
T mapped(RangeCurve curve, const T& x, const Range<T>& range) {
    if (value_of(range.from_low) == value_of(range.from_high)) return T(0.0);
    T share = quotient(x - range.from_low, range.from_high - range.from_low);
    switch (curve) {
        case RangeCurve::linear:
            break;
        case RangeCurve::stepped:
            share = quotient(T(floor_of(share * (range.steps + T(1.0)))), range.steps);
            break;
        case RangeCurve::smoothstep:
            share = smooth(clamped(share));
            break;
        case RangeCurve::smootherstep: {
            const T t = clamped(share);
            share = t * t * t * (t * (t * T(6.0) - T(15.0)) + T(10.0));
        }
    }
    return range.to_low + share * (range.to_high - range.to_low);
}

}  // namespace burl::blender
