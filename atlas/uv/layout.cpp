// Charts come from the mesh's own neighbourhoods, so that two charts that happen to touch in the
// texture stay two.
#include "atlas/uv/layout.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "atlas/uv/claims.h"

namespace burl {

namespace {

std::string name_of(const Mesh& mesh) {
    return mesh.name.empty() ? "the mesh" : mesh.name;
}

/// Throws Error(usage) for a mesh without texture coordinates.
void check_uvs(const Mesh& mesh) {
    if (mesh.corners.uvs.empty())
        throw Error(ExitCode::usage,
                    fmt::format("{} has no texture coordinates; use --atlas chart, which makes its "
                                "own, or unwrap the mesh first",
                                name_of(mesh)));
}

std::array<Vec2d, 3> uvs_of(const Mesh& mesh, std::size_t t) {
    return {mesh.corners.uvs[3 * t], mesh.corners.uvs[3 * t + 1], mesh.corners.uvs[3 * t + 2]};
}

bool is_finite(const std::array<Vec2d, 3>& uvs) {
    return std::ranges::all_of(
        uvs, [](const Vec2d& uv) { return std::isfinite(uv.x) && std::isfinite(uv.y); });
}

/// The corner of triangle t at the point; 3 where it has none.
std::size_t corner_at(const Mesh& mesh, std::size_t t, std::uint32_t point) {
    const Triangle& triangle = mesh.triangles[t];
    return std::size_t(std::ranges::find(triangle, point) - triangle.begin());
}

/// Whether the triangle's edge k has the coordinates that it has in the neighbour.
bool goes_on(const Mesh& mesh, std::size_t t, std::size_t k, std::size_t neighbour) {
    const auto equal = [&](std::size_t corner) {
        const std::size_t other = corner_at(mesh, neighbour, mesh.triangles[t][corner]);
        return other < 3 &&
               mesh.corners.uvs[3 * t + corner] == mesh.corners.uvs[3 * neighbour + other];
    };
    return equal(k) && equal((k + 1) % 3);
}

/// The first triangle of the chart of each triangle.
std::vector<std::uint32_t> first_of_charts(const Mesh& mesh, const Connectivity& connectivity) {
    DisjointSets sets(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t neighbour = connectivity.neighbours[t][k];
            if (neighbour >= 0 && goes_on(mesh, t, k, std::size_t(neighbour)))
                sets.join(t, std::uint32_t(neighbour));
        }
    std::vector<std::uint32_t> first(mesh.triangles.size());
    for (std::uint32_t t = 0; t < first.size(); ++t) first[t] = sets.find(t);
    return first;
}

/// The box of a chart's coordinates; empty (low > high) without area.
struct UvBox {
    Vec2d low{INFINITY}, high{-INFINITY};
    bool empty() const { return !(low.x <= high.x); }
};

/// The boxes of the charts, each in the place of its first triangle.
std::vector<UvBox> boxes_of(const Mesh& mesh, const std::vector<std::uint32_t>& first) {
    std::vector<UvBox> boxes(first.size());
    for (std::size_t t = 0; t < first.size(); ++t) {
        const std::array<Vec2d, 3> uvs = uvs_of(mesh, t);
        if (!has_texture_area(uvs, 1.0)) continue;
        UvBox& box = boxes[first[t]];
        for (const Vec2d& uv : uvs) box = {glm::min(box.low, uv), glm::max(box.high, uv)};
    }
    return boxes;
}

/// A tile by its column and its row, rows counted downwards as v is.
struct UvTile {
    double column = 0.0, row = 0.0;
};

UvTile tile_of(std::uint32_t number) {
    return {double((number - 1001) % 10), -double((number - 1001) / 10)};
}

/// The number of the tile that holds the box, which is not empty; 0 where no single tile does.
std::uint32_t tile_number(const UvBox& box) {
    const Vec2d low = glm::floor(box.low + uv_slack);
    const bool held = box.high.x <= low.x + 1.0 + uv_slack && box.high.y <= low.y + 1.0 + uv_slack;
    const bool numbered = low.x >= 0.0 && low.x < 10.0 && low.y <= 0.0 && low.y > -900.0;
    return held && numbered ? udim_number(std::int64_t(low.x), -std::int64_t(low.y)) : 0;
}

Error lies_in_no_tile(const Mesh& mesh, const UvBox& box, std::uint64_t charts) {
    // People know v upwards.
    return Error(ExitCode::runtime,
                 fmt::format("{}: {} of its charts lie in no single tile of the texture (one has u "
                             "{:.4g} to {:.4g}, v {:.4g} to {:.4g}): a texture that repeats cannot "
                             "show a solid; unwrap the mesh into 0 to 1, or use --atlas chart",
                             name_of(mesh), charts, box.low.x, box.high.x, 1.0 - box.high.y,
                             1.0 - box.low.y));
}

/// The tiles of the charts with area. Throws Error as udim_tiles() does.
std::vector<std::uint32_t> tiles_of(const Mesh& mesh, const std::vector<UvBox>& boxes) {
    std::set<std::uint32_t> tiles;
    const UvBox* homeless = nullptr;
    std::uint64_t count = 0;
    for (const UvBox& box : boxes) {
        if (box.empty()) continue;
        const std::uint32_t tile = tile_number(box);
        if (tile == 0 && count++ == 0) homeless = &box;
        tiles.insert(tile);
    }
    if (homeless) throw lies_in_no_tile(mesh, *homeless, count);
    if (tiles.empty())
        throw Error(ExitCode::runtime,
                    fmt::format("{}: none of its triangles has an area in its texture coordinates; "
                                "use --atlas chart, which makes its own",
                                name_of(mesh)));
    return {tiles.begin(), tiles.end()};
}

/// Throws Error(runtime) where charts lie elsewhere than in tile 1001.
void check_one_tile(const Mesh& mesh, const std::vector<std::uint32_t>& tiles) {
    if (tiles.size() == 1 && tiles[0] == 1001) return;
    const std::size_t named = std::min<std::size_t>(tiles.size(), 4);
    throw Error(ExitCode::runtime,
                fmt::format("{}: its charts lie in {} UDIM tile{} ({}{}); bake a .png or .exr with "
                            "--udim, which writes an image for each",
                            name_of(mesh), tiles.size(), tiles.size() == 1 ? "" : "s",
                            fmt::join(tiles.begin(), tiles.begin() + std::ptrdiff_t(named), ", "),
                            named < tiles.size() ? ", ..." : ""));
}

void place_corners(const Mesh& mesh, Atlas& atlas) {
    const AtlasOptions& options = atlas.options;
    const UvTile tile = tile_of(options.tile == 0 ? 1001 : options.tile);
    const Vec2d extent(options.columns(), options.rows());
    atlas.corners.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < atlas.corners.size(); ++t) {
        const std::array<Vec2d, 3> uvs = uvs_of(mesh, t);
        if (!has_texture_area(uvs, 1.0)) ++atlas.notes.flat_triangles;
        for (std::size_t k = 0; k < 3; ++k)
            atlas.corners[t][k] =
                is_finite(uvs) ? (uvs[k] - Vec2d(tile.column, tile.row)) * extent : Vec2d(0.0);
    }
}

/// Numbers the charts by their first triangles.
void number_uv_charts(const std::vector<std::uint32_t>& first, Atlas& atlas) {
    atlas.charts.resize(first.size());
    for (std::uint32_t t = 0; t < first.size(); ++t)
        atlas.charts[t] = first[t] == t ? atlas.chart_count++ : atlas.charts[first[t]];
}

/// Counts the texels that several triangles claim. Throws Error(runtime) where that is refused.
void count_overlap(const Mesh& mesh, Atlas& atlas) {
    const UvClaims claims = claim_texels(atlas);
    atlas.notes.overlapped_texels = claims.shared_texels;
    atlas.notes.overlapping_triangles = claims.sharing_triangles;
    if (claims.shared_texels == 0 || atlas.options.overlap == UvOverlap::first) return;
    throw Error(
        ExitCode::runtime,
        fmt::format("{}: {} triangles share {} texels with others, so that only one of them "
                    "can be right there; --uv-overlap first shows the first (for mirrored "
                    "or stacked charts), --atlas chart gives each its own texels",
                    name_of(mesh), claims.sharing_triangles, claims.shared_texels));
}

}  // namespace

