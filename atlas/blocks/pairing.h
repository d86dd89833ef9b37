#pragma once
// Pairing of triangles: neighbours of similar weight are matched across the edge that becomes their
// block's diagonal. Such a pair needs no overscan (Carr & Hart 2001, section 4.1). Half-edge h = 3
// t + k runs from corner k of triangle t to corner (k+1)%3.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// The opposite of each half-edge, which runs the other way in the triangle beyond the edge; -1 at
/// borders and where two triangles disagree about the surface's orientation.
std::vector<std::int32_t> opposite_half_edges(const Mesh& mesh, const Connectivity& connectivity);

/// Key of half-edges across which triangles are never paired.
inline constexpr std::uint32_t never_pair = UINT32_MAX;

/// The edge (0..2) of each triangle across which its partner lies, or -1 for a single triangle.
/// `keys` holds a key for each half-edge, equal for opposite ones: pairs of low key are made first,
/// pairs of key never_pair never.
std::vector<std::int8_t> match_triangles(std::span<const std::int32_t> opposite,
                                         std::span<const std::uint32_t> keys);

/// The edge (0..2) of each triangle across which its partner lies, or -1 for a single triangle, by
/// likeness of weights and length of the common edge. Partners' weights differ by at most a factor
/// of `most_ratio`; triangles of weight 0 stay single.
std::vector<std::int8_t> pair_triangles(const Mesh& mesh, std::span<const std::int32_t> opposite,
                                        std::span<const float> weights, double most_ratio);

}  // namespace burl
