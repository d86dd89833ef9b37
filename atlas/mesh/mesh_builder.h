#pragma once
// From a file's polygons to the Mesh every stage works on: triangulate, weld, renumber, count.
#include "atlas/mesh/mesh.h"
#include "atlas/mesh/polygon_soup.h"
#include "atlas/mesh/read_options.h"

namespace burl {

/// Area up to this times the squared longest side of the box counts as none: what double rounding
/// can leave of a triangle on a line, far below any triangle a float file can hold on purpose.
inline constexpr double zero_area = 0x1p-50;

/// Per corner 3t+k of the triangles that build_mesh() makes, the soup's corner it is; empty where
/// they are the soup's own in order. The soup must have faces.
std::vector<std::uint32_t> corners_of_triangles(PolygonSoup& soup);

/// Makes the mesh: polygons triangulated, points welded and numbered by first use, every face kept
/// in file order, attributes carried to corners (normals made unit; a missing or zero one becomes
/// the face's own, a missing colour white, a missing uv 0), and everything counted in `notes`.
/// `path` gives the mesh its name and messages their file. Throws Error(invalid_file) for a soup
/// without faces or beyond largest_triangle_count.
Mesh build_mesh(PolygonSoup&& soup, const std::string& path, const ReadOptions& options = {});

}  // namespace burl
