#pragma once
// A colour map's tables (procedural/glsl/colors.h) where shaders read them, and the parts of
// shaders that do.
#include <optional>

#include "app/gl/device/source.h"
#include "app/gl/device/texture.h"
#include "procedural/color/map.h"

namespace burl {

/// Of the linear codes in equal steps of which srgb8.glsl makes 8-bit codes: halves of the
/// threshold in a bucket, and the code below it.
GlBufferTexture srgb8_table(const GladGLContext& gl);

/// Kept until another map is asked for. What add_...() adds to a shader, bind_...() binds, made
/// before: making a texture changes the bindings of a unit.
class GlColorTables {
  public:
    explicit GlColorTables(const GladGLContext& gl) : gl_(&gl) {}

    /// The map of the calls below.
    void set_map(const ColorMap& map);

    /// `uint color_code(real f)`: 8-bit codes, r + 2^8 g + 2^16 b. Uses three units.
    void add_codes(ShaderSource& source);
    void bind_codes(const GlProgram& program, int first_unit) const;
    /// `real3 linear_color(real f)`. Uses one unit.
    void add_linear(ShaderSource& source);
    void bind_linear(const GlProgram& program, int first_unit) const;
    /// `uint srgb16(real linear)`. Uses two units.
    void add_srgb16(ShaderSource& source);
    void bind_srgb16(const GlProgram& program, int first_unit) const;

  private:
    struct Codes {
        GlBufferTexture entries;
        std::optional<GlBufferTexture> first, steps;  ///< where an entry may hold several steps
        std::uint32_t count, most;                    ///< of ColorSteps
    };
    struct Segments {
        GlBufferTexture texels;
        int count = 0;
    };
    struct Thresholds {
        GlBufferTexture first, thresholds;
    };
    void add_index(ShaderSource& source) const;

    const GladGLContext* gl_;
    ColorMap map_;
    std::optional<Codes> codes_;
    std::optional<Segments> segments_;
    std::optional<Thresholds> thresholds_;
};

}  // namespace burl
