#pragma once
// Splitting of chords: inner edges of a patch whose two ends lie on one side of the rectangle that
// the patch is mapped onto. All vertices of the part that a chord cuts off lie on that side, and
// the part would collapse onto it. Putting a vertex in the middle of every chord removes the cause;
// the surface stays as it is, and since both triangles at the edge belong to the patch no neighbour
// sees a new vertex. Then the map with positive weights is one to one (Tutte, "How to draw a
// graph", 1963; Floater, "Parametrization and smooth approximation of surface triangulations",
// 1997).
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/chart/patch.h"

namespace burl {

/// Sides of the rectangle that a vertex lies on: bit i is set for side i; corners have two bits,
/// inner vertices none.
using SideMask = std::uint8_t;

/// Splits every inner edge whose ends share a side (a bit). `sides` has one entry per vertex; loops
/// keep their order. Returns the number of vertices added, at the end of the vertex list; they lie
/// on no side. The patch's triangles are renumbered; pieces of one triangle follow each other in
/// the place of the triangle.
std::uint32_t split_chords(Patch& patch, std::span<const SideMask> sides);

/// Splits every inner edge of a disk whose two ends lie on its border; see split_chords().
std::uint32_t split_border_chords(Patch& patch);

}  // namespace burl
