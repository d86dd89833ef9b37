// Texels beyond the charts' borders take maps that they share with all others of a border edge's
// zone, so that they cost spans but hardly any maps.
#include "atlas/uv/raster.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "atlas/base/each_index.h"
#include "atlas/gutter/gutters.h"
#include "atlas/uv/borders.h"
#include "atlas/uv/claims.h"
#include "atlas/uv/nearest.h"

namespace burl {

namespace {

/// Number of zones of a border edge that have maps of their own.
constexpr std::uint32_t zones = 6;

/// Makes the spans and maps of a uv atlas's texture.
class UvRasterizer {
  public:
    UvRasterizer(const Mesh& mesh, const Atlas& atlas, std::span<const Vec3d> positions)
        : mesh_(mesh),
          atlas_(atlas),
          positions_(positions),
          owner_(claim_texels(atlas).owner),
          edges_(border_edges(atlas)),
          walked_(owner_.width(), owner_.height(), unclaimed),
          border_(owner_.width(), owner_.height(), unclaimed) {}

    SolidAtlas run() {
        solid_.size = atlas_.options.size;
        fill_gutters();
        make_spans();
        solid_.maps.resize(triangles());
        for_each_index(triangles(), [&](std::size_t t) { map_triangle(t); });
        add_zone_maps();
        return std::move(solid_);
    }

  private:
    /// Finds the nearest border edges of texels near charts, and fills those that the border
    /// triangle's map does not go on to with the surface beyond the border, where there is some.
    void fill_gutters() {
        const ChartedMesh charted{mesh_.triangles, positions_, atlas_.corners, atlas_.charts};
        const EdgeNeighbours neighbours(mesh_.triangles, positions_);
        std::vector<ChartEdge> edges;
        for (const BorderEdge& edge : edges_)
            edges.push_back(chart_edge(charted, 3 * edge.triangle + edge.corner));
        std::vector<TexelGap> gaps = gaps_between(owner_);
        std::vector<std::uint32_t> nearest = nearest_edges(edges, gaps, reach());
        auto known = nearest.begin();
        for (const TexelGap& gap : gaps) {
            std::copy_n(known, gap.count, &border_(gap.x, gap.y));
            known += gap.count;
        }
        gutter_ = fill_gutter(charted, neighbours, edges, gaps, nearest,
                              {0, 0, atlas_.options.columns(), atlas_.options.rows()},
                              {.leaves_open = true});
        for (const GutterRun& run : gutter_.runs)
            std::fill_n(&walked_(run.x, run.y), run.count, run.map);
    }

    /// Distance from a chart, in texels, up to which texels may show the surface beyond its border.
    double reach() const { return std::max(exact_reach, solid_.size / 64.0); }

    std::uint32_t triangles() const { return std::uint32_t(mesh_.triangles.size()); }

    void map_triangle(std::size_t t) {
        const auto& [a, b, c] = mesh_.triangles[t];
        solid_.maps[t] =
            affine_map(atlas_.corners[t], {positions_[a], positions_[b], positions_[c]}, {0, 0},
                       {atlas_.options.columns(), atlas_.options.rows()});
    }

    /// The number of the map that texel (x, y) shows beyond the border edge `e`, if zones of all
    /// edges had maps.
    std::uint32_t map_beyond(std::uint32_t e, std::uint32_t x, std::uint32_t y) const {
        const BorderZone zone = zone_of(edges_[e], {x + 0.5, y + 0.5});
        if (zone == BorderZone::near) return edges_[e].triangle;
        return triangles() + zones * e + std::uint32_t(zone) - 1;
    }

    /// The number of the map of texel (x, y), whose nearest texel with an owner or a border is
    /// `place`.
    std::uint32_t map_at(std::uint32_t x, std::uint32_t y,
                         const NearestClaims::Place& place) const {
        const std::uint32_t e = border_(place.x, place.y);
        const std::uint32_t walked = walked_(x, y);
        if (walked != unclaimed && zone_of(edges_[e], {x + 0.5, y + 0.5}) != BorderZone::near)
            return first_walked() + walked;
        return e == unclaimed ? owner_(place.x, place.y) : map_beyond(e, x, y);
    }

    std::vector<Span> spans_of(const NearestClaims& nearest, std::uint32_t y) const {
        std::vector<NearestClaims::Place> places;
        nearest.find(y, places);
        std::vector<Span> spans;
        for (std::uint32_t x = 0; x < places.size(); ++x) {
            const std::uint32_t map = map_at(x, y, places[x]);
            if (spans.empty() || spans.back().map != map)
                spans.push_back({x, 1, map});
            else
                ++spans.back().count;
        }
        return spans;
    }

    void make_spans() {
        Image<std::uint32_t> known = owner_;
        for (std::size_t y = 0; y < known.height(); ++y)
            for (std::size_t x = 0; x < known.width(); ++x)
                known(x, y) = std::min(known(x, y), border_(x, y));
        const NearestClaims nearest(known);
        std::vector<std::vector<Span>> rows(owner_.height());
        for_each_index(
            rows.size(), [&](std::size_t y) { rows[y] = spans_of(nearest, std::uint32_t(y)); }, 16);
        solid_.row_begin.assign(1, 0);
        for (std::size_t y = 0; y < solid_.size; ++y)
            solid_.row_begin.push_back(solid_.row_begin.back() +
                                       (y < rows.size() ? rows[y].size() : 0));
        solid_.spans.reserve(solid_.row_begin.back());
        for (const std::vector<Span>& row : rows)
            solid_.spans.insert(solid_.spans.end(), row.begin(), row.end());
    }

    /// The number of the first map of the gutter, if zones of all edges had maps.
    std::uint32_t first_walked() const {
        return triangles() + zones * std::uint32_t(edges_.size());
    }

    /// Adds the maps of the zones that spans show, in the order of the edges, and numbers them
    /// anew.
    void add_zone_maps() {
        std::vector<std::uint32_t> number(zones * edges_.size() + gutter_.maps.size(), unclaimed);
        for (const Span& span : solid_.spans)
            if (span.map >= triangles()) number[span.map - triangles()] = 0;
        for (std::uint32_t i = 0; i < number.size(); ++i) {
            if (number[i] == unclaimed) continue;
            number[i] = std::uint32_t(solid_.maps.size());
            if (i >= zones * edges_.size()) {
                const std::size_t walked = i - zones * edges_.size();
                solid_.maps.push_back(gutter_.maps[walked]);
                solid_.turned.push_back(gutter_.triangles[walked]);
                continue;
            }
            const BorderEdge& edge = edges_[i / zones];
            solid_.maps.push_back(
                zone_map(edge, solid_.maps[edge.triangle], BorderZone(1 + i % zones)));
            solid_.turned.push_back(edge.triangle);
        }
        for (Span& span : solid_.spans)
            if (span.map >= triangles()) span.map = number[span.map - triangles()];
    }

    const Mesh& mesh_;
    const Atlas& atlas_;
    std::span<const Vec3d> positions_;
    Image<std::uint32_t> owner_;  ///< the triangle that holds each texel's centre
    std::vector<BorderEdge> edges_;
    Gutter gutter_;
    Image<std::uint32_t> walked_;  ///< the gutter's map at each texel, or unclaimed
    Image<std::uint32_t> border_;  ///< the nearest border edge of texels beside charts
    SolidAtlas solid_;
};

}  // namespace

SolidAtlas rasterize_uv_charts(const Mesh& mesh, const Atlas& atlas,
                               std::span<const Vec3d> positions) {
    return UvRasterizer(mesh, atlas, positions).run();
}

}  // namespace burl
