#pragma once
// The frame in which patches are decided on: the mesh in a box of side 1, its coordinates rounded
// to 2^-24. Scaling or moving the mesh changes them by next to nothing, so that partition, corners
// and packing come out the same; the exported mesh has its own positions.
#include "atlas/patch/maps.h"

namespace burl {

/// The mesh in the unit frame, with positions and triangles only: positions are (p - low) / longest
/// side rounded to multiples of 2^-24, with `low` and side of the mesh's box. A mesh whose box is
/// empty or a point stays as it is.
Mesh in_unit_frame(const Mesh& mesh);

/// Gives the vertices of maps made in the unit frame the mesh's own positions, and planes, areas
/// and stretches its units. Inner places of rectangle maps stay as they are; planar patches are
/// projected anew.
void to_mesh_frame(PatchMaps& maps, const Mesh& mesh);

}  // namespace burl
