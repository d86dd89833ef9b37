#pragma once
// The frame in which patches are decided on: the mesh in a box of side 1, its coordinates rounded
// to 2^-24. Scaling or moving the mesh changes them by next to nothing, so that partition, corners
// and packing come out the same; what is exported uses the mesh's own positions.
#include "atlas/patch/maps.h"

namespace burl {

/// Positions and triangles of the mesh, (p - low) / longest side rounded to multiples of 2^-24; low
/// and side are those of the mesh's box. The mesh as it is where its box is empty or a point.
Mesh in_unit_frame(const Mesh& mesh);

/// Gives the vertices of maps made in the unit frame the mesh's own positions, and planes, areas
/// and stretches its units. Inner maps stay as they are; a plane's are projected anew.
void to_mesh_frame(PatchMaps& maps, const Mesh& mesh);

}  // namespace burl
