// Rasterising the patch atlas. A gutter texel's point is a sum of the points of inner texels; while
// those keep their triangles it is again an affine function of the texel, so gutters are spans,
// too.
#include <algorithm>
#include <array>
#include <cmath>

#include "atlas/image.h"
#include "atlas/patch_atlas.h"
#include "atlas/texel_rows.h"

namespace burl {
namespace {

constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

double cross(const Vec2d& a, const Vec2d& b) {
    return a.x * b.y - a.y * b.x;
}

/// The affine map through three places, anchored at a texel of the block.
TexelMap affine_map(const std::array<Vec2d, 3>& places, const std::array<Vec3d, 3>& points,
                    const PatchBlock& block) {
    const Vec2d u = places[1] - places[0], v = places[2] - places[0];
    const Vec3d along_u = points[1] - points[0], along_v = points[2] - points[0];
    const auto anchor = [](double at, std::uint32_t first, std::uint32_t count) {
        return static_cast<std::int32_t>(
            std::clamp(std::floor(at), double(first), double(first) + count - 1.0));
    };
    TexelMap map;
    map.origin = points[0];
    const double det = cross(u, v);
    map.anchor_x = anchor(places[0].x, block.x, block.width);
    map.anchor_y = anchor(places[0].y, block.y, block.height);
    if (det == 0.0) return map;
    map.step_x = (along_u * v.y - along_v * u.y) / det;
    map.step_y = (along_v * u.x - along_u * v.x) / det;
    map.origin += (map.anchor_x + 0.5 - places[0].x) * map.step_x +
                  (map.anchor_y + 0.5 - places[0].y) * map.step_y;
    return map;
}

/// Inner texels a gutter texel is made of, with their factors.
struct Sources {
    struct Term {
        double factor;
        std::int64_t x, y;
        double sign_x, sign_y;  ///< how the source moves when the texel does
    };
    std::array<Term, 4> terms;
    std::size_t count = 0;
};

/// One axis of the reflection: at a, or 2 at(edge) - at(mirrored).
struct Reflection {
    std::array<std::array<double, 3>, 2> terms;  ///< factor, position, sign
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

class Rasterizer {
  public:
    Rasterizer(const PatchAtlas& atlas, std::span<const Vec3d> positions)
        : atlas_(atlas), positions_(positions) {
        const std::size_t patches = atlas.maps.patches.size();
        vertex_points_.resize(patches);
        map_of_triangle_.resize(patches);
        for (std::size_t p = 0; p < patches; ++p) {
            vertex_points_[p].assign(atlas.maps.patches[p].patch.points.size(), Vec3d(0.0));
            map_of_triangle_[p].assign(atlas.maps.patches[p].patch.triangles.size(), nobody);
        }
    }

    SolidAtlas run() {
        solid_.size = atlas_.atlas.options.size;
        rows_.resize(solid_.size);
        map_mesh_triangles();
        for (std::size_t p = 0; p < vertex_points_.size(); ++p) {
            if (atlas_.maps.patches[p].planar)
                fill_plane(p);
            else
                fill_block(p);
        }
        vertex_points_ = {};
        map_of_triangle_ = {};
        join_rows();
        return std::move(solid_);
    }

  private:
    /// Each row is given back once it is taken over: they are as large as all that follows.
    void join_rows() {
        std::size_t count = 0;
        for (const auto& row : rows_) count += row.size();
        solid_.spans.reserve(count);
        solid_.row_begin.reserve(rows_.size() + 1);
        solid_.row_begin.push_back(0);
        for (auto& row : rows_) {
            std::sort(row.begin(), row.end(),
                      [](const Span& a, const Span& b) { return a.x < b.x; });
            solid_.spans.insert(solid_.spans.end(), row.begin(), row.end());
            solid_.row_begin.push_back(solid_.spans.size());
            row = {};
        }
    }

