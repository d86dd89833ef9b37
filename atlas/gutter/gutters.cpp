#include "atlas/gutter/gutters.h"

#include <algorithm>

namespace burl {
namespace {

constexpr std::uint32_t no_map = 0xffffffffu;
/// Unfolded triangles that one filling keeps (96 bytes each): this many, and as many for each of
/// its texels and edges. Scans of a million triangles need 5 for each; walks that lead round and
/// round in shells far below a texel would need hundreds.
constexpr std::size_t most_unfolded = 1 << 18, most_unfolded_each = 16;

/// Fills the texels of gaps, row by row.
class GutterFiller {
  public:
    GutterFiller(const ChartedMesh& mesh, const EdgeNeighbours& neighbours,
                 std::span<const ChartEdge> edges, std::size_t texels, const TexelBox& box,
                 const GutterOptions& options)
        : mesh_(mesh),
          edges_(edges),
          box_(box),
          options_(options),
          unfolding_(mesh.triangles, mesh.positions, neighbours, options.at_open_edge,
                     options.longest_walk,
                     most_unfolded + most_unfolded_each * (texels + edges.size())),
          first_tile_(edges.size(), no_edge) {}

    /// Fills a gap; `nearest` are the numbers of its texels' edges.
    void fill(const TexelGap& gap, std::span<const std::uint32_t> nearest) {
        std::uint32_t run_tile = no_edge;
        for (std::uint32_t i = 0; i < gap.count; ++i) {
            const std::uint32_t x = gap.x + i;
            const std::uint32_t tile =
                nearest[i] == no_edge ? no_edge : tile_at(nearest[i], {x + 0.5, gap.y + 0.5});
            if (tile == no_edge) {
                run_tile = no_edge;
                continue;
            }
            if (run_tile != no_edge && (tile == run_tile || joins(tile, x, gap.y))) {
                ++gutter_.runs.back().count;
                continue;
            }
            gutter_.runs.push_back({gap.y, x, 1, map_of(tile)});
            run_tile = tile;
        }
    }

    Gutter take() { return std::move(gutter_); }

  private:
    /// The unfolded triangle that the texel centre q shows, or no_edge.
    std::uint32_t tile_at(std::uint32_t edge, const Vec2d& q) {
        const ChartEdge& border = edges_[edge];
        std::uint32_t& first = first_tile_[edge];
        if (first == no_edge) first = unfolding_.begin(border.edge, mesh_.corners[border.edge / 3]);
        const Vec2d from = border.nearest(q);
        if (glm::distance(from, q) <= options_.own_plane) return first;
        const Walk walk = unfolding_.walk(first, from, q);
        return walk.arrived || !options_.leaves_open ? walk.tile : no_edge;
    }

    /// Whether the last run may go on with a texel of another tile.
    bool joins(std::uint32_t tile, std::uint32_t x, std::uint32_t y) const {
        const std::uint32_t map = gutter_.runs.back().map;
        if (gutter_.triangles[map] != unfolding_.origin(tile) / 3) return false;
        return same_point(gutter_.maps[map], made_map(tile), x, y);
    }

    std::uint32_t map_of(std::uint32_t tile) {
        if (tile >= map_of_tile_.size()) map_of_tile_.resize(unfolding_.size(), no_map);
        std::uint32_t& map = map_of_tile_[tile];
        if (map != no_map) return map;
        map = static_cast<std::uint32_t>(gutter_.maps.size());
        gutter_.maps.push_back(made_map(tile));
        gutter_.triangles.push_back(unfolding_.origin(tile) / 3);
        return map;
    }

    TexelMap made_map(std::uint32_t tile) const {
        const UnfoldedTriangle unfolded = unfolding_.unfolded(tile);
        const auto& [a, b, c] = mesh_.triangles[unfolded.triangle];
        return affine_map(unfolded.places,
                          {mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]},
                          {box_.x, box_.y}, {box_.width, box_.height});
    }

    const ChartedMesh& mesh_;
    std::span<const ChartEdge> edges_;
    TexelBox box_;
    GutterOptions options_;
    Unfolding unfolding_;
    std::vector<std::uint32_t> first_tile_;   ///< first tile of each edge
    std::vector<std::uint32_t> map_of_tile_;  ///< no_map for tiles without a run
    Gutter gutter_;
};

}  // namespace

bool same_point(const TexelMap& a, const TexelMap& b, std::uint32_t x, std::uint32_t y) {
    constexpr double least_steps = 1e-6;
    const Vec3d apart = a(x, y) - b(x, y);
    const double step = glm::dot(a.step_x, a.step_x) + glm::dot(a.step_y, a.step_y);
    return glm::dot(apart, apart) <= least_steps * least_steps * step;
}

Gutter fill_gutter(const ChartedMesh& mesh, const EdgeNeighbours& neighbours,
                   std::span<const ChartEdge> edges, std::span<const TexelGap> gaps,
                   const TexelBox& box, const GutterOptions& options) {
    return fill_gutter(mesh, neighbours, edges, gaps, nearest_edges(edges, gaps, options.reach),
                       box, options);
}

Gutter fill_gutter(const ChartedMesh& mesh, const EdgeNeighbours& neighbours,
                   std::span<const ChartEdge> edges, std::span<const TexelGap> gaps,
                   std::span<const std::uint32_t> nearest, const TexelBox& box,
                   const GutterOptions& options) {
    const auto near = nearest.size() - std::size_t(std::ranges::count(nearest, no_edge));
    GutterFiller filler(mesh, neighbours, edges, near, box, options);
    std::size_t first = 0;
    for (const TexelGap& gap : gaps) {
        filler.fill(gap, nearest.subspan(first, gap.count));
        first += gap.count;
    }
    return filler.take();
}

}  // namespace burl
