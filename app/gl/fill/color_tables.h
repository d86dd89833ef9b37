#pragma once
// The tables of a colour map (procedural/glsl/colors.h) as buffer textures, and the parts of
// shaders that read them.
#include <optional>

#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "procedural/color/map.h"

namespace burl {

/// The table with which srgb8.glsl encodes linear light to 8 bits: per bucket of equal width the
/// two words of the float64 threshold, and the code below it.
GlBufferTexture srgb8_table(const GladGLContext& gl);

/// The tables of one colour map, kept until another map is set. add_...() creates the tables and
/// adds the code that reads them, bind_...() binds them later, since creating a texture changes the
/// bindings of a unit.
class GlColorTables {
  public:
    explicit GlColorTables(const GladGLContext& gl) : gl_(&gl) {}

    /// Sets the map of the following calls.
    void set_map(const ColorMap& map);

    /// Adds `uint color_code(real f)`: 8-bit codes r + 2^8 g + 2^16 b. Uses three units.
    void add_codes(ShaderSource& source);
    void bind_codes(const GlProgram& program, int first_unit) const;
    /// Adds `real3 linear_color(real f)`. Uses one unit.
    void add_linear(ShaderSource& source);
    void bind_linear(const GlProgram& program, int first_unit) const;
    /// Adds `uint srgb16(real linear)`. Uses two units.
    void add_srgb16(ShaderSource& source);
    void bind_srgb16(const GlProgram& program, int first_unit) const;

  private:
    struct Codes {
        GlBufferTexture entries;
        /// The tables of steps, only for maps with entries of several steps.
        std::optional<GlBufferTexture> first, steps;
        std::uint32_t count, most;  ///< the fields of ColorSteps
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
