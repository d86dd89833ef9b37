#pragma once
// Which triangles lie together in a block: neighbours of similar weight, matched across the edge
// that becomes the block's diagonal. A pair laid so needs no overscan (Carr & Hart 2001, section
// 4.1). Half-edge h = 3 t + k runs from corner k of triangle t to corner (k+1)%3.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// Per half-edge the one on the other side of it, running the other way; -1 at borders and where
/// two triangles disagree about the surface's orientation.
std::vector<std::int32_t> opposite_half_edges(const Mesh& mesh, const Connectivity& connectivity);

inline constexpr std::uint32_t never_pair = UINT32_MAX;

/// Per triangle the edge (0..2) across which its partner lies, or -1 for a single. `keys` are per
/// half-edge, the same on both sides: pairs of low key are made first, those of key never_pair
/// never.
std::vector<std::int8_t> match_triangles(std::span<const std::int32_t> opposite,
                                         std::span<const std::uint32_t> keys);

/// Per triangle the edge (0..2) across which its partner lies, or -1 for a single. Partners'
/// weights differ by at most a factor of `most_ratio`; triangles of weight 0 stay single.
std::vector<std::int8_t> pair_triangles(const Mesh& mesh, std::span<const std::int32_t> opposite,
                                        std::span<const float> weights, double most_ratio);

}  // namespace burl