    void map_mesh_triangles() {
        const RefinedMesh& refined = atlas_.refined;
        solid_.maps.reserve(refined.mesh.triangles.size());
        for (std::uint32_t t = 0; t < refined.mesh.triangles.size(); ++t) {
            const auto& [a, b, c] = refined.mesh.triangles[t];
            const std::array<Vec3d, 3> points{positions_[a], positions_[b], positions_[c]};
            const std::uint32_t p = refined.patch[t];
            if (p == not_in_mesh) {
                solid_.maps.push_back({points[0], Vec3d(0.0), Vec3d(0.0), 0, 0});
                continue;
            }
            const Triangle& local = atlas_.maps.patches[p].patch.triangles[refined.in_patch[t]];
            for (std::size_t k = 0; k < 3; ++k) vertex_points_[p][local[k]] = points[k];
            map_of_triangle_[p][refined.in_patch[t]] = t;
            solid_.maps.push_back(
                affine_map(atlas_.atlas.corners[t], points, atlas_.layout.blocks[p]));
        }
    }

    /// A map beyond the triangles' own, and the triangle it belongs to.
    std::uint32_t add_map(const TexelMap& map, std::uint32_t triangle) {
        solid_.maps.push_back(map);
        solid_.turned.push_back(triangle);
        return static_cast<std::uint32_t>(solid_.maps.size() - 1);
    }

    /// The patch's first triangle of the mesh.
    std::uint32_t any_triangle(std::size_t p) const {
        return *std::find_if(map_of_triangle_[p].begin(), map_of_triangle_[p].end(),
                             [&](std::uint32_t map) { return map < atlas_.atlas.corners.size(); });
    }

    std::array<Vec2d, 3> places(std::size_t p, const Triangle& t) const {
        const auto& uv = atlas_.maps.patches[p].uv;
        const PatchBlock& block = atlas_.layout.blocks[p];
        return {block.place(uv[t[0]]), block.place(uv[t[1]]), block.place(uv[t[2]])};
    }

    /// Gives the triangles that close holes maps of their own; their hub is the hole's centroid.
    void map_fans(std::size_t p) {
        const Patch& patch = atlas_.maps.patches[p].patch;
        auto& points = vertex_points_[p];
        std::vector<double> corners(points.size(), 0.0);
        for (int pass = 0; pass < 2; ++pass)
            for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
                if (patch.faces[t] != not_in_mesh) continue;
                const Triangle& v = patch.triangles[t];
                const auto hub = std::find_if(v.begin(), v.end(), [&](std::uint32_t i) {
                    return patch.origins[i] == VertexOrigin{};
                });
                if (pass == 0 && hub != v.end()) {
                    const std::size_t k = std::size_t(hub - v.begin());
                    points[*hub] += points[v[(k + 1) % 3]] + points[v[(k + 2) % 3]];
                    corners[*hub] += 2.0;
                } else if (pass == 1) {
                    std::array<Vec3d, 3> at{};
                    for (std::size_t k = 0; k < 3; ++k)
                        at[k] = points[v[k]] / std::max(corners[v[k]], 1.0);
                    map_of_triangle_[p][t] = add_map(
                        affine_map(places(p, v), at, atlas_.layout.blocks[p]), any_triangle(p));
                }
            }
    }

    /// The map at each texel of the inner rectangle.
    Image<std::uint32_t> inner_owners(std::size_t p) {
        const Patch& patch = atlas_.maps.patches[p].patch;
        const PatchBlock& b = atlas_.layout.blocks[p];
        const std::uint32_t columns = b.columns() + 1, rows = b.rows() + 1;
        const Vec2d low(b.x + b.gutter, b.y + b.gutter);
        const std::uint32_t reach = std::max(columns, rows);
        Image<std::uint32_t> owner(columns, rows, nobody);
        for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
            std::array<Vec2d, 3> corners = places(p, patch.triangles[t]);
            for (Vec2d& corner : corners) corner -= low;
            if (!(cross(corners[1] - corners[0], corners[2] - corners[0]) > 0.0)) continue;
            visit_slices(corners, reach, 0.0, [&](std::uint32_t row, const Interval& x) {
                if (row >= rows) return;
                const TexelRun run = centres_within(x.low, x.high, columns);
                for (std::uint32_t& texel : owner.row(row).subspan(run.first, run.count))
                    texel = std::min(texel, map_of_triangle_[p][t]);
            });
        }
        fill_missed(owner);
        return owner;
    }

