#pragma once
// The atlas of a mesh's own texture coordinates, as an artist or another program unwrapped them:
// corners are the coordinates times the texture's size, charts what hangs together in them.
#include <cstdint>
#include <vector>

#include "atlas/solid/atlas.h"

namespace burl {

/// Largest distance in texture coordinates by which a chart may leave its tile.
inline constexpr double uv_slack = 1e-4;

/// The number of a UDIM tile: 1001 for [0, 1] x [0, 1], one more for each column, ten more for each
/// row upwards (OBJ's direction of v).
constexpr std::uint32_t udim_number(std::int64_t column, std::int64_t row) {
    return static_cast<std::uint32_t>(1001 + column + 10 * row);
}

/// The numbers of the UDIM tiles that charts with area lie in, ascending. Throws Error(usage)
/// without texture coordinates; Error(runtime) for a chart that lies in no single tile: its
/// coordinates run across tiles' borders, or beyond the ten columns and 900 rows of UDIM.
std::vector<std::uint32_t> udim_tiles(const Mesh& mesh, const Connectivity& connectivity);

/// The atlas of the mesh's texture coordinates; v = 0 is the edge of row 0. Triangles belong to one
/// chart where both ends of their common edge have equal coordinates. Triangles of tiles other than
/// options.tile lie outside of the texture. Throws Error as udim_tiles() does; and Error(runtime)
/// where options.tile is 0 and charts lie in other tiles than 1001, or where several triangles
/// claim a texel (its centre is inside of both by more than 1e-6 texels) and options.overlap
/// refuses that. Counts stand in the notes.
Atlas layout_uvs(const Mesh& mesh, const Connectivity& connectivity, const AtlasOptions& options);

}  // namespace burl
