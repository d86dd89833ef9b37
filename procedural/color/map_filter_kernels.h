#pragma once
// The exact filters of map_filter.h on streams of footprints, vectorised as in texel_batch.h and
// with the same bits on every instruction set. The map is taken apart into what its breaks do: a
// periodic map is its mean plus, per jump and per kink, a Bernoulli polynomial of the distance to
// it, and a clamped one its low end plus powers of what lies beyond a break. So no piece is looked
// up, and antiderivatives are the next polynomials.
#include <vector>

#include "procedural/batch/texel_batch.h"
#include "procedural/color/map_pieces.h"

namespace burl {

/// A map as its breaks.
struct MapBreaks {
    Wrap wrap = Wrap::repeat;
    Vec3d base{0.0};  ///< `repeat`: the mean; `clamp`: the colour of the low end
    std::vector<MapBreak> breaks;

    explicit MapBreaks(const MapPieces& map);
};

/// Footprints, and the map's means over them in linear light. With `clamp` f is at most half a
/// support beyond [0,1] and a support at most 2^40 wide.
struct FootprintStream {
    alignas(64) double f[batch_capacity + batch_padding];
    alignas(64) double wide[batch_capacity + batch_padding];
    alignas(64) double narrow[batch_capacity + batch_padding];
    alignas(64) double color[3][batch_capacity + batch_padding];
};

// Each fills the colours of the first `count` footprints, to within 1e-8 of trapezoid_filtered for
// maps whose kinks are at most 1000 (colours per unit of f); the test measures.

/// Supports of less than 1/2, points included; `repeat` or `clamp`.
void filter_narrow(const MapBreaks& map, FootprintStream& stream, std::size_t count);
/// `narrow` does not count; supports of 2^-6 and more.
void filter_boxes(const MapBreaks& map, FootprintStream& stream, std::size_t count);
/// Supports of 2^-6 and more whose axes are at most 1000 times unequal, or 1e6 from a support of 2
/// on.
void filter_trapezoids(const MapBreaks& map, FootprintStream& stream, std::size_t count);

}  // namespace burl
