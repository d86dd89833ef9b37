#pragma once
// An atlas's spans drawn by OpenGL, each as a quad one texel high, so that every texel has the same
// owner as on the host, by a program that evaluates the map being made (shaders/maps/span.glsl).
#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// The way in which maps of an atlas are filled.
enum class MapFill {
    automatic,  ///< drawn unless OpenGL is software or cannot, else by the host
    host,       ///< filled by the host, then uploaded
    gpu         ///< drawn by OpenGL; needs OpenGL 4.0 (float64)
};

/// Whether OpenGL draws the maps of an atlas.
bool draws_maps(const GladGLContext& gl, const SolidAtlas& solid, MapFill fill);

/// The spans and triangles' maps of an atlas as OpenGL buffers.
class GlSpans {
  public:
    /// Uploads the spans of `solid` and `maps`, those of solid.maps in the wanted space. Throws
    /// Error(unsupported) where OpenGL has no float64 (4.0 brings it) or its buffer textures are
    /// too small.
    GlSpans(const GladGLContext& gl, const SolidAtlas& solid, std::span<const TexelMap> maps);

    /// A program for draw(): `vertex` follows maps/span.glsl, `fragment` follows maps/line.glsl.
    /// Names are those of embedded_shaders().
    static GlProgram make_program(const GladGLContext& gl, std::string_view vertex,
                                  std::string_view fragment);

    /// Draws the spans' texels in `tile` with the program in use; the bound target has the tile's
    /// size. Uses texture unit 0.
    void draw(const GlProgram& program, const GlTile& tile) const;

  private:
    const GladGLContext* gl_;
    GlVertexArray vertices_;
    GlBuffer spans_, rows_;
    GlBufferTexture maps_;
    std::vector<std::size_t> row_begin_;
};

/// Sets the map of points of a program with line.vert, which is in use. With `in_lattice`, spans
/// that reach lattice_limit on an axis are at 0 on that axis.
void set_line(const GlProgram& program, const Affine3& map, bool in_lattice);

}  // namespace burl
