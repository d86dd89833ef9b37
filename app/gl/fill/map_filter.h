#pragma once
// Filters and fading octaves (procedural/batch/filter.h) of the single pass:
// procedural/glsl/filter.h, glsl_line_field.h. With the exact filters most texels of a smooth
// texture need no mean, but llvmpipe runs both sides of a branch. So a first draw colours the
// texels whose footprint contains no break of the colour map and marks them by their depth, and a
// second draw averages over the others alone.
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/gl/fill/spans.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/glsl/filter.h"
#include "procedural/glsl/line_field.h"

namespace burl {

/// Shader parts, tables and draws of a filter of colour maps.
class GlMapFilter {
  public:
    /// The largest number of texture units that bind() uses.
    static int units(const FieldShape& shape) {
        return 6 + (shape.lone.empty() ? 0 : GlTexelLines::units);
    }

    /// `budget` limits, in bytes, the slope maps and spans that are kept between calls. Without
    /// `float64` numbers are float32.
    GlMapFilter(const GladGLContext& gl, bool float64, std::size_t budget);

    /// Sets the atlas of the following calls, in the texture's space; it must outlive them. 0
    /// threads means all.
    void set_atlas(const SolidAtlas& solid, const Affine3& texture_from_atlas, int threads);
    /// Drops everything about the atlas; must be called before it changes or is destroyed.
    void forget_atlas();
    /// Sets the colour map and filter of the following calls.
    void set_map(const ColorMap& map, const Filter& filter);
    /// Sets the octaves and quadric of the following calls.
    void set_field(const FieldOctaves& octaves, const Quadric& quadric);
    /// Sets the tile of the following draws: makes its slope map and spans where they are not kept.
    void set_tile(const GlTile& tile);

    /// Whether there is a draw of colours at the texels' centres. Where has_means() holds, too, it
    /// leaves texels to the draw of means.
    bool has_colors() const { return !sampled() && !tabled(); }
    /// Whether there is a draw of means over the texels.
    bool has_means() const { return filter_.kind != FilterKind::none; }
    /// Whether the draw of means reads `real3 linear_color(real f)`.
    bool means_read_colors() const { return sampled(); }
    /// Adds, for the draw of colours, `real field(ivec2 texel)`, which discards texels with a break
    /// in the footprint of a filter that has means. The colours' parts follow.
    void add_field(ShaderSource& source, const FieldShape& shape) const;
    /// Adds, for the draw of means, `real3 mean_color(ivec2 texel)`.
    void add_means(ShaderSource& source, const FieldShape& shape) const;
    /// Binds the textures, from unit `first_unit` on, and the uniforms of a program in use.
    void bind(const GlProgram& program, int first_unit) const;
    /// Draws colours and then means into the bound target of this size.
    void draw(const GlFullScreen& full_screen, GlSize target, const GlProgram& straight,
              const GlProgram& bent);

  private:
    /// The colour map's breaks, for the exact filters.
    struct Pieces {
        FilterShape shape;
        FilterUniforms uniforms;
        GlBufferTexture distances;
    };
    /// The averaged colour map, for the filters of the 1999 paper.
    struct Table {
        GlBufferTexture colors;
        Vec3d background{0.0};
        /// The uniforms of color_sums.glsl.
        double first = 0.0;
        int count = 0;
        std::array<Vec3d, 2> ends{};
    };
    struct SlopeMap {
        Quadric quadric;
        GlTile tile;
        std::shared_ptr<const GlTexture> texture;
    };
    /// Adds the parts that both draws share.
    void add(ShaderSource& source, const FieldShape& shape) const;
    bool sampled() const { return filter_.kind == FilterKind::supersample; }
    bool tabled() const {
        return filter_.kind == FilterKind::table_mip || filter_.kind == FilterKind::table_sat ||
               filter_.kind == FilterKind::table_sat3;
    }
    /// Whether fields are evaluated beside the texels' centres; otherwise at the centres, with
    /// their slopes.
    bool beside_centres() const { return sampled() || filter_.kind == FilterKind::trapezoid2; }
    /// Whether shaders read the texels' spans.
    bool has_lines() const { return beside_centres() || lone_octaves_; }
    void make_table();
    std::shared_ptr<const GlTexture> slope_map(const GlTile& tile);
    void bind_pieces(const GlProgram& program, int unit) const;
    void bind_table(const GlProgram& program, int unit) const;
    void bind_lines(const GlProgram& program, int first_unit) const;

    const GladGLContext* gl_;
    bool float64_;
    std::size_t budget_, bytes_ = 0;
    const SolidAtlas* solid_ = nullptr;
    Affine3 texture_from_atlas_;
    std::vector<TexelMap> maps_;
    int threads_ = 0;
    std::vector<SlopeMap> kept_;
    std::shared_ptr<const GlTexture> slopes_;
    GlTexelLines lines_;
    bool lines_known_ = false;   ///< whether lines_ holds the atlas
    bool lone_octaves_ = false;  ///< whether the field has octaves without a stream kernel
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
