#include "atlas/outline/raster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "atlas/base/each_index.h"
#include "atlas/base/image.h"
#include "atlas/gutter/gutters.h"
#include "atlas/outline/pack.h"
#include "atlas/solid/texel_rows.h"

namespace burl {
namespace {

constexpr std::uint32_t nobody = no_owner;
constexpr std::uint32_t band_rows = 64;  ///< rows of a band
/// Share of the texture's side up to which texels beside charts show what a walk over the mesh
/// reaches.
constexpr std::uint32_t walked_share = 32, least_walked = 8;
/// Sides of a mean triangle up to which they do, but at least over a cell, which levels without
/// mixtures of charts average: a walk's time is in the triangles that it crosses, so that of all
/// texels would grow with the root of the triangles' number.
constexpr double walked_triangles = 16.0;
/// Triangles of a walk there: slivers meet by the thousand at the poles of a globe.
constexpr int longest_short_walk = 128;
/// Distance from a border, in texels, within which bilinear lookups of the chart may read.
constexpr double own_plane = 1.5;

/// A cell beside charts that shows a triangle near by.
struct FarCell {
    std::uint32_t x = 0, y = 0, triangle = 0;
    bool operator==(const FarCell&) const = default;
};

/// The spans of a band's rows. Maps from the number of the mesh's triangles on are the gutter's,
/// and after those come those of `cells`.
struct BandSpans {
    std::vector<Span> spans;
    std::vector<std::size_t> row_end;  ///< end of each row in spans
    Gutter gutter;
    std::vector<FarCell> cells;
};

/// For each cell of a grid the triangle that stands for it: the first with its first corner there,
/// or that of the nearest such cell, counted in steps to neighbours.
class NearTriangles {
  public:
    NearTriangles(const Atlas& atlas, std::uint32_t cell)
        : cell_(cell), side_((atlas.options.size + cell - 1) / cell), near_(side_, side_, nobody) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> queue;
        for (std::uint32_t t = 0; t < atlas.corners.size(); ++t) {
            const auto& [q, b, c] = atlas.corners[t];
            if (!(cross(b - q, c - q) > 0.0)) continue;
            take(queue, std::uint32_t(q.x) / cell_, std::uint32_t(q.y) / cell_, t);
        }
        if (queue.empty()) take(queue, 0, 0, 0);  // nothing has an area in the texture
        for (std::size_t i = 0; i < queue.size(); ++i) {
            const auto [x, y] = queue[i];
            const std::uint32_t t = near_(x, y);
            take(queue, x + 1, y, t);
            take(queue, x, y + 1, t);
            if (x > 0) take(queue, x - 1, y, t);
            if (y > 0) take(queue, x, y - 1, t);
        }
    }

    /// The cell of texel (x, y).
    FarCell at(std::uint32_t x, std::uint32_t y) const {
        return {x / cell_, y / cell_, near_(x / cell_, y / cell_)};
    }
    /// The map that shows a triangle's first corner in the middle of the cell, and from there goes
    /// on as the triangle's own.
    TexelMap map_of(const FarCell& cell, const TexelMap& own, const Vec3d& corner) const {
        const auto middle = [&](std::uint32_t at) { return std::int32_t(at * cell_ + cell_ / 2); };
        return {corner, own.step_x, own.step_y, middle(cell.x), middle(cell.y)};
    }
    std::uint32_t end_of_cell(std::uint32_t x) const { return (x / cell_ + 1) * cell_; }

  private:
    void take(std::vector<std::pair<std::uint32_t, std::uint32_t>>& queue, std::uint32_t x,
              std::uint32_t y, std::uint32_t triangle) {
        if (x >= side_ || y >= side_ || near_(x, y) != nobody) return;
        near_(x, y) = triangle;
        queue.emplace_back(x, y);
    }

