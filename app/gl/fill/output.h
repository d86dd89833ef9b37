#pragma once
// The output of synthesis shaders by pixel type: the colour map's tables (procedural/glsl/colors.h)
// as buffer textures, the target's format, the last part of the shader, and the conversion of
// texels read back. The last part follows `real field(ivec2 texel)` and the colours' parts
// (GlColorTables), or a colour in linear light and the encoder's part.
#include <optional>
#include <type_traits>
#include <vector>

#include <fmt/core.h>

#include "app/gl/device/target.h"
#include "atlas/base/image.h"
#include "procedural/batch/row_tasks.h"
#include "procedural/color/map.h"
#include "procedural/color/srgb.h"

namespace burl {

/// The table with which srgb8.glsl encodes linear light to 8 bits: per bucket of equal width the
/// two words of the float64 threshold, and the code below it.
GlBufferTexture srgb8_table(const GladGLContext& gl);

/// The tables of one colour map and the parts of shaders that read them, kept until another map is
/// set. add_...() creates the tables and adds the code that reads them, bind_...() binds them
/// later, since creating a texture changes the bindings of a unit.
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

/// The output of pixels of the type Rgb8, Rgb16, RgbF, or float for the field itself (0 outside all
/// spans). `color_text` is the last part of a shader that defines `real3 color_at(ivec2 texel)` in
/// linear light; `field_text`, where it exists, that of a shader that defines `real field(ivec2
/// texel)`.
template <class Pixel>
struct GlOutput;

template <>
struct GlOutput<Rgb8> {
    static constexpr GLenum internal = GL_R32UI;
    using Component = std::uint32_t;
    static constexpr std::size_t components = 1;
    static constexpr const char* field_text =
        "layout(location = 0) out uint code;  // r + 2^8 g + 2^16 b\n"
        "void main() { code = color_code(field(ivec2(gl_FragCoord.xy))); }\n";
    static constexpr const char* color_text =
        "layout(location = 0) out uint code;  // r + 2^8 g + 2^16 b\n"
        "void main() {\n"
        "    real3 c = color_at(ivec2(gl_FragCoord.xy));\n"
        "    code = srgb8(c.x) | srgb8(c.y) << 8 | srgb8(c.z) << 16;\n"
        "}\n";
    static Rgb8 pixel(const Component* c) {
        return {std::uint8_t(*c), std::uint8_t(*c >> 8), std::uint8_t(*c >> 16)};
    }
};

template <>
struct GlOutput<Rgb16> {
    static constexpr GLenum internal = GL_RG32UI;
    using Component = std::uint32_t;
    static constexpr std::size_t components = 2;
    static constexpr const char* color_text =
        "layout(location = 0) out uvec2 codes;  // r + 2^16 g, b\n"
        "void main() {\n"
        "    real3 c = color_at(ivec2(gl_FragCoord.xy));\n"
        "    codes = uvec2(srgb16(c.x) | srgb16(c.y) << 16, srgb16(c.z));\n"
        "}\n";
    static Rgb16 pixel(const Component* c) {
        return {std::uint16_t(c[0]), std::uint16_t(c[0] >> 16), std::uint16_t(c[1])};
    }
};

template <>
struct GlOutput<RgbF> {
    static constexpr GLenum internal = GL_RGBA32F;
    using Component = float;
    static constexpr std::size_t components = 4;
    static constexpr const char* color_text =
        "layout(location = 0) out vec4 color;  // linear light\n"
        "void main() { color = vec4(vec3(color_at(ivec2(gl_FragCoord.xy))), 1.0); }\n";
    static RgbF pixel(const Component* c) { return {c[0], c[1], c[2]}; }
};

template <>
struct GlOutput<float> {
    static constexpr GLenum internal = GL_R32F;
    using Component = float;
    static constexpr std::size_t components = 1;
    static constexpr const char* field_text =
        "layout(location = 0) out float value;\n"
        "void main() {\n"
        "    real f = field(ivec2(gl_FragCoord.xy));\n"
        "    value = isnan(f) ? 0.0 : float(f);\n"
        "}\n";
    static float pixel(const Component* c) { return *c; }
};

/// Adds `uint srgb8(real light)`, which reads srgb8_table() as srgb8_buckets.
inline void add_srgb8(ShaderSource& source) {
    source.define("SRGB8_BUCKETS", fmt::format("{}.0", SrgbStreamEncoder::bucket_count))
        .add("color/srgb8.glsl");
}

/// Adds the encoder's part and the last part of a shader that writes `color`, an expression of
/// `texel` in linear light.
template <class Pixel>
void add_color_output(GlColorTables& colors, ShaderSource& source, const char* color) {
    if constexpr (std::is_same_v<Pixel, Rgb8>) add_srgb8(source);
    if constexpr (std::is_same_v<Pixel, Rgb16>) colors.add_srgb16(source);
    source.add("output", fmt::format("real3 color_at(ivec2 texel) {{ return {}; }}\n", color) +
                             GlOutput<Pixel>::color_text);
}

/// Adds the colours' parts and the last part of a shader that writes the colours of the field.
template <class Pixel>
void add_output(GlColorTables& colors, ShaderSource& source) {
    if constexpr (std::is_same_v<Pixel, Rgb8>) colors.add_codes(source);
    if constexpr (std::is_same_v<Pixel, Rgb8> || std::is_same_v<Pixel, float>) {
        source.add("output", GlOutput<Pixel>::field_text);
    } else {
        colors.add_linear(source);
        add_color_output<Pixel>(colors, source, "linear_color(field(texel))");
    }
}

/// The largest number of texture units that bind_output takes.
inline constexpr int output_units = 3;

/// Binds the tables and uniforms of add_output() to a program in use.
template <class Pixel>
void bind_output(const GlColorTables& colors, const GlProgram& program, int first_unit) {
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        colors.bind_codes(program, first_unit);
    else if constexpr (!std::is_same_v<Pixel, float>)
        colors.bind_linear(program, first_unit);
    if constexpr (std::is_same_v<Pixel, Rgb16>) colors.bind_srgb16(program, first_unit + 1);
}

/// Binds the tables of add_color_output() to a program in use, and those of add_linear() where
/// `linear` is set.
template <class Pixel>
void bind_color_output(const GlColorTables& colors, const GlProgram& program, int first_unit,
                       bool linear) {
    if (linear) colors.bind_linear(program, first_unit);
    if constexpr (std::is_same_v<Pixel, Rgb16>) colors.bind_srgb16(program, first_unit + 1);
}

/// Reads pixels back from targets of GlOutput<Pixel>::internal through a buffer that is kept
/// between calls.
class GlReadBack {
  public:
    /// Reads the texels of `target` from its corner on into the image at `tile`. 0 threads means
    /// all.
    template <class Pixel>
    void read(const GlTarget& target, const GlTile& tile, int threads, Image<Pixel>& image) {
        using Output = GlOutput<Pixel>;
        using Component = typename Output::Component;
        const auto width = std::size_t(tile.size.x), height = std::size_t(tile.size.y);
        const std::size_t count = width * height * Output::components;
        if (bytes_.size() < count * sizeof(Component)) bytes_.resize(count * sizeof(Component));
        auto* texels = reinterpret_cast<Component*>(bytes_.data());
        target.read(std::span(texels, count), {{0, 0}, tile.size});
        for_row_ranges(height, std::size_t(1) << 16, threads, [&](const RowRange& rows) {
            for (std::size_t y = rows.begin(); y != rows.end(); ++y) {
                const Component* from = texels + y * width * Output::components;
                Pixel* to = &image(std::size_t(tile.origin.x), std::size_t(tile.origin.y) + y);
                for (std::size_t x = 0; x < width; ++x)
                    to[x] = Output::pixel(from + x * Output::components);
            }
        });
    }

  private:
    std::vector<std::byte> bytes_;
};

}  // namespace burl
