#pragma once
// Evaluation of a polynomial at consecutive whole numbers by additions alone, as Kameya & Hart's
// "Bresenham Noise" evaluates its cubic (eq. 16 to 22), for any degree. The first differences come
// from the polynomial's coefficients by Stirling numbers of the second kind, never from samples:
// differences of d + 1 neighbouring samples consist mostly of the samples' rounding, which the sums
// amplify. A scan line's texels are cut into runs, each with differences of its own; runs begin at
// texels that depend on the line alone, so that it may be cut anywhere without a trace.
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "procedural/noise/lattice_site.h"

namespace burl {

/// Coefficients c_k of x^k, or differences D_m, from the constant on.
template <std::size_t degree>
using Powers = std::array<double, degree + 1>;

/// Calls f(0), f(1) ... f(count - 1) with constant arguments: short loops that compilers do not
/// unroll take up to twice as long.
template <std::size_t count, class Function>
constexpr void unrolled(Function&& f) {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
        (f(std::integral_constant<std::size_t, i>()), ...);
    }
    (std::make_index_sequence<count>());
}

/// The differences at 0 of a polynomial: p(j) = sum_m D_m binomial(j, m), eq. (21). Dividing by x,
/// then the quotient by x - 1, and so on leaves the remainders that are the coefficients in
/// Newton's basis x (x - 1) ... (x - m + 1); altogether D_m = m! sum_k S(k, m) c_k with Stirling's
/// numbers.
template <std::size_t size>
constexpr std::array<double, size> differences_at_zero(std::array<double, size> p) {
    unrolled<size - 1>([&](auto root) {
        unrolled<size - 1 - root>([&](auto k) {
            if constexpr (root > 0) p[size - 2 - k] += double(root) * p[size - 1 - k];
        });
    });
    double factorial = 1.0;
    unrolled<size>([&](auto m) {
        if constexpr (m > 1) p[m] *= factorial *= double(m);
    });
    return p;
}

/// The value and the differences of a polynomial, advanced from one whole number to the next.
/// Number is float, double or std::int64_t. The last counts in units of 2^-`fraction_bits`: |value|
/// must then stay below 2^(63 - fraction_bits), as must the |differences| at the start.
template <class Number, std::size_t degree>
class ForwardDifferences {
  public:
    explicit ForwardDifferences(const Powers<degree>& differences, int fraction_bits = 60) {
        if constexpr (fixed) unit_ = std::ldexp(1.0, -fraction_bits);
        for (std::size_t m = 0; m <= degree; ++m) order_[m] = encoded(differences[m]);
    }

    double value() const {
        if constexpr (fixed) return unit_ * double(std::int64_t(order_[0]));
        return double(order_[0]);
    }
    /// Advances to the next whole number by `degree` additions, eq. (22).
    void step() {
        for (std::size_t m = 0; m < degree; ++m) order_[m] += order_[m + 1];
    }

  private:
    static constexpr bool fixed = std::integral<Number>;
    /// The type of stored numbers. Unsigned sums wrap, so it does not matter whether a high
    /// difference overflows.
    using Stored = std::conditional_t<fixed, std::uint64_t, Number>;

    Stored encoded(double x) const {
        if constexpr (!fixed) return Number(x);
        constexpr double most = 0x1p62;
        const double units = std::isnan(x) ? 0.0 : std::clamp(x / unit_, -most, most);
        return Stored(std::int64_t(units + std::copysign(0.5, units)));
    }

    std::array<Stored, degree + 1> order_;
    double unit_ = 1.0;
};

/// Texels first to last - 1 of a scan line, which lie in one cell of the lattice; texels begin to
/// end - 1 are wanted.
struct CellSpan {
    std::int64_t first = 0, last = 0, begin = 0, end = 0;

    std::int64_t wanted_first() const { return std::max(first, begin); }
    std::int64_t wanted_last() const { return std::min(last, end); }
};

/// Calls run(origin, last) for every run that reaches wanted texels: its differences are computed
/// at texel `origin`, and it has at most `longest` texels. Returns the number of runs.
template <class Run>
std::int64_t for_each_run(const CellSpan& texels, std::int64_t longest, Run&& run) {
    const std::int64_t wanted = texels.wanted_first(), last = texels.wanted_last();
    std::int64_t runs = 0;
    for (std::int64_t j = wanted - (wanted - texels.first) % longest; j < last; j += longest) {
        run(j, last - j < longest ? last : j + longest);
        ++runs;
    }
    return runs;
}

/// Calls put(texel, value) for the texels from `begin` on up to last - 1; `differences` are those
/// at texel `origin`.
template <class Number, std::size_t degree, class Put>
void run_differences(ForwardDifferences<Number, degree> differences, std::int64_t origin,
                     std::int64_t last, std::int64_t begin, Put&& put) {
    std::int64_t j = origin;
    for (; j < begin; ++j) differences.step();
    for (; j < last; ++j) {
        put(j, differences.value());
        differences.step();
    }
}

/// The place of a texel, measured from the middle of its cell.
inline Vec3d cell_place(const LatticeLine& line, const std::array<std::int64_t, 3>& cell,
                        std::int64_t texel) {
    Vec3d u = line.start + double(texel) * line.step;
    for (int axis = 0; axis < 3; ++axis)
        u[axis] = (u[axis] - double(cell[std::size_t(axis)])) - 0.5;
    return u;
}

}  // namespace burl
