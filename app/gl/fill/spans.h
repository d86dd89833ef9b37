#pragma once
// An atlas's spans on the graphics processor: each is drawn as a quad one texel high, so that every
// texel has the owner that the host gives it, by a program that works out what the map being made
// shows (shaders/maps/span.glsl).
#include "app/gl/device/source.h"
#include "app/gl/device/target.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

enum class MapFill {
    automatic,  ///< whichever is faster here
    host,       ///< filled by the host, then uploaded
    gpu         ///< drawn; needs OpenGL 4.0 (float64)
};

/// Whether the graphics processor fills an atlas's maps.
bool draws_maps(const GladGLContext& gl, const SolidAtlas& solid, MapFill fill);

class GlSpans {
  public:
    /// `maps` are those of solid.maps in the space wanted; both are copied. Throws
    /// Error(unsupported) where OpenGL has no float64 (4.0 brings it) or too small arrays.
    GlSpans(const GladGLContext& gl, const SolidAtlas& solid, std::span<const TexelMap> maps);

    /// A program for draw(): `vertex` comes after maps/span.glsl, `fragment` after maps/line.glsl.
    /// Names are those of embedded_shaders().
    static GlProgram make_program(const GladGLContext& gl, std::string_view vertex,
                                  std::string_view fragment);

    /// Draws the spans' texels in `tile` with the program in use; the target bound has the tile's
    /// size. Buffer texture unit 0 is taken.
    void draw(const GlProgram& program, const GlTile& tile) const;

  private:
    const GladGLContext* gl_;
    GlVertexArray vertices_;
    GlBuffer spans_, rows_;
    GlBufferTexture maps_;
    std::vector<std::size_t> row_begin_;
};

/// Of a program with line.vert: points are mapped; with `in_lattice`, spans that reach
/// lattice_limit on an axis are at 0 on it.
void set_line(const GlProgram& program, const Affine3& map, bool in_lattice);

}  // namespace burl
