#pragma once
// Charts and seams: the connected pieces of surface in the texture (Levy, Petitjean, Ray, Maillot,
// "Least Squares Conformal Maps", 2002, for the term), and how much of the mesh's edges they cut.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/solid/mesh_edges.h"

namespace burl {

struct ChartMetrics {
    std::vector<std::uint32_t> of_triangle;  ///< chart number, 0-based, by first triangle
    std::uint32_t count = 0;                 ///< all charts
    std::uint32_t with_area = 0;             ///< charts with at least one triangle that has area
    double seam_length = 0.0;    ///< length of interior edges whose places differ, mesh units
    double seam_share = 0.0;     ///< of the length of all interior edges; 0 without any
    double vertex_ratio = 0.0;   ///< vertices an exported mesh needs over the mesh's points
    std::uint64_t vertices = 0;  ///< distinct pairs of point and place
};

/// A chart is a component of triangles joined across edges with equal places in the texture.
ChartMetrics measure_charts(const Mesh& mesh, const Atlas& atlas, std::span<const MeshEdge> edges);

}  // namespace burl
