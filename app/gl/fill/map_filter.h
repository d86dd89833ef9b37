#pragma once
// Filters and octaves that fade (procedural/batch/filter.h) in the single pass:
// procedural/glsl/filter.h, glsl_line_field.h. Of the exact filters most texels of a smooth texture
// need none, and llvmpipe runs both sides of a branch; so a first draw colours the texels whose
// footprint holds no break of the map and marks them by their depth, and a second one averages over
// the others alone.
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/gl/device/real_uniforms.h"
#include "app/gl/device/source.h"
#include "app/gl/fill/texel_lines.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/glsl/filter.h"
#include "procedural/glsl/line_field.h"

namespace burl {

class GlMapFilter {
  public:
    /// Texture units that bind() uses at most.
    static int units(const FieldShape& shape) {
        return 6 + (shape.lone.empty() ? 0 : GlTexelLines::units);
    }

    /// `budget`: of the slope maps, or spans, kept between calls, in bytes. Without `float64`
    /// numbers are float32.
    GlMapFilter(const GladGLContext& gl, bool float64, std::size_t budget);

    /// The atlas of the calls below, in the texture's space; it must outlive them.
    void set_atlas(const SolidAtlas& solid, const Affine3& texture_from_atlas, int threads);
    /// The atlas is about to change or go away.
    void forget_atlas();
    /// The map and filter of the calls below.
    void set_map(const ColorMap& map, const Filter& filter);
    /// The octaves of the calls below.
    void set_field(const FieldOctaves& octaves, const Quadric& quadric);
    /// The tile of the draws below: makes its slope map or spans, or finds them.
    void set_tile(const GlTile& tile);

    /// Whether there is a draw of colours at the texels' centres, and one of means: with both the
    /// first leaves texels to the second.
    bool has_colors() const { return !sampled() && !tabled(); }
    bool has_means() const { return filter_.kind != FilterKind::none; }
    /// Whether the second one reads `real3 linear_color(real f)`.
    bool means_read_colors() const { return sampled(); }
    /// For the first draw: `real field(ivec2 texel)` that discards where a break lies in the
    /// footprint of a filter that has means. The colours' parts follow.
    void add_field(ShaderSource& source, const FieldShape& shape) const;
    /// For the second: `real3 mean_color(ivec2 texel)`.
    void add_means(ShaderSource& source, const FieldShape& shape) const;
    void bind(const GlProgram& program, int first_unit) const;
    /// Both draws, into a target of this size that is bound.
    void draw(const GlFullScreen& full_screen, GlSize target, const GlProgram& straight,
              const GlProgram& bent);

  private:
    /// Of the exact filters.
    struct Pieces {
        FilterShape shape;
        FilterUniforms uniforms;
        GlBufferTexture distances;
    };
    /// Of the 1999 paper's.
    struct Table {
        GlBufferTexture colors;
        Vec3d background{0.0};
        double first = 0.0;  ///< and the rest: color_sums.glsl
        int count = 0;
        std::array<Vec3d, 2> ends{};
    };
    struct SlopeMap {
        Quadric quadric;
        GlTile tile;
        std::shared_ptr<const GlTexture> texture;
    };
    void add(ShaderSource& source, const FieldShape& shape) const;
    bool sampled() const { return filter_.kind == FilterKind::supersample; }
    bool tabled() const {
        return filter_.kind == FilterKind::table_mip || filter_.kind == FilterKind::table_sat ||
               filter_.kind == FilterKind::table_sat3;
    }
    /// Whether fields are evaluated beside the texels' centres; else with their slopes.
    bool beside_centres() const { return sampled() || filter_.kind == FilterKind::trapezoid2; }
    /// Whether texels' lines are read.
    bool has_lines() const { return beside_centres() || lone_octaves_; }
    void make_table();
    std::shared_ptr<const GlTexture> slope_map(const GlTile& tile);
    void bind_pieces(const GlProgram& program, int unit) const;
    void bind_table(const GlProgram& program, int unit) const;
    void bind_lines(const GlProgram& program, int first_unit) const;

    const GladGLContext* gl_;
    GlRealUniforms reals_;
    std::size_t budget_, bytes_ = 0;
    const SolidAtlas* solid_ = nullptr;
    Affine3 texture_from_atlas_;
    std::vector<TexelMap> maps_;
    int threads_ = 0;
    std::vector<SlopeMap> kept_;
    std::shared_ptr<const GlTexture> slopes_;
    GlTexelLines lines_;
    bool lines_known_ = false;   ///< of the atlas
    bool lone_octaves_ = false;  ///< of the field, without a stream kernel
    Quadric quadric_;
    LineUniforms line_uniforms_;
    std::optional<GlBufferTexture> sides_, shares_, lone_terms_;
    ColorMap map_;
    Filter filter_;
    bool map_known_ = false;
    std::optional<Pieces> pieces_;
    std::optional<Table> table_;
    GlBufferTexture srgb8_;
    GlRenderbuffer depth_;
    GlSize depth_size_{0};
};

}  // namespace burl
