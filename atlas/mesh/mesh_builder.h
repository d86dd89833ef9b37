#pragma once
// Conversion of a file's polygons to the Mesh that every stage works on: triangulate, weld,
// renumber, count.
#include <stop_token>
#include <string>
#include <vector>

#include "atlas/mesh/mesh.h"
#include "atlas/mesh/polygon_soup.h"

namespace burl {

/// Largest area, as a share of the squared longest side of the bounding box, that counts as none:
/// what double rounding can leave of a triangle on a line, far below any triangle a float file can
/// hold on purpose.
inline constexpr double zero_area = 0x1p-50;

/// The soup's corner for each corner 3t+k of the triangles that build_mesh() makes; empty where
/// these are the soup's own faces in order. The soup must have faces.
std::vector<std::uint32_t> corners_of_triangles(PolygonSoup& soup);

/// Makes the mesh: polygons triangulated, points welded and numbered by first use, every face kept
/// in file order, attributes carried to corners (normals made unit; a missing or zero one becomes
/// the face's own, a missing colour white, a missing uv 0), and everything counted in `notes`.
/// `path` gives the mesh its name and messages their file. Throws Error(invalid_file) for a soup
/// without faces or beyond largest_triangle_count, Error(unsupported) beyond
/// options.most_triangles, and Error(runtime) where `stop` is requested, which is looked at between
/// passes over the mesh.
Mesh build_mesh(PolygonSoup&& soup, const std::string& path, const ReadOptions& options = {},
                const std::stop_token& stop = {});

}  // namespace burl
