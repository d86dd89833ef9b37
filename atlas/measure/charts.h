#pragma once
// Charts and seams: the connected pieces of surface in the texture (Levy, Petitjean, Ray, Maillot,
// "Least Squares Conformal Maps", 2002, for the term), the share of the mesh's edges that they cut,
// and the edges with their two sides.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/solid/atlas.h"

namespace burl {

/// One triangle's side of an edge: its corners (0..2) at the edge's two ends.
struct EdgeSide {
    std::uint32_t triangle = 0;
    std::array<std::uint8_t, 2> corners{};
};

/// An edge of the mesh with one or two sides.
struct MeshEdge {
    /// The sides of the edge, with the end points in the same order; `second` only if interior.
    EdgeSide first, second;
    bool interior = false;
};

/// Every edge once, ordered by triangle and edge number of its first side.
std::vector<MeshEdge> mesh_edges(const Mesh& mesh, const Connectivity& connectivity);

/// Whether the texture goes on across an interior edge: both ends have equal places on both sides.
bool joined(const Atlas& atlas, const MeshEdge& edge);

/// Length of the edge in mesh units.
double edge_length(const Mesh& mesh, const MeshEdge& edge);

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
