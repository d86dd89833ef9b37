#include "app/gl/fill/solid_map.h"

#include "app/gl/fill/map_upload.h"

namespace burl {

namespace {

GlTarget target_of(const GladGLContext& gl, const GlTile& tile) {
    return GlTarget(gl, tile.size, {GL_RGBA32F, GL_R32UI});
}

void draw(const GladGLContext& gl, const SolidAtlas& solid, const Affine3& map, const Vec3d& base,
          const GlTile& tile, const GlTarget& target) {
    const GlSpans spans(gl, solid, solid.maps);
    const GlProgram program = GlSpans::make_program(gl, "maps/line.vert", "maps/solid_map.frag");
    target.clear(0, Vec4f(0.0f));
    target.clear(1, glm::uvec4(no_owner));
    program.use();
    set_line(program, map, false);
    program.set("base", base);
    spans.draw(program, tile);
}

}  // namespace

GlSolidMap make_solid_map(const GladGLContext& gl, const SolidAtlas& solid, const Affine3& map,
                          const Vec3d& base, const GlTile& tile, int threads, MapFill fill) {
    GlTarget target = target_of(gl, tile);
    if (draws_maps(gl, solid, fill)) {
        draw(gl, solid, map, base, tile, target);
    } else {
        for_strips(tile, [&](const GlTile& strip, int row) {
            const SolidMap filled = fill_solid_map(solid, map, base, area_of(strip), threads);
            upload(gl, target, 0, row, filled.local);
            upload(gl, target, 1, row, filled.owners);
        });
    }
    return {std::move(target), base};
}

}  // namespace burl
