// Spans and affine maps from an atlas (Carr & Hart 2001, section 5.1: solid coordinates are
// interpolated over the triangles' image in the texture).
#include "atlas/solid_atlas.h"

#include <algorithm>
#include <cmath>

#include "atlas/block_corners.h"
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

std::array<Vec2d, 3> rotated(const std::array<Vec2d, 3>& corners, std::size_t first) {
    std::array<Vec2d, 3> result;
    for (std::size_t k = 0; k < 3; ++k) result[(first + k) % 3] = corners[k];
    return result;
}

/// The map that shows the block turned by 180 degrees.
TexelMap turned_map(const TexelMap& map, const Block& block) {
    TexelMap turned = map;
    turned.step_x = -map.step_x;
    turned.step_y = -map.step_y;
    turned.anchor_x = static_cast<std::int32_t>(2 * block.x + block.width - 1) - map.anchor_x;
    turned.anchor_y = static_cast<std::int32_t>(2 * block.y + block.height - 1) - map.anchor_y;
    return turned;
}

/// Fills solid.maps and solid.turned.
void make_maps(SolidAtlas& solid, const Mesh& mesh, const Atlas& atlas,
               std::span<const Vec3d> positions) {
    const auto turned = std::ranges::count_if(
        atlas.blocks, [](const Block& block) { return block.fills_up && !block.collapsed(); });
    solid.maps.reserve(mesh.triangles.size() + std::size_t(turned));
    solid.maps.resize(mesh.triangles.size());
    const auto make = [&](const Block& block, std::int32_t face,
                          const std::array<Vec2d, 3>& corners) {
        const auto& [a, b, c] = mesh.triangles[std::size_t(face)];
        solid.maps[std::size_t(face)] =
            texel_map(corners, {positions[a], positions[b], positions[c]}, block);
    };
    for (const Block& block : atlas.blocks) {
        const auto lower = std::size_t(block.lower), upper = std::size_t(block.upper);
        if (block.collapsed()) {
            const BlockCorners sampled = sampled_corners(block);
            make(block, block.lower, rotated(sampled.lower, block.lower_corner));
            if (block.upper >= 0)
                make(block, block.upper, rotated(sampled.upper, block.upper_corner));
            continue;
        }
        make(block, block.lower, atlas.corners[lower]);
        if (block.upper >= 0) make(block, block.upper, atlas.corners[upper]);
        if (!block.fills_up) continue;
        solid.maps.push_back(turned_map(solid.maps[lower], block));
        solid.turned.push_back(static_cast<std::uint32_t>(lower));
    }
}

/// Calls visit(row, span) for every span of the block, the rest of a single by map `rest`.
template <class Visit>
void visit_spans(const Block& block, Overscan mode, std::uint32_t rest, Visit visit) {
    const std::uint32_t first = std::uint32_t(block.lower);
    const std::uint32_t second = block.upper >= 0 ? std::uint32_t(block.upper) : rest;
    for (std::uint32_t j = 0; j < block.height; ++j) {
        const std::uint32_t lower = split(block, mode, j), upper = block.width - lower;
        const std::size_t y = block.y + j;
        if (block.rising && upper > 0) visit(y, Span{block.x, upper, second});
        if (lower > 0) visit(y, Span{block.rising ? block.x + upper : block.x, lower, first});
        if (!block.rising && upper > 0) visit(y, Span{block.x + lower, upper, second});
    }
}

struct BlockSpans {
    const Block* block;
    std::uint32_t rest;  ///< map of the texels that a single does not read
};

/// The atlas's blocks from left to right, so that spans arrive sorted within each row.
std::vector<BlockSpans> left_to_right(const Atlas& atlas, std::size_t triangles) {
    std::vector<BlockSpans> blocks;
    blocks.reserve(atlas.blocks.size());
    auto rest = static_cast<std::uint32_t>(triangles);
    for (const Block& block : atlas.blocks)
        if (!block.shares_texel)
            blocks.push_back({&block, block.fills_up && !block.collapsed() ? rest++ : 0});
    const auto before = [](const BlockSpans& a, const BlockSpans& b) {
        return a.block->x < b.block->x;
    };
    const auto by_rows = [](const BlockSpans& a, const BlockSpans& b) {
        return a.block->y != b.block->y ? a.block->y < b.block->y : a.block->x < b.block->x;
    };
    if (!std::is_sorted(blocks.begin(), blocks.end(), by_rows))
        std::stable_sort(blocks.begin(), blocks.end(), before);
    return blocks;
}

}  // namespace

SolidAtlas rasterize(const Mesh& mesh, const Atlas& atlas, std::span<const Vec3d> positions) {
    SolidAtlas solid;
    solid.size = atlas.options.size;
    make_maps(solid, mesh, atlas, positions);
    const std::vector<BlockSpans> blocks = left_to_right(atlas, mesh.triangles.size());
    const Overscan mode = atlas.options.overscan;
    solid.row_begin.assign(std::size_t{solid.size} + 1, 0);
    for (const auto& [block, rest] : blocks)
        visit_spans(*block, mode, rest,
                    [&](std::size_t y, const Span&) { ++solid.row_begin[y + 1]; });
    for (std::size_t y = 0; y < solid.size; ++y) solid.row_begin[y + 1] += solid.row_begin[y];
    solid.spans.resize(solid.row_begin.back());
    std::vector<std::size_t> next(solid.row_begin.begin(), solid.row_begin.end() - 1);
    for (const auto& [block, rest] : blocks)
        visit_spans(*block, mode, rest,
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
