#pragma once
// Charts and seams: the connected pieces of surface in the texture (Levy, Petitjean, Ray, Maillot,
// "Least Squares Conformal Maps", 2002, for the term), and the share of the mesh's edges that they
// cut.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/solid/mesh_edges.h"

namespace burl {

/// Measures of an atlas's charts.
struct ChartMetrics {
    std::vector<std::uint32_t> of_triangle;  ///< chart of each triangle, by first triangle
    std::uint32_t count = 0;                 ///< number of charts
    std::uint32_t with_area = 0;             ///< charts with at least one triangle that has area
    /// Length, in mesh units, of the interior edges whose two sides have different places.
    double seam_length = 0.0;
    double seam_share = 0.0;     ///< seam_length over the length of all interior edges, or 0
    double vertex_ratio = 0.0;   ///< vertices that an exported mesh needs over the mesh's points
    std::uint64_t vertices = 0;  ///< vertices needed: distinct pairs of point and place
};

/// Measures the charts: a chart is a component of triangles joined across edges with equal places
/// in the texture.
ChartMetrics measure_charts(const Mesh& mesh, const Atlas& atlas, std::span<const MeshEdge> edges);

}  // namespace burl
