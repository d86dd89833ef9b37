#include "procedural/kernels/offset_kernel.h"

#include <algorithm>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/offset_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/kernels/piece_lanes-inl.h"
#include "procedural/numbers/fixed_point-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// Adds cells and places (the carry included) to the coordinates from texel `at` on.
HWY_ATTR HWY_INLINE void AddTo(Bit cells, Bit places, std::uint32_t* to_cells,
                               std::uint32_t* to_places) {
    const Bits d;
    const Bit before = hn::LoadU(d, to_places), after = hn::Add(before, places);
    const Bit carry = hn::VecFromMask(d, hn::Lt(after, before));  // -1 with a carry, else 0
    hn::StoreU(after, d, to_places);
    hn::StoreU(hn::Sub(hn::Add(hn::LoadU(d, to_cells), cells), carry), d, to_cells);
}

/// Moves `count` texels from number `at` on along an axis, by their offsets times the components u
/// and v of their sides.
HWY_ATTR HWY_INLINE void MoveTexels(const TexelOffsets& offsets, std::size_t at, std::size_t count,
                                    double u, double v, std::uint32_t* cells,
                                    std::uint32_t* places) {
    const Doubles d;
    // The move of a vector of texels from j on; 0 beyond the piece, where another piece's follow.
    const auto moved = [&](std::size_t j) HWY_ATTR {
        const auto offset = [&](const float* values) HWY_ATTR {
            return hn::PromoteTo(d, hn::LoadU(HalfFloats(), values + at + j));
        };
        const auto sum = hn::Add(hn::Mul(offset(offsets.u), hn::Set(d, u)),
                                 hn::Mul(offset(offsets.v), hn::Set(d, v)));
        const auto own = hn::Lt(LaneNumbers(), hn::Set(d, double(count) - double(j)));
        return FixedPoint(hn::IfThenElseZero(own, sum));
    };
    for (std::size_t j = 0; j < count; j += hn::Lanes(Bits())) {
        const Halves by(moved(j), moved(j + hn::Lanes(d)));
        AddTo(by.upper, by.lower, cells + at + j, places + at + j);
    }
}

HWY_ATTR void MoveStream(const Affine3& map, std::span<const Piece> pieces,
                         const TexelOffsets& offsets, LatticeStream& stream) {
    PieceSides sides;
    std::size_t at = 0;
    for (std::size_t first = 0; first < pieces.size(); first += PieceSides::capacity) {
        const auto part =
            pieces.subspan(first, std::min(PieceSides::capacity, pieces.size() - first));
        sides.Map(map, 1.0, part);
        for (std::size_t i = 0; i < part.size(); ++i) {
            const std::size_t count = part[i].solid.count;
            for (int axis = 0; axis < 3; ++axis)
                MoveTexels(offsets, at, count, sides.u[axis][i], sides.v[axis][i],
                           stream.cells[axis], stream.places[axis]);
            at += count;
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(MoveStream);

void move_stream(const Affine3& lattice_from_solid, std::span<const Piece> pieces,
                 const TexelOffsets& offsets, LatticeStream& stream) {
    HWY_DYNAMIC_DISPATCH(MoveStream)(lattice_from_solid, pieces, offsets, stream);
}

}  // namespace burl
#endif
