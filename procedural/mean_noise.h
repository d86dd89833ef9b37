#pragma once
// What a noise is on average, which stands for octaves too fine for a sample: leaving |n| out
// altogether would darken the distance.
#include "procedural/noise_spec.h"

namespace burl {

/// Mean of n over uniform points in three dimensions (Worley's F1), to within 1e-3.
constexpr double mean_value(NoiseKind kind) {
    return kind == NoiseKind::worley ? 0.5205 : 0.0;
}

/// Mean of |n|, to within 1e-3 (measured over 2e6 points); value noise with the smooth fade.
constexpr double mean_absolute(NoiseKind kind) {
    switch (kind) {
        case NoiseKind::value:
            return 0.3032;
        case NoiseKind::perlin:
        case NoiseKind::perlin2002:
            return 0.2203;
        case NoiseKind::perlin1985:
            return 0.1503;
        case NoiseKind::simplex:
            return 0.0936;
        case NoiseKind::worley:
            return mean_value(kind);
        case NoiseKind::cell:
        case NoiseKind::white:
            return 0.5;
    }
    return 0.0;
}

}  // namespace burl
