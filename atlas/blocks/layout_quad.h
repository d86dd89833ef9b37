#pragma once
// The quad atlas: triangle pairs in blocks of 2^a x 2^b texels, ordered by a balanced quadtree of
// surface clusters, so that the square is full and every texel is a valid sample. A texel of a MIP
// level mixes blocks only where a block is smaller than the texel, and then only neighbours in the
// tree (Carr & Hart 2001, section 4.3).
#include "atlas/solid/atlas.h"

namespace burl {

/// Lays out a quad atlas; called by layout_atlas(). options.size is a power of two. Holds any mesh:
/// gutters narrow first, then blocks become single texels, which in the end stand for several
/// pairs. Pure and deterministic.
Atlas layout_quad(const Mesh& mesh, const Connectivity& connectivity, const AtlasOptions& options);

}  // namespace burl
