#pragma once
// Blender's nodes of colours, in linear light: blend modes, hue, saturation and value, brightness
// and contrast, gamma.
#include "procedural/blender/math.h"
#include "procedural/numbers/hsv.h"

namespace burl::blender {

enum class BlendMode {
    mix,
    darken,
    multiply,
    burn,
    lighten,
    screen,
    dodge,
    add,
    overlay,
    soft_light,
    linear_light,
    difference,
    subtract,
    divide,
    hue,
    saturation,
    color,
    value
};

/// One channel of two colours mixed by the weight w of b.
template <class T>
T blended_channel(BlendMode mode, const T& w, const T& a, const T& b) {
    const T one = T(1.0), rest = one - w;
    switch (mode) {
        case BlendMode::darken:
            return blended(w, a, smaller(a, b));
        case BlendMode::multiply:
            return a * (rest + w * b);
        case BlendMode::burn: {
            const T below = rest + w * b;
            if (!(value_of(below) > 0.0)) return T(0.0);
            return clamped(one - quotient(one - a, below));
        }
        case BlendMode::lighten:
            return larger(a, w * b);
        case BlendMode::screen:
            return one - (rest + w * (one - b)) * (one - a);
        case BlendMode::dodge: {
            if (value_of(a) == 0.0) return T(0.0);
            const T below = one - w * b;
            if (!(value_of(below) > 0.0)) return one;
            return smaller(quotient(a, below), one);
        }
        case BlendMode::add:
            return a + w * b;
        case BlendMode::overlay:
            if (value_of(a) < 0.5) return a * (rest + T(2.0) * w * b);
            return one - (rest + T(2.0) * w * (one - b)) * (one - a);
        case BlendMode::soft_light: {
            const T screen = one - (one - b) * (one - a);
            return rest * a + w * ((one - a) * b * a + a * screen);
        }
        case BlendMode::linear_light:
            return a + w * (T(2.0) * b - one);
        case BlendMode::difference:
            return blended(w, a, absolute(a - b));
        case BlendMode::subtract:
            return a - w * b;
        case BlendMode::divide:
            return value_of(b) == 0.0 ? a : rest * a + w * quotient(a, b);
        default:
            return blended(w, a, b);
    }
}

/// Blender's Mix node for colours: b over a with the weight w.
template <class T>
Triple<T> mixed(BlendMode mode, const T& w, const Triple<T>& a, const Triple<T>& b) {
    if (mode < BlendMode::hue)
        return each(a, b, [&](const T& x, const T& y) { return blended_channel(mode, w, x, y); });
    Triple<T> base = hsv_of(a);
    const Triple<T> top = hsv_of(b);
    const bool grey = value_of(top.y) == 0.0;
    switch (mode) {
        case BlendMode::saturation:
            if (value_of(base.y) == 0.0) return a;
            base.y = blended(w, base.y, top.y);
            return from_hsv(base);
        case BlendMode::value:
            base.z = blended(w, base.z, top.z);
            return from_hsv(base);
        case BlendMode::hue:
            return grey ? a : blended(w, a, from_hsv(Triple<T>{top.x, base.y, base.z}));
        default:
            return grey ? a : blended(w, a, from_hsv(Triple<T>{top.x, top.y, base.z}));
    }
}

/// Blender's Hue Saturation Value node: hue 0.5 leaves hues as they are.
template <class T>
Triple<T> corrected_hsv(const Triple<T>& c, const T& hue, const T& saturation, const T& value,
                        const T& weight) {
    Triple<T> hsv = hsv_of(c);
    hsv.x = hsv.x + hue + T(0.5);
    hsv.y = clamped(hsv.y * saturation);
    hsv.z = hsv.z * value;
    const Triple<T> mix = blended(weight, c, from_hsv(hsv));
    return {larger(mix.x, T(0.0)), larger(mix.y, T(0.0)), larger(mix.z, T(0.0))};
}

template <class T>
T brightened(const T& c, const T& bright, const T& contrast) {
    return larger((T(1.0) + contrast) * c + bright - T(0.5) * contrast, T(0.0));
}

template <class T>
T gamma_of(const T& c, const T& gamma) {
    return value_of(c) > 0.0 ? raised(c, gamma) : c;
}

}  // namespace burl::blender
