// Rasterising the patch atlas. A gutter texel's point is a sum of the points of inner texels; while
// these keep their triangles it is again an affine function of the texel, so gutters are spans,
// too. All blocks are visited twice, to count spans and to fill them: the result is large, and so
// takes no more memory than it needs.
#include <algorithm>
#include <array>
#include <cmath>

#include "atlas/base/image.h"
#include "atlas/patch/atlas.h"
#include "atlas/solid/texel_rows.h"

namespace burl {
namespace {

constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

/// The affine map that takes three places to points, anchored at a texel of the block.
TexelMap map_in_block(const std::array<Vec2d, 3>& places, const std::array<Vec3d, 3>& points,
                      const PatchBlock& block) {
    return affine_map(places, points, {block.x, block.y}, {block.width, block.height});
}

/// The inner texels (x, y) that a gutter texel is made of, with their factors.
struct Sources {
    struct Term {
        double factor;
        std::int64_t x, y;
        double sign_x, sign_y;  ///< step of the source for a step of the texel, 0 or +-1
    };
    std::array<Term, 4> terms;
    std::size_t count = 0;
};

/// The reflection of a texel along one axis: its source texels are `at`, or 2 edge - mirrored
/// outside of the inner ones.
struct Reflection {
    std::array<std::array<double, 3>, 2> terms;  ///< factor, source texel, step of the source
    std::size_t count;
};

Reflection reflect(std::int64_t at, std::int64_t first, std::int64_t last) {
    if (at >= first && at <= last) return {{{{1.0, double(at), 1.0}, {}}}, 1};
    const std::int64_t edge = at < first ? first : last;
    return {{{{2.0, double(edge), 0.0}, {-1.0, double(2 * edge - at), -1.0}}}, 2};
}

Sources sources_of(std::int64_t x, std::int64_t y, const PatchBlock& b) {
    const std::int64_t x0 = b.x + b.gutter, y0 = b.y + b.gutter;
    const Reflection in_x = reflect(x, x0, x0 + b.columns());
    const Reflection in_y = reflect(y, y0, y0 + b.rows());
    Sources sources;
    for (std::size_t j = 0; j < in_y.count; ++j)
        for (std::size_t i = 0; i < in_x.count; ++i)
            sources.terms[sources.count++] = {
                in_x.terms[i][0] * in_y.terms[j][0], std::int64_t(in_x.terms[i][1]),
                std::int64_t(in_y.terms[j][1]), in_x.terms[i][2], in_y.terms[j][2]};
    return sources;
}

/// Numbers of the maps of the inner texels that a texel is made of; nobody where there are fewer
/// than four.
using Owners = std::array<std::uint32_t, 4>;

/// Texels [x, x + count) of a row, all made of inner texels of the same owners.
struct Run {
    std::uint32_t x = 0, count = 0;
    Owners owners{nobody, nobody, nobody, nobody};
    bool gutter = false;  ///< whether the texels are gutter; else the first owner's map shows them
};

/// Calls visit(run) for texels [from, to) of row y, all in the gutter.
template <class Visit>
void visit_gutter(const PatchBlock& b, const Image<std::uint32_t>& inner, std::uint32_t y,
                  std::uint32_t from, std::uint32_t to, const Visit& visit) {
    Run run;
    for (std::uint32_t x = from; x < to; ++x) {
        const Sources sources = sources_of(x, y, b);
        Owners owners{nobody, nobody, nobody, nobody};
        for (std::size_t i = 0; i < sources.count; ++i)
            owners[i] = inner(std::size_t(sources.terms[i].x - b.x - b.gutter),
                              std::size_t(sources.terms[i].y - b.y - b.gutter));
        if (x > from && owners == run.owners) {
            ++run.count;
            continue;
        }
        if (x > from) visit(run);
        run = {x, 1, owners, true};
    }
    if (to > from) visit(run);
}

/// Calls visit(run) for the runs of the block's row y; `inner` holds the owners of the inner
/// texels.
template <class Visit>
void visit_row(const PatchBlock& b, const Image<std::uint32_t>& inner, std::uint32_t y,
               const Visit& visit) {
    const std::uint32_t begin = b.x + b.gutter, end = begin + b.columns() + 1;
    visit_gutter(b, inner, y, b.x, begin, visit);
    if (y < b.y + b.gutter || y > b.y + b.gutter + b.rows()) {
        visit_gutter(b, inner, y, begin, end, visit);
    } else {
        const std::span<const std::uint32_t> owners = inner.row(y - b.y - b.gutter);
        for (std::size_t i = 0; i < owners.size();) {
            const std::size_t first = i;
            while (i < owners.size() && owners[i] == owners[first]) ++i;
            visit(Run{std::uint32_t(begin + first),
                      std::uint32_t(i - first),
                      {owners[first], nobody, nobody, nobody}});
        }
    }
    visit_gutter(b, inner, y, end, b.x + b.width, visit);
}

/// Makes the spans and maps of an atlas's blocks.
class Rasterizer {
  public:
    Rasterizer(const PatchAtlas& atlas, std::span<const Vec3d> positions)
        : atlas_(atlas), positions_(positions), hubs_(atlas.hubs, Vec4d(0.0)) {}

