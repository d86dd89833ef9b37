#pragma once
// The exact filters of the colour map and octaves that fade (procedural/filter.h) in the single
// pass: procedural/glsl_filter.h. Most texels of
// a smooth texture need none, and llvmpipe runs both sides of a branch; so a first draw colours the
// texels whose footprint holds no break of the map and marks them by their depth, and a second one
// averages over the others alone.
#include <memory>
#include <optional>
#include <vector>

#include "app/gl_source.h"
#include "app/gl_target.h"
#include "atlas/solid_atlas.h"
#include "procedural/glsl_filter.h"

namespace burl {

class GlMapFilter {
  public:
    /// Texture units that bind() uses.
    static constexpr int units = 5;

    /// `budget`: of the slope maps kept between calls, in bytes. Without `float64` numbers are
    /// float32.
    GlMapFilter(const GladGLContext& gl, bool float64, std::size_t budget);

    /// The atlas of the calls below, in the texture's space; it must outlive them.
    void set_atlas(const SolidAtlas& solid, const Affine3& texture_from_atlas, int threads);
    /// The atlas is about to change or go away.
    void forget_atlas();
    /// The map and filter of the calls below.
    void set_map(const ColorMap& map, const Filter& filter);
    /// The octaves of the calls below.
    void set_field(std::span<const OctaveGroup> groups);
    /// The quadric and the tile of the draws below: makes their slope map, or finds it.
    void set_tile(const Quadric& quadric, const GlTile& tile) {
        slopes_ = slope_map(quadric, tile);
    }

    /// Whether the filter takes two draws; else the first does it.
    bool has_means() const { return filter_.kind != FilterKind::none; }
    /// For the first draw: `real field(ivec2 texel)` that discards where a break lies in the
    /// footprint of a filter that has means. The colours' parts
    /// follow.
    void add_field(ShaderSource& source, const FieldShape& shape) const;
    /// For the second: `real3 mean_color(ivec2 texel)`.
    void add_means(ShaderSource& source, const FieldShape& shape) const;
    void bind(const GlProgram& program, int first_unit) const;
    /// Both draws, into a target of this size that is bound.
    void draw(const GlFullScreen& full_screen, GlSize target, const GlProgram& straight,
              const GlProgram& bent);

  private:
    struct Tables {
        FilterShape shape;
        FilterUniforms uniforms;
        GlBufferTexture distances;
    };
    struct SlopeMap {
        Quadric quadric;
        GlTile tile;
        std::shared_ptr<const GlTexture> texture;
    };
    void add(ShaderSource& source, const FieldShape& shape) const;
    void set_numbers(const GlProgram& program, const char* name, std::span<const double> values,
                     int components) const;
    std::shared_ptr<const GlTexture> slope_map(const Quadric& quadric, const GlTile& tile);

    const GladGLContext* gl_;
    bool float64_;
    std::size_t budget_, bytes_ = 0;
    const SolidAtlas* solid_ = nullptr;
    Affine3 texture_from_atlas_;
    std::vector<TexelMap> maps_;
    int threads_ = 0;
    std::vector<SlopeMap> kept_;
    std::shared_ptr<const GlTexture> slopes_;
    std::optional<GlBufferTexture> sides_, shares_;
    ColorMap map_;
    Filter filter_;
    std::optional<Tables> tables_;
    GlBufferTexture srgb8_;
    GlRenderbuffer depth_;
    GlSize depth_size_{0};
};

}  // namespace burl
