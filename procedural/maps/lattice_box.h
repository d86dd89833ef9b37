#pragma once
// What an atlas shows of a lattice: 8-bit images of coordinates (multipass_plan.h) have to share
// out their bits before anything is drawn.
#include "atlas/solid/solid_atlas.h"
#include "procedural/passes/plan.h"

namespace burl {

/// Of all texels in spans. The maps' points go through `lattice_from_atlas`. An atlas without
/// texels has the box of the origin.
LatticeBox lattice_box(const SolidAtlas& solid, const Affine3& lattice_from_atlas);

}  // namespace burl
