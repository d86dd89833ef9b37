#include "app/gl/fill/lattice_map.h"

#include <cmath>

#include "procedural/fill/pieces.h"
#include "procedural/maps/lattice_map.h"
#include "procedural/maps/point_map.h"
#include "procedural/noise/lattice_site.h"

namespace burl {

namespace {

void set_stream(const GlProgram& program, const LatticeStreamKey& stream) {
    program.set("lattice_linear", stream.lattice_from_solid.linear);
    program.set("lattice_offset", stream.lattice_from_solid.offset);
    program.set("coordinate_limit", std::ldexp(lattice_limit, -stream.doublings));
    program.set("period", stream.period);
    program.set("per_period", stream.period > 0.0 ? 1.0 / stream.period : 0.0);
}

void set_quadric(const GlProgram& program, const Quadric& q) {
    program.set("quadric", Mat3d(q.a, q.b, q.c, q.b, q.e, q.f, q.c, q.f, q.h));
    program.set("quadric_slope", Vec3d(q.d, q.g, q.i));
    program.set("quadric_constant", q.j + 0.0);  // no negative zero, as on the host
}

/// Sets the map of points of a program with line.vert, which is in use. With `in_lattice`, spans
/// that reach lattice_limit on an axis are at 0 on that axis.
void set_line(const GlProgram& program, const Affine3& map, bool in_lattice) {
    program.set("line_linear", map.linear);
    program.set("line_offset", map.offset);
    program.set("line_limit", in_lattice ? lattice_limit : 0.0);
}

/// The number of texels of a strip: 2 MiB of a lattice map.
constexpr int strip_texels = 1 << 16;

/// Calls visit(strip, its first row in the tile) for strips of whole rows that cover the tile. The
/// host fills maps in strips: each is uploaded while it lies in the processor's cache, and the host
/// never holds a whole map.
template <class Visit>
void for_strips(const GlTile& tile, Visit visit) {
    const int rows = std::max(1, strip_texels / std::max(1, tile.size.x));
    for (int y = 0; y < tile.size.y; y += rows)
        visit(GlTile{{tile.origin.x, tile.origin.y + y},
                     {tile.size.x, std::min(rows, tile.size.y - y)}},
              y);
}

/// Uploads rows, from `first_row` on, of a target's texture with the image's width and type.
template <class Texel>
void upload(const GladGLContext& gl, const GlTarget& target, std::size_t number, int first_row,
            const Image<Texel>& texels) {
    const GlFormat& format = target.format(number);
    gl.BindTexture(GL_TEXTURE_2D, target.texture(number).get());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, first_row, GLsizei(texels.width()),
                     GLsizei(texels.height()), format.layout, format.type, texels.pixels().data());
    check_gl(gl, "uploading a map of an atlas");
}

/// The bytes of a map of the tile.
std::size_t map_bytes(const GlTile& tile) {
    return 2 * sizeof(MapTexel) * tile.texels();
}

}  // namespace

/// The spans and the programs that draw the maps.
struct GlLatticeMapper::Drawing {
    GlSpans spans;
    GlProgram streams, points;
};

GlLatticeMapper::GlLatticeMapper(const GladGLContext& gl, const SolidAtlas& solid,
                                 std::vector<TexelMap> maps, int threads, MapFill fill)
    : gl_(&gl), solid_(&solid), maps_(std::move(maps)), threads_(threads) {
    if (draws_maps(gl, solid, fill))
        drawing_ = std::make_unique<Drawing>(
            Drawing{GlSpans(gl, solid, maps_),
                    GlSpans::make_program(gl, "maps/lattice_map.vert", "maps/lattice_map.frag"),
                    GlSpans::make_program(gl, "maps/line.vert", "maps/point_map.frag")});
}

GlLatticeMapper::GlLatticeMapper(GlLatticeMapper&&) noexcept = default;
GlLatticeMapper::~GlLatticeMapper() = default;

GlLatticeMap GlLatticeMapper::make(const std::optional<LatticeStreamKey>& stream,
                                   const std::optional<Quadric>& quadric,
                                   const GlTile& tile) const {
    GlTarget target(*gl_, tile.size, {GL_RGBA32UI, GL_RGBA32UI});
    const LatticeStreamKey nowhere{{Mat3d(0.0), Vec3d(0.0)}, 0, 0.0};
    if (drawing_)
        draw(stream.value_or(nowhere), quadric.value_or(Quadric{}), tile, target);
    else
        fill(stream, quadric, tile, target);
    return GlLatticeMap(std::move(target));
}

