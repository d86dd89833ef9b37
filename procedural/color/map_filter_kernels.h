#pragma once
// The exact filters of map_filter.h on streams of footprints, vectorised as in texel_batch.h and
// with the same bits on every instruction set. The map is the sum of its breaks' shares: a periodic
// map is its mean plus, per jump and per kink, a Bernoulli polynomial of the distance to it; a
// clamped map is its low end's colour plus powers of the distance beyond each break. So no piece is
// looked up, and antiderivatives are the next polynomials.
#include <vector>

#include "procedural/batch/texel_batch.h"
#include "procedural/color/map_pieces.h"

namespace burl {

/// A colour map as a constant and its breaks.
struct MapBreaks {
    Wrap wrap = Wrap::repeat;
    Vec3d base{0.0};  ///< the map's mean (`repeat`) or the colour of its low end (`clamp`)
    std::vector<MapBreak> breaks;

    explicit MapBreaks(const MapPieces& map);
};

/// Footprints, and the map's means over them in linear light. With `clamp`, f lies at most half a
/// support (wide + narrow) beyond [0, 1], and a support is at most 2^40 wide.
struct FootprintStream {
    alignas(64) double f[batch_capacity + batch_padding];
    alignas(64) double wide[batch_capacity + batch_padding];
    alignas(64) double narrow[batch_capacity + batch_padding];
    alignas(64) double color[3][batch_capacity + batch_padding];
};

// Each function fills the colours of the first `count` footprints, to within 1e-8 of
// trapezoid_filtered for maps whose kinks are at most 1000 (colours per unit of f); the test
// measures it.

/// Filters footprints with supports of less than 1/2, points included, with `repeat` or `clamp`.
void filter_narrow(const MapBreaks& map, FootprintStream& stream, std::size_t count);
/// Filters footprints with supports of 2^-6 and more by boxes as wide as `wide`; `narrow` is
/// ignored.
void filter_boxes(const MapBreaks& map, FootprintStream& stream, std::size_t count);
/// Filters footprints with supports of 2^-6 and more whose axes are at most 1000 times unequal, or
/// 1e6 times from a support of 2 on.
void filter_trapezoids(const MapBreaks& map, FootprintStream& stream, std::size_t count);

}  // namespace burl
