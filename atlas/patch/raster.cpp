// Rasterising the patch atlas: the spans of every block in parallel, then all of them sorted into
// rows. The result is large, and so takes no more memory than it needs.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <tbb/parallel_for.h>

#include "atlas/base/image.h"
#include "atlas/patch/atlas.h"
#include "atlas/patch/block_gutters.h"
#include "atlas/solid/texel_rows.h"

namespace burl {
namespace {

constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

/// The affine map that takes three places to points, anchored at a texel of the block.
TexelMap map_in_block(const std::array<Vec2d, 3>& places, const std::array<Vec3d, 3>& points,
                      const PatchBlock& block) {
    return affine_map(places, points, {block.x, block.y}, {block.width, block.height});
}

/// Calls visit(first, count, owner) for the runs of a row of owners.
template <class Visit>
void visit_runs(std::span<const std::uint32_t> owners, const Visit& visit) {
    for (std::size_t i = 0; i < owners.size();) {
        const std::size_t first = i;
        while (i < owners.size() && owners[i] == owners[first]) ++i;
        visit(std::uint32_t(first), std::uint32_t(i - first), owners[first]);
    }
}

/// Calls visit(row, first texel, count) for the block's texels that are in no run; the runs are
/// ordered by row and x.
template <class Visit>
void visit_plane(const PatchBlock& b, std::span<const GutterRun> runs, const Visit& visit) {
    auto run = runs.begin();
    for (std::uint32_t y = b.y; y < b.y + b.height; ++y) {
        std::uint32_t x = b.x;
        for (; run != runs.end() && run->y == y; ++run) {
            if (run->x > x) visit(y, x, run->x - x);
            x = run->x + run->count;
        }
        if (x < b.x + b.width) visit(y, x, b.x + b.width - x);
    }
}

/// A span of row y.
struct RowSpan {
    std::uint32_t y = 0;
    Span span{};
};

/// The spans of one block. Maps of `inner` from the number of the mesh's triangles on are the
/// patch's own: its plane, or the fans of its holes.
struct BlockSpans {
    std::vector<RowSpan> inner;
    Gutter gutter;
};

/// Makes the spans and maps of an atlas's blocks.
class Rasterizer {
  public:
    Rasterizer(const PatchAtlas& atlas, std::span<const Vec3d> positions)
        : atlas_(atlas), positions_(positions), hubs_(atlas.hubs, Vec4d(0.0)) {}

    SolidAtlas run() {
        solid_.size = atlas_.atlas.options.size;
        sort_triangles();
        find_spans();
        count_spans();
        map_mesh_triangles();
        for (std::size_t p = 0; p < atlas_.patches.size(); ++p) fill_block(p);
        for (std::size_t y = 0; y < solid_.size; ++y)
            std::sort(solid_.spans.begin() + std::ptrdiff_t(solid_.row_begin[y]),
                      solid_.spans.begin() + std::ptrdiff_t(solid_.row_begin[y + 1]),
                      [](const Span& a, const Span& b) { return a.x < b.x; });
        return std::move(solid_);
    }

  private:
    void sort_triangles() {
        const auto count = std::uint32_t(atlas_.atlas.corners.size());
        first_.assign(atlas_.patches.size() + 1, 0);
        for (std::uint32_t t = 0; t < count; ++t)
            if (const std::uint32_t p = atlas_.patch_of(t); p != not_in_mesh) ++first_[p + 1];
        for (std::size_t p = 1; p < first_.size(); ++p) first_[p] += first_[p - 1];
        triangles_.resize(first_.back());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (std::uint32_t t = 0; t < count; ++t)
            if (const std::uint32_t p = atlas_.patch_of(t); p != not_in_mesh)
                triangles_[next[p]++] = t;
    }

    void find_spans() {
        const Mesh& mesh = atlas_.refined.mesh;
        const ChartedMesh charted{mesh.triangles, positions_, atlas_.atlas.corners,
                                  atlas_.atlas.charts};
        const EdgeNeighbours neighbours(mesh.triangles, positions_);
        blocks_.resize(atlas_.patches.size());
        tbb::parallel_for(std::size_t(0), blocks_.size(), [&](std::size_t p) {
            const PatchBlock& block = atlas_.layout.blocks[p];
            const std::span<const std::uint32_t> own = triangles_of(p);
            blocks_[p] =
                atlas_.patches[p].plane
                    ? plane_spans(block,
                                  plane_gutter(charted, neighbours, own, block, plane_map(p)))
                    : BlockSpans{inner_spans(p), rectangle_gutter(charted, neighbours, own, block)};
        });
    }

