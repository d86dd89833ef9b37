#pragma once
// Value noise within one lattice cell as a polynomial: the cell's eight numbers make it linear in
// each of three fade weights ("Bresenham Noise", eq. 12, here about the cell's middle), and along a
// straight line each weight is a polynomial of the texel's number, of degree 1, 3 or 5. So the
// noise is a polynomial of degree 3 (eq. 15), 9 or 15.
#include <algorithm>

#include "atlas/base/vec.h"
#include "procedural/bresenham/differences.h"
#include "procedural/noise/interpolated_noise.h"
#include "procedural/noise/lattice_site.h"
#include "procedural/noise/value_noise.h"

namespace burl {

/// The degree of a fade as a polynomial.
constexpr std::size_t fade_degree(Fade fade) {
    return fade == Fade::linear ? 1 : fade == Fade::smooth ? 3 : 5;
}

/// The coefficients of a cell's noise: coefficient c belongs to the product of the weights v
/// (noise/interpolated_noise.h) of those axes whose bit is set in c.
using CellBlend = std::array<double, 8>;

/// The coefficients of the cell whose lower corner is `cell`.
inline CellBlend cell_blend(const std::array<std::int64_t, 3>& cell, std::uint32_t seed,
                            const Period<3>& period = {}) {
    const LatticeSite<double, 3> site{cell, {}, period};
    std::array<std::array<std::uint32_t, 2>, 3> index;
    for (std::size_t axis = 0; axis < 3; ++axis)
        index[axis] = {site.index(axis, 0), site.index(axis, 1)};
    CellBlend n;
    for (std::size_t c = 0; c < 8; ++c)
        n[c] = lattice_value(index[0][c & 1], index[1][c >> 1 & 1], index[2][c >> 2], seed);
    for (std::size_t bit = 1; bit < 8; bit *= 2)
        for (std::size_t c = 0; c < 8; ++c) {
            if (c & bit) continue;
            const double low = n[c], high = n[c + bit];
            n[c] = 0.5 * (low + high);
            n[c + bit] = 0.5 * (high - low);
        }
    return n;
}

/// The noise at a place, measured from the cell's middle.
inline double blend_at(const CellBlend& n, Fade fade, const Vec3d& place) {
    const double x = fade_weight(fade, place.x).v, y = fade_weight(fade, place.y).v,
                 z = fade_weight(fade, place.z).v;
    const double low = (n[0] + n[1] * x) + (n[2] + n[3] * x) * y;
    const double high = (n[4] + n[5] * x) + (n[6] + n[7] * x) * y;
    return low + high * z;
}

/// The fade weight at place u + j du as a polynomial of j: its Taylor series, which is finite.
template <Fade fade>
Powers<fade_degree(fade)> weight_along(double u, double du) {
    const double t = u + u, s = du + du, tt = t * t, ss = s * s;
    if constexpr (fade == Fade::linear)
        return {t, s};
    else if constexpr (fade == Fade::smooth)
        return {t * (1.5 - 0.5 * tt), s * (1.5 - 1.5 * tt), -1.5 * t * ss, -0.5 * s * ss};
    else
        return {fade_weight(fade, u).v,        s * (1.875 * (1.0 - tt) * (1.0 - tt)),
                ss * (-3.75 * t * (1.0 - tt)), ss * s * (3.75 * tt - 1.25),
                ss * ss * (1.875 * t),         ss * ss * s * 0.375};
}

/// The polynomial low + high * factor.
template <std::size_t A, std::size_t B>
std::array<double, A + B - 1> blended(const std::array<double, A>& low,
                                      const std::array<double, A>& high,
                                      const std::array<double, B>& factor) {
    std::array<double, A + B - 1> sum{};
    std::copy(low.begin(), low.end(), sum.begin());
    for (std::size_t i = 0; i < A; ++i)
        for (std::size_t k = 0; k < B; ++k) sum[i + k] += high[i] * factor[k];
    return sum;
}

/// The noise at place + j step as a polynomial of j, valid while the line stays in the cell.
template <Fade fade>
Powers<3 * fade_degree(fade)> noise_along(const CellBlend& n, const Vec3d& place,
                                          const Vec3d& step) {
    const auto x = weight_along<fade>(place.x, step.x), y = weight_along<fade>(place.y, step.y),
               z = weight_along<fade>(place.z, step.z);
    const auto edge = [&](std::size_t c) { return blended<1>({n[c]}, {n[c + 1]}, x); };
    const auto low = blended(edge(0), edge(2), y), high = blended(edge(4), edge(6), y);
    return blended(low, high, z);
}

}  // namespace burl
