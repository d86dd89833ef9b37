#pragma once
// Hue, saturation and value of colours (Smith, "Color Gamut Transform Pairs", 1978), for plain
// numbers and for numbers with gradients.
#include "procedural/numbers/numeric.h"

namespace burl::numeric {

/// Hue in turns, saturation and value of a colour.
template <class T>
Triple<T> hsv_of(const Triple<T>& c) {
    const T most = larger(c.x, larger(c.y, c.z)), least = smaller(c.x, smaller(c.y, c.z));
    const T chroma = most - least;
    if (value_of(chroma) == 0.0) return {T(0.0), T(0.0), most};
    const double top = value_of(most);
    T hue;
    if (value_of(c.x) == top)
        hue = quotient(c.y - c.z, chroma);
    else if (value_of(c.y) == top)
        hue = T(2.0) + quotient(c.z - c.x, chroma);
    else
        hue = T(4.0) + quotient(c.x - c.y, chroma);
    hue = T(1.0 / 6.0) * hue;
    if (value_of(hue) < 0.0) hue = hue + T(1.0);
    return {hue, quotient(chroma, most), most};
}

/// The colour of a hue in turns, a saturation and a value.
template <class T>
Triple<T> from_hsv(const Triple<T>& hsv) {
    const auto channel = [&](double ahead) {
        T turn = hsv.x + T(ahead);
        turn = turn - T(floor_of(turn));
        const T share = clamped(absolute(T(6.0) * turn - T(3.0)) - T(1.0));
        return hsv.z * ((T(1.0) - hsv.y) + hsv.y * share);
    };
    return {channel(0.0), channel(2.0 / 3.0), channel(1.0 / 3.0)};
}

}  // namespace burl::numeric