    std::uint32_t cell_, side_;
    Image<std::uint32_t> near_;
};

std::uint32_t most_walked(std::uint32_t size) {
    return std::max(size / walked_share, least_walked);
}

/// The distance from a border in texels up to which texels show what a walk reaches.
std::uint32_t walked_texels(const Atlas& atlas) {
    const std::uint32_t size = atlas.options.size;
    const std::uint32_t most = most_walked(size);
    double area = 0.0;
    std::size_t count = 0;
    for (const auto& [a, b, c] : atlas.corners) {
        const double twice = std::abs(cross(b - a, c - a));
        area += 0.5 * twice;
        if (twice > 0.0) ++count;
    }
    if (count == 0) return most;
    const double side = std::sqrt(2.0 * area / double(count));
    const std::uint32_t least = std::min(std::max(outline_cell(size), least_walked), most);
    return std::uint32_t(
        std::clamp(std::ceil(walked_triangles * side), double(least), double(most)));
}

/// Fills bands of rows.
class BandFiller {
  public:
    BandFiller(const Mesh& mesh, const Atlas& atlas, std::span<const Vec3d> positions)
        : atlas_(atlas),
          charted_{mesh.triangles, positions, atlas.corners, atlas.charts},
          neighbours_(mesh.triangles, positions),
          near_(atlas, outline_cell(size())),
          reach_(walked_texels(atlas)),
          triangles_(bands()),
          edges_(bands()) {
        std::vector<std::uint32_t> all(mesh.triangles.size());
        for (std::uint32_t t = 0; t < all.size(); ++t) {
            all[t] = t;
            Interval y;
            for (const Vec2d& corner : atlas.corners[t]) y.add(corner.y);
            add_to_bands(triangles_, y, t);
        }
        for (const ChartEdge& edge : chart_edges(charted_, neighbours_, all)) {
            Interval y;
            y.add(std::min(edge.a.y, edge.b.y) - reach_);
            y.add(std::max(edge.a.y, edge.b.y) + reach_);
            add_to_bands(edges_, y, edge);
        }
    }

    std::uint32_t size() const { return atlas_.options.size; }
    std::uint32_t bands() const { return (size() + band_rows - 1) / band_rows; }

    const NearTriangles& near() const { return near_; }

    BandSpans fill(std::uint32_t band) const {
        const std::uint32_t first = band * band_rows;
        const Image<std::uint32_t> owner = owners(band, first, std::min(band_rows, size() - first));
        BandSpans result;
        result.gutter = fill_gutter(
            charted_, neighbours_, edges_[band], gaps_between(owner, first), {0, 0, size(), size()},
            {.reach = double(reach_),
             .own_plane = own_plane,
             .at_open_edge = AtOpenEdge::mirror,
             .longest_walk = reach_ < most_walked(size()) ? longest_short_walk : longest_walk});
        auto run = result.gutter.runs.begin();
        for (std::uint32_t y = 0; y < owner.height(); ++y) {
            for (std::uint32_t x = 0; x < size();) {
                std::uint32_t end = x + 1;
                if (owner(x, y) != nobody) {
                    while (end < size() && owner(end, y) == owner(x, y)) ++end;
                    result.spans.push_back({x, end - x, owner(x, y)});
                } else if (run != result.gutter.runs.end() && run->y == first + y && run->x == x) {
                    end = x + run->count;
                    result.spans.push_back({x, run->count, triangles() + run->map});
                    ++run;
                } else {
                    while (
                        end < near_.end_of_cell(x) && end < size() && owner(end, y) == nobody &&
                        !(run != result.gutter.runs.end() && run->y == first + y && run->x == end))
                        ++end;
                    result.spans.push_back({x, end - x, far_map(result, x, first + y)});
                }
                x = end;
            }
            result.row_end.push_back(result.spans.size());
        }
        return result;
    }

  private:
    std::uint32_t triangles() const { return std::uint32_t(charted_.triangles.size()); }

    template <class T>
    void add_to_bands(std::vector<std::vector<T>>& bands, const Interval& y, const T& value) const {
        const double last = double(bands.size()) - 1.0;
        const auto band = [&](double at) {
            return std::size_t(std::clamp(std::floor(at / band_rows), 0.0, last));
        };
        for (std::size_t b = band(y.low); b <= band(y.high); ++b) bands[b].push_back(value);
    }

