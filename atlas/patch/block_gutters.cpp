#include "atlas/patch/block_gutters.h"

#include <algorithm>
#include <numbers>

#include "atlas/base/image.h"
#include "atlas/solid/texel_rows.h"

namespace burl {
namespace {

/// Distance from a planar patch's border, in texels, within which bilinear lookups may read.
constexpr double lookup_reach = 1.5;
/// Gutters beyond a planar patch's border that are filled along the surface; farther out the plane
/// goes on.
constexpr double filled_gutters = 2.0;

TexelBox box_of(const PatchBlock& b) {
    return {b.x, b.y, b.width, b.height};
}

/// The rectangle's border edges.
std::vector<ChartEdge> edges_on_sides(const ChartedMesh& mesh,
                                      std::span<const std::uint32_t> triangles,
                                      const PatchBlock& b) {
    const Vec2d low(b.x + b.gutter + 0.5, b.y + b.gutter + 0.5);
    const Vec2d high = low + Vec2d(b.columns(), b.rows());
    std::vector<ChartEdge> edges;
    for (const std::uint32_t t : triangles)
        for (std::uint32_t edge = 3 * t; edge < 3 * t + 3; ++edge) {
            const ChartEdge found = chart_edge(mesh, edge);
            const auto& [a, c] = std::pair(found.a, found.b);
            const bool upright = a.x == c.x && (a.x == low.x || a.x == high.x);
            const bool level = a.y == c.y && (a.y == low.y || a.y == high.y);
            if (upright != level) edges.push_back(found);
        }
    return edges;
}

/// The texels of the block outside its rectangle.
std::vector<TexelGap> gaps_of_rectangle(const PatchBlock& b) {
    std::vector<TexelGap> gaps;
    for (std::uint32_t y = b.y; y < b.y + b.height; ++y) {
        if (y < b.y + b.gutter || y > b.y + b.gutter + b.rows()) {
            gaps.push_back({y, b.x, b.width});
            continue;
        }
        gaps.push_back({y, b.x, b.gutter});
        gaps.push_back({y, b.x + b.width - b.gutter, b.gutter});
    }
    return gaps;
}

/// The texels of the block whose centres no triangle of the patch covers.
std::vector<TexelGap> gaps_of_outline(const ChartedMesh& mesh,
                                      std::span<const std::uint32_t> triangles,
                                      const PatchBlock& b) {
    Image<std::uint8_t> covered(b.width, b.height, 0);
    for (const std::uint32_t t : triangles) {
        std::array<Vec2d, 3> corners = mesh.corners[t];
        for (Vec2d& corner : corners) corner -= Vec2d(b.x, b.y);
        visit_slices(corners, b.height, 0.0, [&](std::uint32_t row, const Interval& x) {
            const TexelRun run = centres_within(x.low, x.high, b.width);
            std::ranges::fill(covered.row(row).subspan(run.first, run.count), std::uint8_t(1));
        });
    }
    std::vector<TexelGap> gaps;
    for (std::uint32_t y = 0; y < b.height; ++y) {
        const auto row = covered.row(y);
        for (auto i = row.begin(); i != row.end();) {
            const auto begin = std::find(i, row.end(), std::uint8_t(0));
            i = std::find(begin, row.end(), std::uint8_t(1));
            if (begin != i)
                gaps.push_back(
                    {b.y + y, b.x + std::uint32_t(begin - row.begin()), std::uint32_t(i - begin)});
        }
    }
    return gaps;
}

}  // namespace

Gutter rectangle_gutter(const ChartedMesh& mesh, const EdgeNeighbours& neighbours,
                        std::span<const std::uint32_t> triangles, const PatchBlock& block) {
    if (block.gutter == 0) return {};
    // The corners are farthest away.
    const double reach = block.gutter * std::numbers::sqrt2 + 0.5;
    return fill_gutter(mesh, neighbours, edges_on_sides(mesh, triangles, block),
                       gaps_of_rectangle(block), box_of(block),
                       {.reach = reach, .at_open_edge = AtOpenEdge::mirror});
}

Gutter plane_gutter(const ChartedMesh& mesh, const EdgeNeighbours& neighbours,
                    std::span<const std::uint32_t> triangles, const PatchBlock& block,
                    const TexelMap& plane) {
    Gutter gutter = fill_gutter(mesh, neighbours, chart_edges(mesh, neighbours, triangles),
                                gaps_of_outline(mesh, triangles, block), box_of(block),
                                {.reach = filled_gutters * block.gutter,
                                 .own_plane = lookup_reach,
                                 .at_open_edge = AtOpenEdge::mirror});
    std::erase_if(gutter.runs, [&](const GutterRun& run) {
        const TexelMap& map = gutter.maps[run.map];
        return same_point(map, plane, run.x, run.y) &&
               same_point(map, plane, run.x + run.count - 1, run.y);
    });
    return gutter;
}

}  // namespace burl