    SolidAtlas run() {
        solid_.size = atlas_.atlas.options.size;
        sort_triangles();
        count_spans();
        map_mesh_triangles();
        for (std::size_t p = 0; p < atlas_.patches.size(); ++p)
            atlas_.patches[p].plane ? fill_plane(p) : fill_block(p);
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

    /// Sets the begins of all rows, and makes room for spans and maps.
    void count_spans() {
        std::vector<std::size_t> counts(solid_.size, 0);
        const auto mesh_maps = std::uint32_t(atlas_.atlas.corners.size());
        std::size_t more_maps = 0;
        for (std::size_t p = 0; p < atlas_.patches.size(); ++p) {
            const PatchBlock& b = atlas_.layout.blocks[p];
            const bool plane = atlas_.patches[p].plane.has_value();
            more_maps += plane ? 1 : atlas_.patches[p].fans.size();
            const Image<std::uint32_t> inner =
                plane ? Image<std::uint32_t>() : inner_owners(p, mesh_maps);
            for (std::uint32_t y = b.y; y < b.y + b.height; ++y) {
                if (plane)
                    ++counts[y];
                else
                    visit_row(b, inner, y, [&](const Run& run) {
                        ++counts[y];
                        more_maps += run.gutter;
                    });
            }
        }
        solid_.row_begin.reserve(solid_.size + 1);
        solid_.row_begin.push_back(0);
        for (const std::size_t count : counts)
            solid_.row_begin.push_back(solid_.row_begin.back() + count);
        solid_.spans.resize(solid_.row_begin.back());
        filled_.assign(solid_.row_begin.begin(), solid_.row_begin.end() - 1);
        solid_.maps.reserve(mesh_maps + more_maps);
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

    /// The number of the map at each texel of the inner rectangle; the maps of the patch's fans
    /// begin at `fan_map`.
    Image<std::uint32_t> inner_owners(std::size_t p, std::uint32_t fan_map) const {
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
        for (std::uint32_t i = first_[p]; i < first_[p + 1]; ++i)
            show(atlas_.atlas.corners[triangles_[i]], triangles_[i]);
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

    void fill_block(std::size_t p) {
        const auto first_fan = std::uint32_t(solid_.maps.size());
        map_fans(p);
        const PatchBlock& b = atlas_.layout.blocks[p];
        const Image<std::uint32_t> inner = inner_owners(p, first_fan);
        for (std::uint32_t y = b.y; y < b.y + b.height; ++y)
            visit_row(b, inner, y, [&](const Run& run) {
                const std::uint32_t map = run.gutter ? gutter_map(run, y, b) : run.owners[0];
                add_span(y, {run.x, run.count, map});
            });
    }

    std::uint32_t gutter_map(const Run& run, std::uint32_t y, const PatchBlock& b) {
        const Sources sources = sources_of(run.x, y, b);
        TexelMap map;
        map.anchor_x = static_cast<std::int32_t>(run.x);
        map.anchor_y = static_cast<std::int32_t>(y);
        for (std::size_t i = 0; i < sources.count; ++i) {
            const auto& term = sources.terms[i];
            const TexelMap& source = solid_.maps[run.owners[i]];
            map.origin += term.factor * source(term.x, term.y);
            map.step_x += term.factor * term.sign_x * source.step_x;
            map.step_y += term.factor * term.sign_y * source.step_y;
        }
        return add_map(map, solid_.triangle_of(run.owners[0]));
    }

    /// Adds one affine map for the whole block of a planar patch, and its spans.
    void fill_plane(std::size_t p) {
        const PlacedPatch& patch = atlas_.patches[p];
        const PatchBlock& block = atlas_.layout.blocks[p];
        const auto& [a, b, c] = patch.plane->points;
        const std::uint32_t map = add_map(
            map_in_block(patch.plane->places, {positions_[a], positions_[b], positions_[c]}, block),
            patch.triangle);
        for (std::uint32_t y = block.y; y < block.y + block.height; ++y)
            add_span(y, {block.x, block.width, map});
    }

    const PatchAtlas& atlas_;
    std::span<const Vec3d> positions_;
    std::vector<Vec4d> hubs_;  ///< sum of the points on each hub's rim (xyz), and their number (w)
    SolidAtlas solid_;
    std::vector<std::size_t> filled_;               ///< place of the next span of each row
    std::vector<std::uint32_t> first_, triangles_;  ///< triangles sorted by patch
};

}  // namespace

SolidAtlas rasterize_patches(const PatchAtlas& atlas, std::span<const Vec3d> positions) {
    return Rasterizer(atlas, positions).run();
}

}  // namespace burl