    std::uint32_t mesh_maps() const {
        return static_cast<std::uint32_t>(atlas_.atlas.corners.size());
    }

    std::span<const std::uint32_t> triangles_of(std::size_t p) const {
        return {triangles_.data() + first_[p], first_[p + 1] - first_[p]};
    }

    BlockSpans plane_spans(const PatchBlock& block, Gutter gutter) const {
        BlockSpans spans;
        visit_plane(block, gutter.runs, [&](std::uint32_t y, std::uint32_t x, std::uint32_t count) {
            spans.inner.push_back({y, {x, count, mesh_maps()}});
        });
        spans.gutter = std::move(gutter);
        return spans;
    }

    std::vector<RowSpan> inner_spans(std::size_t p) const {
        const PatchBlock& b = atlas_.layout.blocks[p];
        const std::uint32_t x = b.x + b.gutter, y = b.y + b.gutter;
        const Image<std::uint32_t> inner = inner_owners(p);
        std::vector<RowSpan> spans;
        for (std::uint32_t row = 0; row < inner.height(); ++row)
            visit_runs(inner.row(row), [&](std::uint32_t first, std::uint32_t count, auto owner) {
                spans.push_back({y + row, {x + first, count, owner}});
            });
        return spans;
    }

    /// Sets the begins of all rows, and makes room for spans and maps.
    void count_spans() {
        std::vector<std::size_t> counts(solid_.size, 0);
        std::size_t more_maps = 0;
        for (std::size_t p = 0; p < blocks_.size(); ++p) {
            more_maps += atlas_.patches[p].plane ? 1 : atlas_.patches[p].fans.size();
            more_maps += blocks_[p].gutter.maps.size();
            for (const RowSpan& span : blocks_[p].inner) ++counts[span.y];
            for (const GutterRun& run : blocks_[p].gutter.runs) ++counts[run.y];
        }
        solid_.row_begin.reserve(solid_.size + 1);
        solid_.row_begin.push_back(0);
        for (const std::size_t count : counts)
            solid_.row_begin.push_back(solid_.row_begin.back() + count);
        solid_.spans.resize(solid_.row_begin.back());
        filled_.assign(solid_.row_begin.begin(), solid_.row_begin.end() - 1);
        solid_.maps.reserve(mesh_maps() + more_maps);
        solid_.turned.reserve(more_maps);
    }

    void map_mesh_triangles() {
        const std::vector<Triangle>& triangles = atlas_.refined.mesh.triangles;
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            const auto& [a, b, c] = triangles[t];
            const std::array<Vec3d, 3> points{positions_[a], positions_[b], positions_[c]};
            const std::uint32_t p = atlas_.patch_of(t);
            if (p == not_in_mesh)
                solid_.maps.push_back({points[0], Vec3d(0.0), Vec3d(0.0), 0, 0});
            else
                solid_.maps.push_back(
                    map_in_block(atlas_.atlas.corners[t], points, atlas_.layout.blocks[p]));
        }
    }

    void add_span(std::uint32_t y, const Span& span) { solid_.spans[filled_[y]++] = span; }

    /// Adds a map beyond the triangles' own, which belongs to `triangle`; returns its number.
    std::uint32_t add_map(const TexelMap& map, std::uint32_t triangle) {
        solid_.maps.push_back(map);
        solid_.turned.push_back(triangle);
        return static_cast<std::uint32_t>(solid_.maps.size() - 1);
    }

    /// Adds maps of the triangles that close the patch's holes; their hub is the hole's centroid.
    void map_fans(std::size_t p) {
        const PlacedPatch& patch = atlas_.patches[p];
        const std::size_t known = positions_.size();
        for (const PlacedTriangle& fan : patch.fans) {
            const auto hub = std::ranges::find_if(fan.points, [&](auto v) { return v >= known; });
            if (hub == fan.points.end()) continue;
            const auto k = std::size_t(hub - fan.points.begin());
            const Vec3d rim =
                positions_[fan.points[(k + 1) % 3]] + positions_[fan.points[(k + 2) % 3]];
            hubs_[*hub - known] += Vec4d(rim, 2.0);
        }
        for (const PlacedTriangle& fan : patch.fans) {
            std::array<Vec3d, 3> at{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t v = fan.points[k];
                at[k] = v < known ? positions_[v] : Vec3d(hubs_[v - known]) / hubs_[v - known].w;
            }
            add_map(map_in_block(fan.places, at, atlas_.layout.blocks[p]), patch.triangle);
        }
    }

