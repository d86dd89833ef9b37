#pragma once
// Nets of surfaces made of flat and singly curved pieces, as machines' parts are: triangles are
// joined across their edges without any distortion, the flattest edges first, as paper models are
// (Mitani & Suzuki, "Making papercraft toys from meshes using strip-based approximate unfolding",
// 2004), as long as nothing overlaps and the box round a piece grows by little more than its
// surface.
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh.h"
#include "atlas/outline/flat_chart.h"

namespace burl {

/// Triangles of the largest surface that is unfolded: the time grows with their square.
inline constexpr std::size_t most_unfolded = 4000;

/// Limits of nets.
struct NetOptions {
    std::size_t most = 8;  ///< most charts
    /// Longest sides of the boxes round triangles that are joined in their plane, and out of it.
    double longest_flat = std::numeric_limits<double>::infinity();
    double longest = std::numeric_limits<double>::infinity();
    /// Distance up to which borders of different places of the surface may not lie along each
    /// other in a chart.
    double gap = 0.0;
};

/// The charts of a surface's triangles, exact up to rounding; nothing where one has no area, there
/// would be too many charts, or smooth edges would be cut along more than the charts' own
/// perimeters. Neighbours that are not among `faces` do not count.
std::optional<std::vector<FlatChart>> unfold(const Mesh& mesh, const Connectivity& connectivity,
                                             std::span<const std::uint32_t> faces,
                                             const NetOptions& options = {});

}  // namespace burl