    /// The first triangle at each texel centre of the band.
    Image<std::uint32_t> owners(std::uint32_t band, std::uint32_t first, std::uint32_t rows) const {
        Image<std::uint32_t> owner(size(), rows, nobody);
        for (const std::uint32_t t : triangles_[band]) {
            std::array<Vec2d, 3> corners = atlas_.corners[t];
            if (!(cross(corners[1] - corners[0], corners[2] - corners[0]) > 0.0)) continue;
            for (Vec2d& corner : corners) corner.y -= first;
            visit_slices(corners, rows, 0.0, [&](std::uint32_t row, const Interval& x) {
                const TexelRun run = centres_within(x.low, x.high, size());
                for (std::uint32_t& texel : owner.row(row).subspan(run.first, run.count))
                    texel = std::min(texel, t);
            });
        }
        return owner;
    }

    /// The number of a map that shows a triangle near texel (x, y).
    std::uint32_t far_map(BandSpans& band, std::uint32_t x, std::uint32_t y) const {
        const FarCell cell = near_.at(x, y);
        const auto found = std::ranges::find(band.cells, cell);
        const auto number = std::uint32_t(found - band.cells.begin());
        if (found == band.cells.end()) band.cells.push_back(cell);
        return triangles() + std::uint32_t(band.gutter.maps.size()) + number;
    }

    const Atlas& atlas_;
    ChartedMesh charted_;
    EdgeNeighbours neighbours_;
    NearTriangles near_;
    std::uint32_t reach_;
    std::vector<std::vector<std::uint32_t>> triangles_;  ///< triangles that each band may show
    std::vector<std::vector<ChartEdge>> edges_;          ///< border edges within reach of each band
};

/// Appends a band's spans and maps.
void append(BandSpans band, const NearTriangles& near, const Mesh& mesh,
            std::span<const Vec3d> positions, SolidAtlas& solid) {
    const auto triangles = std::uint32_t(mesh.triangles.size());
    const auto shift = std::uint32_t(solid.maps.size()) - triangles;
    const std::size_t first = solid.spans.size();
    for (Span& span : band.spans)
        if (span.map >= triangles) span.map += shift;
    solid.spans.insert(solid.spans.end(), band.spans.begin(), band.spans.end());
    for (const std::size_t end : band.row_end) solid.row_begin.push_back(first + end);
    solid.maps.insert(solid.maps.end(), band.gutter.maps.begin(), band.gutter.maps.end());
    solid.turned.insert(solid.turned.end(), band.gutter.triangles.begin(),
                        band.gutter.triangles.end());
    for (const FarCell& cell : band.cells) {
        const Vec3d& corner = positions[mesh.triangles[cell.triangle][0]];
        solid.maps.push_back(near.map_of(cell, TexelMap(solid.maps[cell.triangle]), corner));
        solid.turned.push_back(cell.triangle);
    }
}

}  // namespace

SolidAtlas rasterize_charts(const Mesh& mesh, const Atlas& atlas,
                            std::span<const Vec3d> positions) {
    const BandFiller filler(mesh, atlas, positions);
    std::vector<BandSpans> bands(filler.bands());
    for_each_index(
        bands.size(), [&](std::size_t b) { bands[b] = filler.fill(std::uint32_t(b)); }, 1);
    SolidAtlas solid;
    solid.size = atlas.options.size;
    solid.maps.resize(mesh.triangles.size());
    for_each_index(
        mesh.triangles.size(),
        [&](std::size_t t) {
            const auto& [a, b, c] = mesh.triangles[t];
            solid.maps[t] = affine_map(atlas.corners[t], {positions[a], positions[b], positions[c]},
                                       {0, 0}, {solid.size, solid.size});
        },
        1024);
    std::size_t spans = 0;
    for (const BandSpans& band : bands) spans += band.spans.size();
    solid.spans.reserve(spans);
    solid.row_begin.push_back(0);
    for (BandSpans& band : bands)
        append(std::exchange(band, {}), filler.near(), mesh, positions, solid);
    return solid;
}

}  // namespace burl
