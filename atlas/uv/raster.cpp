#include "atlas/uv/raster.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "atlas/base/each_index.h"
#include "atlas/solid/texel_rows.h"
#include "atlas/uv/claims.h"
#include "atlas/uv/nearest.h"

namespace burl {

namespace {

using Corners = std::array<Vec2d, 3>;
using Points = std::array<Vec3d, 3>;

/// A texel that a triangle without centres touches.
struct Touch {
    std::uint32_t x = 0, y = 0, triangle = 0;
    double distance = 0.0;  ///< squared distance of the texel's centre to the triangle
};

/// A place on a triangle's border: along the edge that begins at corner `edge`, by a share of it.
struct BorderPlace {
    std::size_t edge = 0;
    double share = 0.0, distance = INFINITY;  ///< `distance` is squared, to the place asked for
};

/// The place on the border that is nearest to `at`; on the longest edge of a triangle that is a
/// point.
BorderPlace nearest_on_border(const Corners& corners, const Vec2d& at) {
    BorderPlace best;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2d a = corners[k], along = corners[(k + 1) % 3] - a;
        const double squared = glm::dot(along, along);
        const double share =
            squared > 0.0 ? std::clamp(glm::dot(at - a, along) / squared, 0.0, 1.0) : 0.0;
        const Vec2d away = a + share * along - at;
        const double distance = glm::dot(away, away);
        if (distance < best.distance) best = {k, share, distance};
    }
    return best;
}

/// The map of a texel that shows the nearest point of a triangle's border; it goes on along the
/// edge and is constant across it, since a sliver's own map may be arbitrarily steep there.
TexelMap border_map(const Corners& corners, const Points& points, std::uint32_t x,
                    std::uint32_t y) {
    const BorderPlace place = nearest_on_border(corners, {x + 0.5, y + 0.5});
    const std::size_t a = place.edge, b = (a + 1) % 3;
    const Vec2d along = corners[b] - corners[a];
    const Vec3d change = points[b] - points[a];
    const double squared = glm::dot(along, along);
    TexelMap map;
    map.anchor_x = std::int32_t(x);
    map.anchor_y = std::int32_t(y);
    map.origin = points[a] + place.share * change;
    // An edge shorter than a texel is no measure of how the surface goes on.
    if (squared < 1.0) return map;
    map.step_x = change * (along.x / squared);
    map.step_y = change * (along.y / squared);
    return map;
}

/// Makes the spans and maps of a uv atlas's texture.
class UvRasterizer {
  public:
    UvRasterizer(const Mesh& mesh, const Atlas& atlas, std::span<const Vec3d> positions)
        : mesh_(mesh), atlas_(atlas), positions_(positions), owner_(claim_texels(atlas).owner) {}

    SolidAtlas run() {
        solid_.size = atlas_.options.size;
        solid_.maps.resize(mesh_.triangles.size());
        for_each_index(solid_.maps.size(), [&](std::size_t t) { map_triangle(t); });
        claim_touched();
        make_spans();
        return std::move(solid_);
    }

  private:
    Points points_of(std::size_t t) const {
        const auto& [a, b, c] = mesh_.triangles[t];
        return {positions_[a], positions_[b], positions_[c]};
    }

    void map_triangle(std::size_t t) {
        solid_.maps[t] =
            affine_map(atlas_.corners[t], points_of(t), {0, 0},
                       {std::uint32_t(owner_.width()), std::uint32_t(owner_.height())});
    }

    /// The unclaimed texels that a triangle touches, added to `touches`.
    void touch(std::uint32_t t, std::vector<Touch>& touches) const {
        const Corners& corners = atlas_.corners[t];
        const auto columns = double(owner_.width());
        visit_slices(
            corners, std::uint32_t(owner_.height()), 0.5, [&](std::uint32_t y, const Interval& x) {
                const double end = std::min(std::floor(x.high), columns - 1.0);
                for (double i = std::max(std::floor(x.low), 0.0); i <= end; ++i) {
                    const auto column = std::uint32_t(i);
                    if (owner_(column, y) != unclaimed) continue;
                    const Vec2d centre(i + 0.5, y + 0.5);
                    touches.push_back({column, y, t, nearest_on_border(corners, centre).distance});
                }
            });
    }

    /// Gives unclaimed texels to the triangles that touch them and hold no centre.
    void claim_touched() {
        std::vector<bool> owns(mesh_.triangles.size());
        for (const std::uint32_t t : owner_.pixels())
            if (t != unclaimed) owns[t] = true;
        std::vector<Touch> touches;
        for (std::uint32_t t = 0; t < owns.size(); ++t)
            if (!owns[t] && has_texture_area(atlas_.corners[t])) touch(t, touches);
        std::ranges::sort(touches, {}, [](const Touch& one) {
            return std::tuple(one.y, one.x, one.distance, one.triangle);
        });
        for (const Touch& one : touches) {
            std::uint32_t& texel = owner_(one.x, one.y);
            if (texel != unclaimed) continue;
            texel = std::uint32_t(solid_.maps.size());
            solid_.maps.push_back(
                border_map(atlas_.corners[one.triangle], points_of(one.triangle), one.x, one.y));
            solid_.turned.push_back(one.triangle);
        }
    }

    /// The spans of row y: runs of texels whose nearest claimed ones have the same map.
    std::vector<Span> spans_of(const NearestClaims& nearest, std::uint32_t y) const {
        std::vector<NearestClaims::Place> places;
        nearest.find(y, places);
        std::vector<Span> spans;
        for (std::uint32_t x = 0; x < places.size(); ++x) {
            const std::uint32_t map = owner_(places[x].x, places[x].y);
            if (spans.empty() || spans.back().map != map)
                spans.push_back({x, 1, map});
            else
                ++spans.back().count;
        }
        return spans;
    }

    void make_spans() {
        const NearestClaims nearest(owner_);
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

    const Mesh& mesh_;
    const Atlas& atlas_;
    std::span<const Vec3d> positions_;
    Image<std::uint32_t> owner_;  ///< the map of each claimed texel
    SolidAtlas solid_;
};

}  // namespace

SolidAtlas rasterize_uv_charts(const Mesh& mesh, const Atlas& atlas,
                               std::span<const Vec3d> positions) {
    return UvRasterizer(mesh, atlas, positions).run();
}

}  // namespace burl