std::vector<std::uint32_t> udim_tiles(const Mesh& mesh, const Connectivity& connectivity) {
    check_uvs(mesh);
    return tiles_of(mesh, boxes_of(mesh, first_of_charts(mesh, connectivity)));
}

Atlas layout_uvs(const Mesh& mesh, const Connectivity& connectivity, const AtlasOptions& options) {
    check_size(options);
    if (options.columns() > options.size || options.rows() > options.size)
        throw Error(ExitCode::usage,
                    fmt::format("atlas.width and atlas.height must be at most atlas.size, {}",
                                options.size));
    check_uvs(mesh);
    const std::vector<std::uint32_t> first = first_of_charts(mesh, connectivity);
    const std::vector<std::uint32_t> tiles = tiles_of(mesh, boxes_of(mesh, first));
    if (options.tile == 0) check_one_tile(mesh, tiles);
    Atlas atlas;
    atlas.options = options;
    if (options.columns() != options.rows()) {
        atlas.width = options.columns();
        atlas.height = options.rows();
    }
    atlas.notes.texels_total = std::uint64_t{options.columns()} * options.rows();
    place_corners(mesh, atlas);
    number_uv_charts(first, atlas);
    count_overlap(mesh, atlas);
    return atlas;
}

}  // namespace burl