    /// The number of the map at each texel of the inner rectangle, as in BlockSpans::inner.
    Image<std::uint32_t> inner_owners(std::size_t p) const {
        const PatchBlock& b = atlas_.layout.blocks[p];
        const std::uint32_t columns = b.columns() + 1, rows = b.rows() + 1;
        const Vec2d low(b.x + b.gutter, b.y + b.gutter);
        const std::uint32_t reach = std::max(columns, rows);
        Image<std::uint32_t> owner(columns, rows, nobody);
        const auto show = [&](std::array<Vec2d, 3> corners, std::uint32_t map) {
            for (Vec2d& corner : corners) corner -= low;
            if (!(cross(corners[1] - corners[0], corners[2] - corners[0]) > 0.0)) return;
            visit_slices(corners, reach, 0.0, [&](std::uint32_t row, const Interval& x) {
                if (row >= rows) return;
                const TexelRun run = centres_within(x.low, x.high, columns);
                for (std::uint32_t& texel : owner.row(row).subspan(run.first, run.count))
                    texel = std::min(texel, map);
            });
        };
        for (const std::uint32_t t : triangles_of(p)) show(atlas_.atlas.corners[t], t);
        std::uint32_t fan_map = mesh_maps();
        for (const PlacedTriangle& fan : atlas_.patches[p].fans) show(fan.places, fan_map++);
        fill_missed(owner);
        return owner;
    }

    /// Gives texel centres on the border that rounding left to nobody to the nearest owner in their
    /// row, or else to the owner in the row before or after.
    static void fill_missed(Image<std::uint32_t>& owner) {
        const auto fill = [](auto begin, auto end) {
            std::uint32_t last = nobody;
            for (auto i = begin; i != end; ++i) *i == nobody ? *i = last : last = *i;
        };
        for (std::size_t y = 0; y < owner.height(); ++y) {
            const auto row = owner.row(y);
            fill(row.begin(), row.end());
            fill(row.rbegin(), row.rend());
        }
        for (std::size_t y = 1; y < owner.height(); ++y)
            if (owner.row(y)[0] == nobody)
                std::copy(owner.row(y - 1).begin(), owner.row(y - 1).end(), owner.row(y).begin());
        for (std::size_t y = owner.height() - 1; y-- > 0;)
            if (owner.row(y)[0] == nobody)
                std::copy(owner.row(y + 1).begin(), owner.row(y + 1).end(), owner.row(y).begin());
    }

    std::uint32_t next_map() const { return static_cast<std::uint32_t>(solid_.maps.size()); }

    void fill_block(std::size_t p) {
        const BlockSpans block = std::move(blocks_[p]);
        const std::uint32_t first_own = next_map();
        if (atlas_.patches[p].plane)
            add_map(plane_map(p), atlas_.patches[p].triangle);
        else
            map_fans(p);
        for (auto [y, span] : block.inner) {
            if (span.map >= mesh_maps()) span.map += first_own - mesh_maps();
            add_span(y, span);
        }
        const std::uint32_t first = next_map();
        for (std::size_t i = 0; i < block.gutter.maps.size(); ++i)
            add_map(block.gutter.maps[i], block.gutter.triangles[i]);
        for (const GutterRun& run : block.gutter.runs)
            add_span(run.y, {run.x, run.count, first + run.map});
    }

    TexelMap plane_map(std::size_t p) const {
        const PlacedTriangle& plane = *atlas_.patches[p].plane;
        const auto& [a, b, c] = plane.points;
        return map_in_block(plane.places, {positions_[a], positions_[b], positions_[c]},
                            atlas_.layout.blocks[p]);
    }

    const PatchAtlas& atlas_;
    std::span<const Vec3d> positions_;
    std::vector<Vec4d> hubs_;  ///< sum of the points on each hub's rim (xyz), and their number (w)
    SolidAtlas solid_;
    std::vector<BlockSpans> blocks_;                ///< spans of each patch's block
    std::vector<std::size_t> filled_;               ///< place of the next span of each row
    std::vector<std::uint32_t> first_, triangles_;  ///< triangles sorted by patch
};

}  // namespace

SolidAtlas rasterize_patches(const PatchAtlas& atlas, std::span<const Vec3d> positions) {
    return Rasterizer(atlas, positions).run();
}

}  // namespace burl
