#pragma once
// Means of the discontinuous functions that patterns are made of over a box of values [x - w/2, x +
// w/2]: exact antialiasing wherever x is locally linear (Hart et al. 1999, eq. (9), with a pattern
// in the colour map's place). All are closed forms in float64; w = 0 gives the function itself.
#include <cmath>

#include "procedural/numbers/dual.h"

namespace burl {

/// The width from which a box counts as infinite.
inline constexpr double widest_box = 0x1p30;

/// 1 where floor(x) is odd, else 0.
inline double odd_cell(double x) {
    const double half = 0.5 * std::floor(x);
    return half == std::floor(half) ? 0.0 : 1.0;
}

/// The share of odd cells in the box, in [0, 1]. The error is at most 1e-15 / w + 1e-16, because
/// the share below x - w/2 is subtracted from that below x + w/2.
inline Dual box_odd(const Dual& x, double width) {
    if (!(width < widest_box)) return 0.5;
    const double low = x.value - 0.5 * width, high = x.value + 0.5 * width;
    if (std::floor(low) == std::floor(high)) return odd_cell(x.value);
    // `below` is the length of odd cells in [0, u]; u counts from the even cell at or below `low`.
    const double start = 2.0 * std::floor(0.5 * low);
    const auto below = [](double u) {
        return std::floor(0.5 * u) + 2.0 * std::max(0.5 * u - std::floor(0.5 * u) - 0.5, 0.0);
    };
    return chain(x, (below(high - start) - below(low - start)) / width,
                 (odd_cell(high) - odd_cell(low)) / width);
}

/// The mean of x - floor(x) over the box.
inline Dual box_fract(const Dual& x, double width) {
    if (!(width < widest_box)) return 0.5;
    const double low = x.value - 0.5 * width, high = x.value + 0.5 * width;
    const double cells = std::floor(high) - std::floor(low);
    if (cells == 0.0) return dual_fract(x);
    const double from = low - std::floor(low), to = high - std::floor(high);
    return chain(x, 0.5 * (cells + (to - from) * (to + from)) / width, (to - from) / width);
}

/// The share of the box that is not negative.
inline Dual box_step(const Dual& x, double width) {
    if (std::abs(x.value) >= 0.5 * width || !(width > 0.0)) return x.value >= 0.0 ? 1.0 : 0.0;
    return chain(x, 0.5 + x.value / width, 1.0 / width);
}

/// The share of the box where x - floor(x) is at least a threshold in [0, 1]. The error is at most
/// 1e-15 / w + 1e-16.
inline Dual box_pulse(const Dual& x, double width, double threshold) {
    if (!(width < widest_box)) return 1.0 - threshold;
    const auto pulse = [=](double u) { return u - std::floor(u) >= threshold ? 1.0 : 0.0; };
    const double low = x.value - 0.5 * width, high = x.value + 0.5 * width;
    const double start = std::floor(low), first = pulse(low), last = pulse(high);
    if (start == std::floor(high) && first == last) return pulse(x.value);
    // `below` is the length of pulses in [0, u]; u counts from the period that holds `low`.
    const auto below = [=](double u) {
        return std::floor(u) * (1.0 - threshold) + std::max(u - std::floor(u) - threshold, 0.0);
    };
    return chain(x, (below(high - start) - below(low - start)) / width, (last - first) / width);
}

/// The share of the box that is not negative, which fades to `mean` as the box widens from half of
/// `widest` to `widest`.
inline Dual box_step(const Dual& x, double width, double mean, double widest) {
    const Dual share = box_step(x, width);
    if (!(width > 0.5 * widest)) return share;
    return dual_lerp(dual_smoothstep(0.5 * widest, widest, width), share, mean);
}

/// The mean of sin(x) over the box.
inline Dual box_sin(const Dual& x, double width) {
    const double half = 0.5 * width;
    if (!(half < widest_box)) return 0.0;
    const double damping = half > 1e-4 ? sine(half) / half : 1.0 - half * half / 6.0;
    return chain(x, damping * sine(x.value), damping * cosine(x.value));
}

}  // namespace burl
