#pragma once
// The weights that lattice noise is interpolated with: linear, Perlin's s-curve 3x^2 - 2x^3 (1985)
// and his quintic 6x^5 - 15x^4 + 10x^3 (2002). Written about the cell's middle, as t plus a
// correction that vanishes towards the ends, they lose less in float32 than as powers of x.
#include "procedural/noise/spec.h"

namespace burl {

/// The weight w of the upper corner as v = 2 w - 1 in [-1, 1], and the slope dv/du.
template <class Real>
struct FadeWeight {
    Real v = 0, slope = 0;
};

/// The weight at u = x - 1/2 in [-1/2, 1/2], x being the place in the cell.
template <class Real>
FadeWeight<Real> fade_weight(Fade fade, Real u) {
    const Real t = u + u, square = t * t;
    switch (fade) {
        case Fade::linear:
            return {t, Real(2)};
        case Fade::smooth:
            return {t + t * (Real(0.5) - Real(0.5) * square), Real(3) - Real(3) * square};
        case Fade::quintic: {
            const Real rest = Real(1) - square;
            return {t + t * (rest * (Real(0.875) - Real(0.375) * square)),
                    Real(3.75) * (rest * rest)};
        }
    }
    return {t, Real(2)};
}

}  // namespace burl
