#pragma once
// Arithmetic on arrays of float64, one operation over a whole batch at a time: texture graphs are
// evaluated by it where only values are needed (value_program.h). Kernels are vectorised as in
// texel_batch.h, with the same bits on every instruction set.
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "procedural/batch/texel_batch.h"

namespace burl {

/// An operation on the inputs a, b, c, d with the parameters p, q, r, s.
enum class ValueOp : std::uint8_t {
    constant,    ///< p
    affine,      ///< p a + q b + r c + s
    linear,      ///< p a + q
    combine,     ///< p a + q b + r
    add,         ///< a + b
    multiply,    ///< a b
    products,    ///< a b + c d
    ratio,       ///< a / b, and 0 where b is not above 0
    minimum,     ///< b where it is below a, else a
    maximum,     ///< b where it is above a, else a
    absolute,    ///< |a|
    floor,       ///< the largest whole number not above a
    fract,       ///< a - floor(a)
    odd,         ///< 1 where floor(a) is odd, else 0
    at_least,    ///< 1 where a >= p, else 0
    smoothstep,  ///< 0 up to p, 1 from q on, 3u^2 - 2u^3 between; a step where q <= p
    lerp,        ///< (1 - a) b + a c
    length,      ///< sqrt(a^2 + b^2)
    power,       ///< a^p, p >= 0, by Power; a negative a counts as 0 unless p is whole
    sine,        ///< sin(a), a in radians, by Sine of elementary-inl.h, with the error stated there
    angle,       ///< angle of the point (b, a) in [-pi, pi] radians, 0 at the origin, by Angle
};

/// An operation with its parameters.
struct ValueOperation {
    ValueOp op = ValueOp::constant;
    std::array<double, 4> parameters{};
    bool operator==(const ValueOperation&) const = default;
};

/// out[j] = the operation on inputs[...][j]. Reads and writes whole vectors: every array is aligned
/// to 64 bytes and holds batch_padding elements more than `count`. `out` may be an input.
void apply(const ValueOperation& operation, const std::array<const double*, 4>& inputs,
           std::size_t count, double* out);

/// Three channels that are polynomials of degree 1 or 3 between breaks: a colour map or a spline.
struct ColorPieces {
    enum class Argument { repeat, clamp } argument = Argument::clamp;  ///< takes x to [0, 1]
    std::size_t degree = 1;
    std::vector<double> begins;  ///< ascending; the first piece extends to the left
    /// The pieces: each has its begin, then per channel the coefficients of powers of x - begin.
    std::vector<double> table;
    bool operator==(const ColorPieces&) const = default;

    /// The numbers of a piece in `table`.
    std::size_t stride() const { return 1 + 3 * (degree + 1); }
};

/// out[c][j] = channel c at x[j]; an x that is not finite counts as 0. Arrays are as in apply().
void look_up(const ColorPieces& pieces, const double* x, std::size_t count,
             const std::array<double*, 3>& out);

}  // namespace burl
