#pragma once
// MaterialX's nodes of vectors and colours. Results that are numbers come three times. They differ
// by at most 1e-6 from MaterialX's shaders in float32, refract by 4e-6, hsvtorgb by 2e-5 and
// rotate3d, which has the sines of the shaders' renderer, by 2e-4 (see math.h).
#include "procedural/materialx/math.h"
#include "procedural/numbers/hsv.h"

namespace burl::materialx {

/// The operations of vectors: those of MathOp before `ifgreater`, which work on each channel, and
/// these.
enum class VectorOp {
    dotproduct = int(MathOp::ifgreater),
    crossproduct,
    normalize,
    magnitude,
    distance,
    rotate3d,
    reflect,
    refract,
    luminance,
    rgbtohsv,
    hsvtorgb
};

/// The vector a turned about an axis (Rodrigues, 1840), with the clock as seen from the axis's end.
template <class T>
Triple<T> turned(const Triple<T>& a, const Triple<T>& axis, const T& degrees) {
    const Triple<T> k = unit(axis);
    const T angle = T(std::numbers::pi / 180.0) * degrees;
    const T c = cosine_of(angle), s = sine_of(angle);
    return times(c, a) + times(s, cross(a, k)) + times((T(1.0) - c) * dot(k, a), k);
}

/// MaterialX's node of that category: a is its first input, b its second; of `rotate3d` b is the
/// axis and c.x the angle in degrees, of `refract` b the normal and c.x the index, of `luminance` b
/// the weights.
template <class T>
Triple<T> vector_math(VectorOp op, const Triple<T>& a, const Triple<T>& b, const Triple<T>& c) {
    const auto all = [](const T& x) { return Triple<T>{x, x, x}; };
    switch (op) {
        case VectorOp::dotproduct:
        case VectorOp::luminance:
            return all(dot(a, b));
        case VectorOp::crossproduct:
            return cross(a, b);
        case VectorOp::normalize:
            return unit(a);
        case VectorOp::magnitude:
            return all(length(a));
        case VectorOp::distance:
            return all(length(a - b));
        case VectorOp::rotate3d:
            return turned(a, b, c.x);
        case VectorOp::reflect:
            return a - times(T(2.0) * dot(b, a), b);
        case VectorOp::refract:
            return refracted(a, b, c.x);
        case VectorOp::rgbtohsv:
            return hsv_of(a);
        case VectorOp::hsvtorgb:
            return from_hsv(a);
    }
    const MathOp each = MathOp(op);
    return {math(each, a.x, b.x, c.x), math(each, a.y, b.y, c.y), math(each, a.z, b.z, c.z)};
}

}  // namespace burl::materialx
