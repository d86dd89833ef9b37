#pragma once
// Maps of an atlas filled by the host in strips of rows: each strip is uploaded while it lies in
// the processor's cache, and the host never holds a whole map.
#include <algorithm>

#include "app/gl/device/target.h"
#include "atlas/base/image.h"
#include "procedural/field/lattice_map.h"

namespace burl {

/// The tile as the texel area of the host's fills.
inline TexelArea area_of(const GlTile& tile) {
    return {std::uint32_t(tile.origin.x), std::uint32_t(tile.origin.y), std::uint32_t(tile.size.x),
            std::uint32_t(tile.size.y)};
}

/// The number of texels of a strip: 2 MiB of a lattice map.
inline constexpr int strip_texels = 1 << 16;

/// Calls visit(strip, its first row in the tile) for strips of whole rows that cover the tile.
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

}  // namespace burl
