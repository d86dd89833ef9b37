#include "app/gl/fill/lattice_map.h"

#include <cmath>

#include "app/gl/fill/map_upload.h"
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

}  // namespace

/// The spans and the programs that draw the maps.
struct GlLatticeMapper::Drawing {
    GlSpans spans;
    GlProgram streams, points;
};

GlLatticeMapper::GlLatticeMapper(const GladGLContext& gl, const SolidAtlas& solid,
                                 const Affine3& texture_from_atlas, int threads, MapFill fill)
    : GlLatticeMapper(gl, solid, moved_maps(solid.maps, texture_from_atlas, threads), threads,
                      fill) {}

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

}  // namespace burl
