#pragma once
// Perlin's simplex noise of 2001 ("Noise Hardware", course notes, appendix B): the cubic lattice
// skewed along its diagonal and cut into simplices, whose corners contribute spherical kernels,
// with gradients from a bit-pattern hash of the lattice coordinates (which repeats after 256). The
// noise of three dimensions is exactly the appendix's; that of two and four follows its section on
// higher dimensions, which leaves hash, gradients, radius and amplitude open.
#include <numeric>
#include <utility>

#include "procedural/noise/lattice_site.h"
#include "procedural/numbers/lattice_hash.h"

namespace burl {

/// The appendix's bit patterns; the index has one bit of each coordinate.
inline constexpr std::array<std::uint8_t, 8> bit_patterns{0x15, 0x38, 0x32, 0x2c,
                                                          0x0d, 0x13, 0x07, 0x2a};

/// The appendix's shuffle(i,j,k), whose lower six bits name a gradient.
constexpr std::uint32_t bit_pattern_sum(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    std::uint32_t sum = 0;
    for (unsigned bit = 0; bit < 8; ++bit) {
        sum += bit_patterns[(i >> bit & 1) << 2 | (j >> bit & 1) << 1 | (k >> bit & 1)];
        const std::uint32_t first = i;
        i = j, j = k, k = first;
    }
    return sum;
}

/// The constants of simplex noise in N dimensions. The skew (sqrt(N+1) - 1) / N takes x to x + skew
/// * sum(x); `stretch`, sqrt(N+1), is its factor along the diagonal. The kernel's squared radius
/// `radius2` is the largest at which no kernel reaches beyond the simplices round its corner (but
/// in three dimensions the appendix's); `amplitude` makes |n| <= 1 almost tight in two and four
/// dimensions and is the appendix's in three. From five dimensions on there is the lattice alone,
/// whose kernels simplex_signal.h has.
template <std::size_t N>
struct SimplexShape {
    static_assert(N >= 5 && N <= 8);
    static constexpr std::array stretches{2.4494897427831779, 2.6457513110645907,
                                          2.8284271247461903, 3.0};
    static constexpr double stretch = stretches[N - 5];
};

template <>
struct SimplexShape<2> {
    static constexpr double stretch = 1.7320508075688772, radius2 = 0.5, amplitude = 70.0;
    static std::uint32_t hash(const std::array<std::uint32_t, 2>& i, std::uint32_t seed) {
        return LatticeHash::bits(i, seed) >> 26;
    }
    /// A gradient along both axes or one of them; components are 0 or +-1, as in the appendix.
    template <class Real>
    static std::array<Real, 2> gradient(std::uint32_t h) {
        const Real x = h & 32 ? Real(1) : Real(-1), y = h & 16 ? Real(1) : Real(-1);
        return h & 1 ? std::array<Real, 2>{x, y}
                     : (h & 2 ? std::array<Real, 2>{x, 0} : std::array<Real, 2>{0, y});
    }
};

template <>
struct SimplexShape<3> {
    static constexpr double stretch = 2.0, radius2 = 0.6, amplitude = 8.0;
    /// The appendix's hash; a seed moves the lattice of the patterns.
    static std::uint32_t hash(const std::array<std::uint32_t, 3>& i, std::uint32_t seed) {
        return bit_pattern_sum(i[0] + LatticeHash::shift(seed, 0),
                               i[1] + LatticeHash::shift(seed, 1),
                               i[2] + LatticeHash::shift(seed, 2));
    }
    /// The appendix's gradient: the lower three bits rotate the axes and choose a corner or an edge
    /// of the cube, the upper three are the signs.
    template <class Real>
    static std::array<Real, 3> gradient(std::uint32_t h) {
        const bool b5 = h & 32, b4 = h & 16, b3 = h & 8, b2 = h & 4;
        const std::uint32_t turn = h & 3;
        const std::size_t p = turn == 1 ? 0 : turn == 2 ? 1 : 2;
        const std::size_t q = turn == 1 ? 1 : turn == 2 ? 2 : 0;
        const std::size_t r = turn == 1 ? 2 : turn == 2 ? 0 : 1;
        std::array<Real, 3> g{};
        g[p] = b5 == b3 ? Real(-1) : Real(1);
        if (turn == 0 || !b2) g[q] = b5 == b4 ? Real(-1) : Real(1);
        if (turn == 0 || b2) g[r] = b5 != (b4 != b3) ? Real(-1) : Real(1);
        return g;
    }
};

template <>
struct SimplexShape<4> {
    static constexpr double stretch = 2.2360679774997896, radius2 = 0.5, amplitude = 62.0;
    static std::uint32_t hash(const std::array<std::uint32_t, 4>& i, std::uint32_t seed) {
        return LatticeHash::bits(i, seed) >> 26;
    }
    /// A gradient to the edges' midpoints of a hypercube, as in the improved noise: one component
    /// is 0.
    template <class Real>
    static std::array<Real, 4> gradient(std::uint32_t h) {
        std::array<Real, 4> g{};
        std::uint32_t signs = h >> 3;
        for (std::uint32_t axis = 0; axis < 4; ++axis) {
            if (axis == (h & 3)) continue;
            g[axis] = signs & 1 ? Real(1) : Real(-1);
            signs >>= 1;
        }
        return g;
    }
};

/// A point in the skewed lattice.
template <std::size_t N>
struct SimplexPlace {
    std::array<std::int64_t, N>
        /// Lowest corner of the point's skewed cube, in skewed coordinates.
        corner{};
    std::array<double, N> offset{};  ///< the point less `corner`, unskewed
};

/// The place of a point in the skewed lattice. The whole part of the coordinates is skewed apart
/// from their fractions, which stay small numbers. In three dimensions, where the skew is 1/3, a
/// point that is a multiple of 2^-48 gets exactly its own cube and order of offsets.
template <std::size_t N>
SimplexPlace<N> simplex_place(const LatticeSite<double, N>& site) {
    constexpr double stretch = SimplexShape<N>::stretch, skew = (stretch - 1.0) / double(N);
    const std::int64_t cells = std::accumulate(site.cell.begin(), site.cell.end(), std::int64_t(0));
    // skew * cells as a whole number and a rest in [0, 1).
    const auto rest3 = positive_remainder(cells, 3);
    const double product = skew * double(cells);
    const std::int64_t whole = N == 3 ? (cells - rest3) / 3 : std::int64_t(std::floor(product));
    const double rest = N == 3 ? double(rest3) / 3.0 : product - std::floor(product);

    std::array<double, N> fraction;
    double fractions = 0.0;
    for (std::size_t axis = 0; axis < N; ++axis)
        fractions += fraction[axis] = site.place[axis] + 0.5;
    SimplexPlace<N> result;
    double steps = 0.0;
    for (std::size_t axis = 0; axis < N; ++axis) {
        const double skewed = N == 3 ? (3.0 * fraction[axis] + fractions + double(rest3)) / 3.0
                                     : fraction[axis] + (rest + skew * fractions);
        const double step = std::floor(skewed);
        result.corner[axis] = site.cell[axis] + whole + std::int64_t(step);
        result.offset[axis] = fraction[axis] - step;
        steps += step;
    }
    const double back = rest / stretch + skew / stretch * steps;
    for (double& x : result.offset) x += back;
    return result;
}

/// Calls visit(corner, offset) for the corners of the simplex that holds a point, from the lowest
/// to the highest: the corner in skewed coordinates, and the point less the corner.
template <class Real, std::size_t N, class Visit>
void for_simplex_corners(SimplexPlace<N> place, Visit&& visit) {
    // The walk from the lowest corner to the highest goes along the largest offset first.
    std::array<std::size_t, N + 1> walk;
    std::iota(walk.begin(), walk.end(), std::size_t(0));
    for (std::size_t i = 1; i < N; ++i)  // ties keep their order, as the appendix has them
        for (std::size_t j = i; j > 0 && place.offset[walk[j]] > place.offset[walk[j - 1]]; --j)
            std::swap(walk[j], walk[j - 1]);
    std::array<Real, N> offset;
    for (std::size_t axis = 0; axis < N; ++axis) offset[axis] = Real(place.offset[axis]);
    constexpr auto unskew = Real((1.0 - 1.0 / SimplexShape<N>::stretch) / double(N));
    for (const std::size_t axis : walk) {
        visit(place.corner, offset);
        if (axis == N) break;
        ++place.corner[axis];
        for (Real& x : offset) x += unskew;
        offset[axis] -= Real(1);
    }
}

/// A lattice point modulo the period, in skewed coordinates. Six times the unskewed coordinates are
/// whole numbers; each is taken modulo six periods.
inline std::array<std::int64_t, 3> wrap_simplex(std::array<std::int64_t, 3> corner,
                                                const Period<3>& period) {
    const std::int64_t sum = corner[0] + corner[1] + corner[2];
    std::int64_t wrapped_sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        corner[axis] = 6 * corner[axis] - sum;
        if (period[axis] != 0)
            corner[axis] = positive_remainder(corner[axis], 6 * std::int64_t(period[axis]));
        wrapped_sum += corner[axis];
    }
    for (std::int64_t& i : corner) i = (i + wrapped_sum / 3) / 6;
    return corner;
}

