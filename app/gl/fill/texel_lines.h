#pragma once
// What shaders/maps/texel_line.glsl reads: the spans of an atlas's texels, and the maps of its
// triangles.
#include <optional>
#include <vector>

#include "app/gl/device/target.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/sample_pattern.h"

namespace burl {

class GlTexelLines {
  public:
    /// Texture units that bind() uses.
    static constexpr int units = 2;

    /// Keeps at most `budget` bytes of spans between calls, 16 a texel, and those of one tile.
    GlTexelLines(const GladGLContext& gl, std::size_t budget) : gl_(&gl), budget_(budget) {}

    /// The atlas of the calls below, which must outlive them; `maps` are those of its triangles in
    /// the space wanted. Throws Error(unsupported) for more of them than this OpenGL's arrays hold.
    void set_atlas(const SolidAtlas& solid, std::span<const TexelMap> maps, int threads);
    /// The tile of the draws below: makes its spans, or finds them.
    void set_tile(const GlTile& tile);
    /// For a program in use.
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
    std::vector<Spans> spans_;  ///< the last one of the tile at hand
};

/// What supersample.glsl reads, of a program in use.
inline void bind_pattern(const GlProgram& program, const SamplePattern& pattern) {
    program.set("sample_count", pattern.samples());
    program.set("sample_cells", glm::ivec2(pattern.columns(), pattern.rows()));
}

}  // namespace burl