    /// Centres on the border that rounding left to nobody take the nearest owner of their row, or
    /// else that of the row before.
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
        map_fans(p);
        const PatchBlock& b = atlas_.layout.blocks[p];
        const Image<std::uint32_t> owner = inner_owners(p);
        using Key = std::array<std::uint32_t, 4>;
        const auto owners_of = [&](const Sources& sources) {
            Key key{nobody, nobody, nobody, nobody};
            for (std::size_t i = 0; i < sources.count; ++i)
                key[i] = owner.row(
                    std::uint32_t(sources.terms[i].y - b.y -
                                  b.gutter))[std::size_t(sources.terms[i].x - b.x - b.gutter)];
            return key;
        };
        for (std::uint32_t y = b.y; y < b.y + b.height; ++y) {
            Key before{};
            std::size_t count_before = 0;
            for (std::uint32_t x = b.x; x < b.x + b.width; ++x) {
                const Sources sources = sources_of(x, y, b);
                const Key key = owners_of(sources);
                const bool enters = x == b.x + b.gutter || x == b.x + b.gutter + b.columns() + 1;
                if (x > b.x && !enters && key == before && sources.count == count_before) {
                    ++rows_[y].back().count;
                    continue;
                }
                rows_[y].push_back({x, 1, map_for(sources, key, x, y)});
                before = key;
                count_before = sources.count;
            }
        }
    }

    std::uint32_t map_for(const Sources& sources, const std::array<std::uint32_t, 4>& key,
                          std::uint32_t x, std::uint32_t y) {
        if (sources.count == 1) return key[0];
        TexelMap map;
        map.anchor_x = static_cast<std::int32_t>(x);
        map.anchor_y = static_cast<std::int32_t>(y);
        for (std::size_t i = 0; i < sources.count; ++i) {
            const auto& term = sources.terms[i];
            const TexelMap& source = solid_.maps[key[i]];
            map.origin += term.factor * source(term.x, term.y);
            map.step_x += term.factor * term.sign_x * source.step_x;
            map.step_y += term.factor * term.sign_y * source.step_y;
        }
        return add_map(map, solid_.triangle_of(key[0]));
    }

    /// One affine map for the whole block, from three vertices far apart.
    void fill_plane(std::size_t p) {
        const MappedPatch& mapped = atlas_.maps.patches[p];
        const PatchBlock& block = atlas_.layout.blocks[p];
        const auto farthest = [&](auto distance) {
            std::uint32_t best = 0;
            for (std::uint32_t v = 1; v < mapped.uv.size(); ++v)
                if (distance(mapped.uv[v]) > distance(mapped.uv[best])) best = v;
            return best;
        };
        const std::uint32_t a = farthest([](const Vec2d& q) { return -q.x - q.y; });
        const std::uint32_t b =
            farthest([&](const Vec2d& q) { return glm::distance(q, mapped.uv[a]); });
        const Vec2d line = mapped.uv[b] - mapped.uv[a];
        const std::uint32_t c =
            farthest([&](const Vec2d& q) { return std::abs(cross(line, q - mapped.uv[a])); });
        const auto& points = vertex_points_[p];
        const std::uint32_t map =
            add_map(affine_map(places(p, {a, b, c}), {points[a], points[b], points[c]}, block),
                    any_triangle(p));
        for (std::uint32_t y = block.y; y < block.y + block.height; ++y)
            rows_[y].push_back({block.x, block.width, map});
    }

    const PatchAtlas& atlas_;
    std::span<const Vec3d> positions_;
    SolidAtlas solid_;
    std::vector<std::vector<Span>> rows_;
    std::vector<std::vector<Vec3d>> vertex_points_;            ///< per patch and vertex
    std::vector<std::vector<std::uint32_t>> map_of_triangle_;  ///< per patch and triangle
};

}  // namespace

SolidAtlas rasterize_patches(const PatchAtlas& atlas, std::span<const Vec3d> positions) {
    return Rasterizer(atlas, positions).run();
}

}  // namespace burl
