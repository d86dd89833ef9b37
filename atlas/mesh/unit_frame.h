#pragma once
// The frame in which atlases are decided on, so that a mesh's scale and place change nothing.
#include "atlas/mesh/mesh.h"

namespace burl {

/// The unit that positions in the unit frame are multiples of.
inline constexpr double frame_step = 0x1p-24;

/// The mesh in the unit frame with positions and triangles only: positions are (p - low) / longest
/// side rounded to multiples of 2^-24, with `low` and side of the mesh's box. Scaling or moving the
/// mesh changes no bit of nearly all of them (errors below 2^-41 of the side are rounded away, ties
/// included), so that partitions and packing come out the same. A mesh whose box is empty or a
/// point stays as it is.
Mesh in_unit_frame(const Mesh& mesh);

}  // namespace burl
