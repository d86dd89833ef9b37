// Spans and affine maps from an atlas (Carr & Hart 2001, section 5.1: solid coordinates are
// interpolated over the triangles' image in the texture).
#include "atlas/solid_atlas.h"

#include <algorithm>
#include <cmath>

#include "atlas/overscan.h"

namespace burl {

namespace {

std::int32_t anchor(double corner, std::uint32_t first, std::uint32_t count) {
    const double last = double(first) + double(count) - 1.0;
    return static_cast<std::int32_t>(std::clamp(std::floor(corner), double(first), last));
}

/// The affine map that takes the triangle's corners in the texture to its points.
TexelMap texel_map(const std::array<Vec2d, 3>& corners, const std::array<Vec3d, 3>& points,
                   const Block& block) {
    const Vec2d u = corners[1] - corners[0], v = corners[2] - corners[0];
    const Vec3d along_u = points[1] - points[0], along_v = points[2] - points[0];
    const double determinant = u.x * v.y - u.y * v.x;
    TexelMap map;
    map.step_x = (along_u * v.y - along_v * u.y) / determinant;
    map.step_y = (along_v * u.x - along_u * v.x) / determinant;
    map.anchor_x = anchor(corners[0].x, block.x, block.width);
    map.anchor_y = anchor(corners[0].y, block.y, block.height);
    const Vec2d from_corner{map.anchor_x + 0.5 - corners[0].x, map.anchor_y + 0.5 - corners[0].y};
    map.origin = points[0] + from_corner.x * map.step_x + from_corner.y * map.step_y;
    return map;
}

std::vector<TexelMap> texel_maps(const Mesh& mesh, const Atlas& atlas,
                                 std::span<const Vec3d> positions) {
    std::vector<TexelMap> maps(mesh.triangles.size());
    for (const Block& block : atlas.blocks) {
        for (const std::int32_t face : {block.lower, block.upper}) {
            if (face < 0) continue;
            const auto t = static_cast<std::size_t>(face);
            const auto& [a, b, c] = mesh.triangles[t];
            maps[t] =
                texel_map(atlas.corners[t], {positions[a], positions[b], positions[c]}, block);
        }
    }
    return maps;
}

/// Calls visit(row, span) for every span of the block.
template <class Visit>
void visit_spans(const Block& block, Overscan mode, Visit visit) {
    for (std::uint32_t j = 0; j < block.height; ++j) {
        const std::uint32_t lower = split(block, mode, j), upper = block.width - lower;
        const std::size_t y = block.y + j;
        if (lower > 0) visit(y, Span{block.x, lower, std::uint32_t(block.lower)});
        if (upper > 0) visit(y, Span{block.x + lower, upper, std::uint32_t(block.upper)});
    }
}

/// The atlas's blocks from left to right, so that spans arrive sorted within each row.
std::vector<const Block*> left_to_right(const Atlas& atlas) {
    std::vector<const Block*> blocks;
    for (const Block& block : atlas.blocks) blocks.push_back(&block);
    const auto before = [](const Block* a, const Block* b) { return a->x < b->x; };
    const auto by_rows = [](const Block* a, const Block* b) {
        return a->y != b->y ? a->y < b->y : a->x < b->x;
    };
    if (!std::is_sorted(blocks.begin(), blocks.end(), by_rows))
        std::stable_sort(blocks.begin(), blocks.end(), before);
    return blocks;
}

}  // namespace

SolidAtlas rasterize(const Mesh& mesh, const Atlas& atlas, std::span<const Vec3d> positions) {
    SolidAtlas solid;
    solid.size = atlas.options.size;
    solid.maps = texel_maps(mesh, atlas, positions);
    const std::vector<const Block*> blocks = left_to_right(atlas);
    const Overscan mode = atlas.options.overscan;
    solid.row_begin.assign(std::size_t{solid.size} + 1, 0);
    for (const Block* block : blocks)
        visit_spans(*block, mode, [&](std::size_t y, const Span&) { ++solid.row_begin[y + 1]; });
    for (std::size_t y = 0; y < solid.size; ++y) solid.row_begin[y + 1] += solid.row_begin[y];
    solid.spans.resize(solid.row_begin.back());
    std::vector<std::size_t> next(solid.row_begin.begin(), solid.row_begin.end() - 1);
    for (const Block* block : blocks)
        visit_spans(*block, mode,
                    [&](std::size_t y, const Span& span) { solid.spans[next[y]++] = span; });
    return solid;
}

Affine3 solid_from_mesh(const Mesh& mesh, SolidSpace space) {
    Affine3 map;
    if (space == SolidSpace::object) return map;
    const Box3 box = bounding_box(mesh);
    const Vec3d half = 0.5 * box.high - 0.5 * box.low;  // halves: no overflow
    const double scale = 0.5 / std::max({half.x, half.y, half.z});
    if (!std::isfinite(scale)) return {Mat3d(1.0), -box.centre()};
    return {Mat3d(scale), -scale * box.centre()};
}

std::vector<Vec3d> map_positions(const Mesh& mesh, const Affine3& map) {
    std::vector<Vec3d> mapped;
    mapped.reserve(mesh.positions.size());
    for (const Vec3d& p : mesh.positions) mapped.push_back(map(p));
    return mapped;
}

}  // namespace burl
