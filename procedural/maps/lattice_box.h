#pragma once
// The box of an atlas's points in a lattice: 8-bit images of coordinates (passes/plan.h) need it to
// share out their bits before anything is drawn.
#include "atlas/solid/solid_atlas.h"
#include "procedural/passes/plan.h"

namespace burl {

/// The box of all texels in spans, their points mapped by `lattice_from_atlas`. The box of an atlas
/// without spans is the origin.
LatticeBox lattice_box(const SolidAtlas& solid, const Affine3& lattice_from_atlas);

}  // namespace burl
