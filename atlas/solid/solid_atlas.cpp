// Spans and affine maps from an atlas (Carr & Hart 2001, section 5.1: solid coordinates are
// interpolated over the triangles' image in the texture).
#include "atlas/solid/solid_atlas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <tbb/parallel_for.h>

#include "atlas/base/each_index.h"
#include "atlas/solid/block.h"

namespace burl {

namespace {

std::int32_t anchor(double corner, std::uint32_t first, std::uint32_t count) {
    const double last = double(first) + double(count) - 1.0;
    return static_cast<std::int32_t>(std::clamp(std::floor(corner), double(first), last));
}

/// The affine map that takes the triangle's corners in the texture, which have area, to its points,
/// anchored at a texel of its block. Its origin is rounded otherwise than affine_map()'s.
TexelMap texel_map(const std::array<Vec2d, 3>& corners, const std::array<Vec3d, 3>& points,
                   const Block& block) {
    const Vec2d u = corners[1] - corners[0], v = corners[2] - corners[0];
    const Vec3d along_u = points[1] - points[0], along_v = points[2] - points[0];
    const double determinant = cross(u, v);
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

/// The map that shows the block's triangle turned by 180 degrees about the block's centre.
TexelMap turned_map(const TexelMap& map, const Block& block) {
    TexelMap turned = map;
    turned.step_x = -map.step_x;
    turned.step_y = -map.step_y;
    turned.anchor_x = static_cast<std::int32_t>(2 * block.x + block.width - 1) - map.anchor_x;
    turned.anchor_y = static_cast<std::int32_t>(2 * block.y + block.height - 1) - map.anchor_y;
    return turned;
}

/// Whether the block shows its one triangle a second time, turned by 180 degrees, by a map of its
/// own.
bool is_turned(const Block& block) {
    return block.fills_up && !block.collapsed();
}

/// Number, after those of the triangles, of the map that shows each block turned; 0 for blocks
/// without one. Fills solid.turned and makes room for the maps.
std::vector<std::uint32_t> number_maps(SolidAtlas& solid, const Atlas& atlas,
                                       std::size_t triangles) {
    std::vector<std::uint32_t> rest(atlas.blocks.size());
    for (std::size_t i = 0; i < rest.size(); ++i) {
        if (!is_turned(atlas.blocks[i])) continue;
        rest[i] = static_cast<std::uint32_t>(triangles + solid.turned.size());
        solid.turned.push_back(std::uint32_t(atlas.blocks[i].lower));
    }
    solid.maps.resize(triangles + solid.turned.size());
    return rest;
}

/// Sets the maps of a block's triangles; `rest` is the block's number from number_maps().
void make_maps(SolidAtlas& solid, const Mesh& mesh, const Atlas& atlas,
               std::span<const Vec3d> positions, const Block& block, std::uint32_t rest) {
    const auto make = [&](std::int32_t face, const std::array<Vec2d, 3>& corners) {
        const auto& [a, b, c] = mesh.triangles[std::size_t(face)];
        solid.maps[std::size_t(face)] =
            texel_map(corners, {positions[a], positions[b], positions[c]}, block);
    };
    if (block.collapsed()) {
        const BlockCorners sampled = sampled_corners(block);
        make(block.lower, rotated(sampled.lower, block.lower_corner));
        if (block.upper >= 0) make(block.upper, rotated(sampled.upper, block.upper_corner));
        return;
    }
    make(block.lower, atlas.corners[std::size_t(block.lower)]);
    if (block.upper >= 0) make(block.upper, atlas.corners[std::size_t(block.upper)]);
    if (is_turned(block))
        solid.maps[rest] = turned_map(solid.maps[std::size_t(block.lower)], block);
}

/// Rows begin to end - 1 of the texture.
struct Rows {
    std::size_t begin = 0, end = 0;
};

/// Calls visit(row, span) for every span of the block in these rows; texels of a single triangle's
/// block that it does not own are shown by map `rest`.
template <class Visit>
void visit_spans(const Block& block, Overscan mode, std::uint32_t rest, const Rows& rows,
                 Visit visit) {
    const std::uint32_t first = std::uint32_t(block.lower);
    const std::uint32_t second = block.upper >= 0 ? std::uint32_t(block.upper) : rest;
    const std::size_t end = std::min<std::size_t>(block.y + block.height, rows.end);
    for (std::size_t y = std::max<std::size_t>(block.y, rows.begin); y < end; ++y) {
        const std::uint32_t lower = split(block, mode, std::uint32_t(y - block.y)),
                            upper = block.width - lower;
        if (block.rising && upper > 0) visit(y, Span{block.x, upper, second});
        if (lower > 0) visit(y, Span{block.rising ? block.x + upper : block.x, lower, first});
        if (!block.rising && upper > 0) visit(y, Span{block.x + lower, upper, second});
    }
}

/// The texture in bands of rows, which are worked at in parallel, with the numbers of the blocks in
/// each.
class Bands {
  public:
    explicit Bands(const Atlas& atlas)
        : height_(std::max<std::size_t>(1, atlas.options.size / most_bands)),
          begin_((atlas.options.size + height_ - 1) / height_ + 2) {
        each_band(atlas, [&](std::uint32_t, std::size_t band) { ++begin_[band + 2]; });
        for (std::size_t i = 2; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
        blocks_.resize(begin_.back());
        each_band(atlas, [&](std::uint32_t block, std::size_t band) {
            blocks_[begin_[band + 1]++] = block;
        });
        begin_.pop_back();
        tbb::parallel_for(std::size_t(0), count(), [&](std::size_t band) {
            std::ranges::sort(blocks_of(band), {}, [&](std::uint32_t block) {
                return std::pair(atlas.blocks[block].x, block);
            });
        });
    }

    std::size_t count() const { return begin_.size() - 1; }
    /// Numbers of the band's blocks from left to right, so that spans come sorted within each row.
    std::span<std::uint32_t> blocks_of(std::size_t band) {
        return {blocks_.data() + begin_[band], blocks_.data() + begin_[band + 1]};
    }
    Rows rows_of(std::size_t band) const { return {band * height_, (band + 1) * height_}; }

  private:
    static constexpr std::uint32_t most_bands = 64;

    template <class Visit>
    void each_band(const Atlas& atlas, Visit visit) const {
        for (std::uint32_t i = 0; i < atlas.blocks.size(); ++i) {
            const Block& block = atlas.blocks[i];
            if (block.shares_texel) continue;
            const std::size_t last = (block.y + block.height - 1) / height_;
            for (std::size_t band = block.y / height_; band <= last; ++band) visit(i, band);
        }
    }

    std::size_t height_;
    std::vector<std::size_t> begin_;
    std::vector<std::uint32_t> blocks_;
};

/// Fills solid.row_begin and solid.spans; `rest` is the result of number_maps().
void make_spans(SolidAtlas& solid, const Atlas& atlas, std::span<const std::uint32_t> rest) {
    Bands bands(atlas);
    const auto visit_all = [&](const auto& visit) {
        tbb::parallel_for(std::size_t(0), bands.count(), [&](std::size_t band) {
            for (const std::uint32_t i : bands.blocks_of(band))
                visit_spans(atlas.blocks[i], atlas.options.overscan, rest[i], bands.rows_of(band),
                            visit);
        });
    };
    solid.row_begin.assign(std::size_t{solid.size} + 1, 0);
    visit_all([&](std::size_t y, const Span&) { ++solid.row_begin[y + 1]; });
    for (std::size_t y = 0; y < solid.size; ++y) solid.row_begin[y + 1] += solid.row_begin[y];
    solid.spans.resize(solid.row_begin.back());
    std::vector<std::size_t> next(solid.row_begin.begin(), solid.row_begin.end() - 1);
    visit_all([&](std::size_t y, const Span& span) { solid.spans[next[y]++] = span; });
}

}  // namespace

TexelMap affine_map(const std::array<Vec2d, 3>& places, const std::array<Vec3d, 3>& points,
                    const std::array<std::uint32_t, 2>& low,
                    const std::array<std::uint32_t, 2>& sides) {
    TexelMap map;
    map.origin = points[0];
    const Vec2d u = places[1] - places[0], v = places[2] - places[0];
    const double det = cross(u, v);
    if (!std::isfinite(det)) return map;
    map.anchor_x = anchor(places[0].x, low[0], sides[0]);
    map.anchor_y = anchor(places[0].y, low[1], sides[1]);
    if (det == 0.0) return map;
    const Vec3d along_u = points[1] - points[0], along_v = points[2] - points[0];
    map.step_x = (along_u * v.y - along_v * u.y) / det;
    map.step_y = (along_v * u.x - along_u * v.x) / det;
    map.origin += (map.anchor_x + 0.5 - places[0].x) * map.step_x +
                  (map.anchor_y + 0.5 - places[0].y) * map.step_y;
    return map;
}

SolidAtlas rasterize(const Mesh& mesh, const Atlas& atlas, std::span<const Vec3d> positions) {
    SolidAtlas solid;
    solid.size = atlas.options.size;
    const std::vector<std::uint32_t> rest = number_maps(solid, atlas, mesh.triangles.size());
    for_each_index(atlas.blocks.size(), [&](std::size_t i) {
        make_maps(solid, mesh, atlas, positions, atlas.blocks[i], rest[i]);
    });
    make_spans(solid, atlas, rest);
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
    std::vector<Vec3d> mapped(mesh.positions.size());
    for_each_index(mapped.size(), [&](std::size_t i) { mapped[i] = map(mesh.positions[i]); });
    return mapped;
}

}  // namespace burl
