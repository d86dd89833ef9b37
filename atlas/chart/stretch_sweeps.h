#pragma once
// Gauss-Seidel descent on the stretch of a map, one inner vertex after the other: Newton's step on
// the stretch of the vertex's own triangles, halved until it lowers it without a flip. A sweep
// visits the vertices that gained by their last step, and their neighbours. It suits maps that are
// good on the whole and rough in detail only, as one carried over from a coarser patch.
#include <span>

#include "atlas/chart/patch.h"

namespace burl {

/// Moves the vertices that lie on no border loop, in at most `sweeps` sweeps; X / aspect + Y aspect
/// never rises (stretch.h). No triangle may be flipped. A vertex rests once a step gains it less
/// than 1 %.
void sweep_stretch(const Patch& patch, std::span<Vec2d> uv, double aspect, int sweeps);

}  // namespace burl
