#pragma once
// A random vector field without divergence: the curl of a potential, as in Bridson, Houriham and
// Nordenstam, "Curl-noise for procedural fluid flow" (2007). The potential is a simplex noise of
// vectors, the sum of t^4 r over the corners of the point's simplex with t = 1/2 - d . d and a
// random unit vector r for each corner (simplex_signal.h), so its curl and the curl's derivatives
// are exact: a vortex of axis r round every lattice point.
#include <cmath>
#include <optional>

#include "procedural/noise/simplex_signal.h"

namespace burl {

/// A vector field at a point, with its derivatives: slope[a][i] is that of component a along axis
/// i.
template <class Real>
struct FieldVector {
    std::array<Real, 3> value{};
    std::array<std::array<Real, 3>, 3> slope{};
};

/// The cross product.
template <class Real>
std::array<Real, 3> cross_of(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The factor that makes the field's mean square length 1. That of a kernel's -8 t^3 (d x r) is 64
/// t^6 d . d 2/3, with the three first components of d.
inline double simplex_curl_amplitude(std::size_t dimensions) {
    const double n = double(dimensions);
    return std::sqrt((n + 14.0) /
                     (64.0 * std::sqrt(n + 1.0) * simplex_kernel_integral(dimensions, 6)));
}

/// The field at p divided by its amplitude. N is 3, or 4 with the time as last coordinate, along
/// which the field changes.
template <class Real, std::size_t N>
FieldVector<Real> simplex_curl(std::uint32_t seed, const Point<N>& p) {
    FieldVector<Real> sum;
    const auto add = [&](const auto& corner, const std::array<Real, N>& d) {
        Real t = Real(0.5);
        for (std::size_t i = 0; i < N; ++i) t -= d[i] * d[i];
        if (t < 0) return;
        const auto r = simplex_direction<Real, 3>(simplex_bits(corner, seed));
        const std::array<Real, 3> m = cross_of<Real>({d[0], d[1], d[2]}, r);
        const Real t2 = t * t, bend = Real(48) * t2, pull = Real(8) * (t2 * t);
        for (std::size_t a = 0; a < 3; ++a) sum.value[a] -= pull * m[a];
        for (std::size_t i = 0; i < 3; ++i) {
            std::array<Real, 3> axis{};
            axis[i] = Real(1);
            const std::array<Real, 3> turned = cross_of(axis, r);
            for (std::size_t a = 0; a < 3; ++a)
                sum.slope[a][i] += bend * d[i] * m[a] - pull * turned[a];
        }
    };
    for_simplex_corners<Real>(simplex_place(lattice_site<double>(p)), add);
    return sum;
}

/// simplex_curl at p and, if there is one, at a time, by Real. Against float64, float32 errs by at
/// most 3e-7 in a component and 2e-6 in a derivative.
template <class Real>
FieldVector<double> sample_curl(std::uint32_t seed, const Point<3>& p, std::optional<double> time) {
    const auto n = time ? simplex_curl<Real, 4>(seed, {p[0], p[1], p[2], *time})
                        : simplex_curl<Real, 3>(seed, p);
    FieldVector<double> result;
    for (std::size_t a = 0; a < 3; ++a) {
        result.value[a] = double(n.value[a]);
        for (std::size_t i = 0; i < 3; ++i) result.slope[a][i] = double(n.slope[a][i]);
    }
    return result;
}

}  // namespace burl