/// A corner's kernel t^4 (g . d), t = radius2 - d . d, added to `sum`.
template <class Real, std::size_t N>
void add_kernel(const std::array<Real, N>& g, const std::array<Real, N>& d, Real radius2,
                NoiseSample<Real, N>& sum) {
    Real t = radius2, slope = 0;
    for (std::size_t axis = 0; axis < N; ++axis) {
        t -= d[axis] * d[axis];
        slope += g[axis] * d[axis];
    }
    if (t < 0) return;
    const Real t3 = t * t * t, t4 = t * t3;
    sum.value += t4 * slope;
    for (std::size_t axis = 0; axis < N; ++axis)
        sum.gradient[axis] += t4 * g[axis] - Real(8) * t3 * slope * d[axis];
}

/// Simplex noise at p: |n| <= 0.348 in three dimensions, 1 in two and four. `radius2` in three is
/// 0.6 in the appendix, where the noise jumps by up to 2e-3 across borders of simplices; with 0.5
/// it is continuous, at the same amplitude, |n| <= 0.129. Seed 0 is the appendix's noise. `period`
/// works in three dimensions only, in multiples of 3. The simplex is found in float64; from there
/// on float32 errs by at most 5e-7 in the value and 3e-6 in a gradient's component, and three times
/// that in two and four dimensions.
template <class Real, std::size_t N>
NoiseSample<Real, N> simplex_noise(const Point<N>& p, std::uint32_t seed,
                                   double radius2 = SimplexShape<N>::radius2,
                                   const Period<N>& period = {}) {
    using Shape = SimplexShape<N>;
    NoiseSample<Real, N> sum;
    const auto add = [&](auto corner, const std::array<Real, N>& offset) {
        if constexpr (N == 3) corner = wrap_simplex(corner, period);
        std::array<std::uint32_t, N> index;
        for (std::size_t i = 0; i < N; ++i) index[i] = std::uint32_t(corner[i]);
        add_kernel(Shape::template gradient<Real>(Shape::hash(index, seed)), offset, Real(radius2),
                   sum);
    };
    for_simplex_corners<Real>(simplex_place(lattice_site<double>(p, period)), add);
    sum.value *= Real(Shape::amplitude);
    for (Real& x : sum.gradient) x *= Real(Shape::amplitude);
    return sum;
}

}  // namespace burl
