#pragma once
// The mean of a noise, which stands for octaves too fine for a sample: leaving |n| out altogether
// would darken the distance.
#include "procedural/noise/spec.h"

namespace burl {

/// The mean of n over uniform points in three dimensions, in four if `timed` (Worley's: of F1), to
/// within 1e-3.
constexpr double mean_value(NoiseKind kind, bool timed = false) {
    if (kind != NoiseKind::worley) return 0.0;
    return timed ? 0.5901 : 0.5205;
}

/// The mean of |n| over uniform points, to within 1e-3 (measured over 2e6 points); value noise is
/// taken with the smooth fade.
constexpr double mean_absolute(NoiseKind kind, bool timed = false) {
    switch (kind) {
        case NoiseKind::value:
            return timed ? 0.2572 : 0.3032;
        case NoiseKind::perlin:
            return timed ? 0.2376 : 0.2203;
        case NoiseKind::perlin2002:
            return timed ? 0.2358 : 0.2203;
        case NoiseKind::perlin1985:
            return 0.1503;
        case NoiseKind::simplex:
            return timed ? 0.1746 : 0.0936;
        case NoiseKind::worley:
            return mean_value(kind, timed);
        case NoiseKind::cell:
        case NoiseKind::white:
            return 0.5;
    }
    return 0.0;
}

}  // namespace burl
