#pragma once
// An atlas's spans on OpenGL: drawn, each as a quad one texel high, so that every texel has the
// same owner as on the host, by a program that evaluates the map being made
// (shaders/maps/span.glsl); or looked up by texel.
#include <optional>
#include <vector>

#include "app/gl/device/target.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/sample_pattern.h"
#include "procedural/field/lattice_map.h"

namespace burl {

/// The tile as the texel area of the host's fills.
inline TexelArea area_of(const GlTile& tile) {
    return {std::uint32_t(tile.origin.x), std::uint32_t(tile.origin.y), std::uint32_t(tile.size.x),
            std::uint32_t(tile.size.y)};
}

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

/// The inputs of shaders/maps/texel_line.glsl as textures: the span of each texel of an atlas, tile
/// by tile, and the maps of its triangles.
class GlTexelLines {
  public:
    /// The number of texture units that bind() uses.
    static constexpr int units = 2;

    /// Keeps at most `budget` bytes of spans between calls, 16 per texel, and those of one tile
    /// more.
    GlTexelLines(const GladGLContext& gl, std::size_t budget) : gl_(&gl), budget_(budget) {}

    /// Sets the atlas of the following calls, which must outlive them; `maps` are those of its
    /// triangles in the wanted space. Throws Error(unsupported) where they exceed OpenGL's buffer
    /// textures.
    void set_atlas(const SolidAtlas& solid, std::span<const TexelMap> maps, int threads);
    /// Frees everything about the atlas.
    void forget_atlas();
    /// Sets the tile of the following draws: makes its spans where they are not kept.
    void set_tile(const GlTile& tile);
    /// Binds the textures, from unit `first_unit` on, and sets the uniforms of a program in use.
    void bind(const GlProgram& program, int first_unit) const;

  private:
    struct Spans {
        GlTile tile;
        GlTexture texture;
    };
    const GladGLContext* gl_;
    std::size_t budget_;
    const SolidAtlas* solid_ = nullptr;
    int threads_ = 0;
    std::optional<GlBufferTexture> maps_;
    std::vector<Spans> spans_;  ///< the last one belongs to the current tile
};

/// Sets the uniforms of supersample.glsl in a program in use.
inline void bind_pattern(const GlProgram& program, const SamplePattern& pattern) {
    program.set("sample_count", pattern.samples());
    program.set("sample_cells", glm::ivec2(pattern.columns(), pattern.rows()));
}

}  // namespace burl
