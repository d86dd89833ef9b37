// Numbers of several pieces gathered into vectors, for every instruction set. The file is included
// once per instruction set (hence the toggled guard), after hwy/foreach_target.h.
#if defined(BURL_PIECE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_PIECE_LANES_INL_H
#undef BURL_PIECE_LANES_INL_H
#else
#define BURL_PIECE_LANES_INL_H
#endif

#include <cstddef>

#include "procedural/batch/texel_batch.h"
#include "procedural/kernels/noise_corners-inl.h"
#include "procedural/noise/lattice_site.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// Start and step of the lines of the pieces from number i on, and their steps to the next row, one
/// piece per lane. Lanes beyond the last piece repeat it.
struct PieceLanes {
    hn::Vec<Doubles> x, y, z, u, v, w;  ///< start and step of the line
    hn::Vec<Doubles> down_x, down_y, down_z;

    HWY_ATTR HWY_INLINE PieceLanes(std::span<const Piece> pieces, std::size_t i) {
        const Doubles d;
        const hn::RebindToSigned<Doubles> ints;
        static_assert(sizeof(Piece) % sizeof(double) == 0);
        constexpr double stride = sizeof(Piece) / sizeof(double);
        const auto number = hn::Min(hn::Add(LaneNumbers(), hn::Set(d, double(i))),
                                    hn::Set(d, double(pieces.size() - 1)));
        const auto at = hn::ConvertTo(ints, hn::Mul(number, hn::Set(d, stride)));
        const auto* bytes = reinterpret_cast<const unsigned char*>(pieces.data());
        const auto numbers = [&](std::size_t offset) HWY_ATTR {
            return hn::GatherIndex(d, reinterpret_cast<const double*>(bytes + offset), at);
        };
        constexpr std::size_t start = offsetof(Piece, solid) + offsetof(LatticeLine, start);
        constexpr std::size_t step = offsetof(Piece, solid) + offsetof(LatticeLine, step);
        constexpr std::size_t down = offsetof(Piece, down);
        constexpr std::size_t one = sizeof(double), two = 2 * sizeof(double);
        x = numbers(start), y = numbers(start + one), z = numbers(start + two);
        u = numbers(step), v = numbers(step + one), w = numbers(step + two);
        down_x = numbers(down), down_y = numbers(down + one), down_z = numbers(down + two);
    }
};

/// The dot product a x + b y + c z.
HWY_ATTR HWY_INLINE Double Dot(Double a, Double b, Double c, Double x, Double y, Double z) {
    return hn::Add(hn::Add(hn::Mul(a, x), hn::Mul(b, y)), hn::Mul(c, z));
}
HWY_ATTR HWY_INLINE Double Dot(double a, double b, double c, Double x, Double y, Double z) {
    const Doubles d;
    return Dot(hn::Set(d, a), hn::Set(d, b), hn::Set(d, c), x, y, z);
}

/// The sides of up to `capacity` pieces' texels in a lattice, one array per axis: u to the next
/// column, v to the next row.
struct PieceSides {
    static constexpr std::size_t capacity = 64;
    alignas(64) double u[3][capacity], v[3][capacity];

    /// Fills the sides of `pieces` times `scale`. A component of half of lattice_limit or more (or
    /// NaN) before scaling counts as 0.
    HWY_ATTR void Map(const Affine3& map, double scale, std::span<const Piece> pieces) {
        const Doubles d;
        const auto limit = hn::Set(d, 0.5 * lattice_limit), scales = hn::Set(d, scale);
        for (std::size_t i = 0; i < pieces.size(); i += hn::Lanes(d)) {
            const PieceLanes p(pieces, i);
            for (int axis = 0; axis < 3; ++axis) {
                const double a = map.linear[0][axis], b = map.linear[1][axis],
                             c = map.linear[2][axis];
                const auto store = [&](Double side, double* out) HWY_ATTR {
                    const auto near = hn::Lt(hn::Abs(side), limit);
                    hn::Store(hn::Mul(scales, hn::IfThenElseZero(near, side)), d, out + i);
                };
                store(Dot(a, b, c, p.u, p.v, p.w), u[axis]);
                store(Dot(a, b, c, p.down_x, p.down_y, p.down_z), v[axis]);
            }
        }
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
