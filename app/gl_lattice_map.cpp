#include "app/gl_lattice_map.h"

#include "procedural/synthesize_pieces.h"

namespace burl {

namespace {

TexelArea area_of(const GlTile& tile) {
    return {std::uint32_t(tile.origin.x), std::uint32_t(tile.origin.y), std::uint32_t(tile.size.x),
            std::uint32_t(tile.size.y)};
}

void upload(const GladGLContext& gl, const GlTexture& texture, const Image<MapTexel>& texels) {
    gl.BindTexture(GL_TEXTURE_2D, texture.get());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, GLsizei(texels.width()), GLsizei(texels.height()),
                     GL_RGBA_INTEGER, GL_UNSIGNED_INT, texels.pixels().data());
    check_gl(gl, "uploading a lattice map");
}

}  // namespace

class GlSpans {};

GlLatticeMapper::GlLatticeMapper(const GladGLContext& gl, const SolidAtlas& solid,
                                 const Affine3& texture_from_atlas, int threads, MapFill)
    : gl_(&gl),
      solid_(&solid),
      maps_(moved_maps(solid.maps, texture_from_atlas, threads)),
      threads_(threads) {}

GlLatticeMapper::GlLatticeMapper(GlLatticeMapper&&) noexcept = default;
GlLatticeMapper::~GlLatticeMapper() = default;

GlLatticeMap GlLatticeMapper::make(const std::optional<LatticeStreamKey>& stream,
                                   const std::optional<Quadric>& quadric,
                                   const GlTile& tile) const {
    GlTarget target(*gl_, tile.size, {GL_RGBA32UI, GL_RGBA32UI});
    const LatticeMap map =
        fill_lattice_map(*solid_, maps_, stream, quadric, area_of(tile), threads_);
    upload(*gl_, target.texture(0), map.cells);
    upload(*gl_, target.texture(1), map.places);
    return GlLatticeMap(std::move(target));
}

}  // namespace burl
