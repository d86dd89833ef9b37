#pragma once
// The inputs of shaders/maps/texel_line.glsl: the span of each texel of an atlas, and the maps of
// its triangles.
#include <optional>
#include <vector>

#include "app/gl/device/target.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/sample_pattern.h"

namespace burl {

/// The spans of texels, tile by tile, and the triangles' maps as textures.
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