void GlLatticeMapper::draw(const LatticeStreamKey& stream, const Quadric& quadric,
                           const GlTile& tile, const GlTarget& target) const {
    target.clear(0, glm::uvec4(0, 0, 0, std::uint32_t(no_quadric >> 32)));
    target.clear(1, glm::uvec4(0, 0, 0, std::uint32_t(no_quadric)));
    drawing_->streams.use();
    set_stream(drawing_->streams, stream);
    set_quadric(drawing_->streams, quadric);
    drawing_->spans.draw(drawing_->streams, tile);
}

void GlLatticeMapper::fill(const std::optional<LatticeStreamKey>& stream,
                           const std::optional<Quadric>& quadric, const GlTile& tile,
                           const GlTarget& target) const {
    for_strips(tile, [&](const GlTile& strip, int row) {
        const LatticeMap map =
            fill_lattice_map(*solid_, maps_, stream, quadric, area_of(strip), threads_);
        upload(*gl_, target, 0, row, map.cells);
        upload(*gl_, target, 1, row, map.places);
    });
}

GlPointMap GlLatticeMapper::make_points(const Affine3& map, bool in_lattice,
                                        const GlTile& tile) const {
    GlTarget target(*gl_, tile.size, {GL_RGBA32UI, GL_RGBA32UI});
    if (drawing_) {
        const auto upper = std::uint32_t(no_quadric >> 32), lower = std::uint32_t(no_quadric);
        target.clear(0, glm::uvec4(lower, upper, lower, upper));
        target.clear(1, glm::uvec4(lower, upper, no_owner, 0));
        drawing_->points.use();
        set_line(drawing_->points, map, in_lattice);
        drawing_->spans.draw(drawing_->points, tile);
    } else {
        for_strips(tile, [&](const GlTile& strip, int row) {
            const PointMap points =
                fill_point_map(*solid_, maps_, map, in_lattice, area_of(strip), threads_);
            upload(*gl_, target, 0, row, points.xy);
            upload(*gl_, target, 1, row, points.z_owner);
        });
    }
    return GlPointMap(std::move(target));
}

void GlMapCache::set_atlas(const SolidAtlas& solid,
                           const std::optional<Affine3>& texture_from_atlas, int threads) {
    if (mapper_ && solid_ == &solid && texture_from_atlas_ == texture_from_atlas) return;
    forget_atlas();
    mapper_.emplace(
        *gl_, solid,
        texture_from_atlas ? moved_maps(solid.maps, *texture_from_atlas, threads) : solid.maps,
        threads);
    solid_ = &solid;
    texture_from_atlas_ = texture_from_atlas;
}

void GlMapCache::forget_atlas() {
    lattices_.clear();
    points_.clear();
    bytes_ = 0;
    mapper_.reset();
    solid_ = nullptr;
}

template <class Key, class Map, class Make>
std::shared_ptr<const Map> GlMapCache::found(std::vector<Kept<Key, Map>>& kept, const Key& key,
                                             const GlTile& tile, const Make& make) {
    for (auto& one : kept)
        if (one.key == key && one.tile == tile) {
            one.used = true;
            return one.map;
        }
    ++made_;
    auto map = std::make_shared<const Map>(make());
    if (bytes_ + map_bytes(tile) <= budget_) {
        bytes_ += map_bytes(tile);
        kept.push_back({key, tile, map});
    }
    return map;
}

std::shared_ptr<const GlLatticeMap> GlMapCache::map(const std::optional<LatticeStreamKey>& stream,
                                                    const std::optional<Quadric>& quadric,
                                                    const GlTile& tile) {
    return found(lattices_, LatticeKey{stream, quadric}, tile,
                 [&] { return mapper_->make(stream, quadric, tile); });
}

std::shared_ptr<const GlPointMap> GlMapCache::points(const Affine3& map, bool in_lattice,
                                                     const GlTile& tile) {
    return found(points_, PointKey{map, in_lattice}, tile,
                 [&] { return mapper_->make_points(map, in_lattice, tile); });
}

template <class Maps>
void GlMapCache::drop_unused(Maps& maps) {
    std::erase_if(maps, [&](const auto& kept) {
        if (!kept.used) bytes_ -= map_bytes(kept.tile);
        return !kept.used;
    });
    for (auto& kept : maps) kept.used = false;
}

void GlMapCache::drop_unused() {
    drop_unused(lattices_);
    drop_unused(points_);
}

}  // namespace burl
