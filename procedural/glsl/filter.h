#pragma once
// The exact filters of the colour map (color/map_filter.h, field/stream_filter.h) as the text of
// shader functions, with the host's sequence of operations: the field with its slopes along a
// texel's sides, whether a break of the map lies within the footprint, and the map's mean over it.
#include <string>
#include <vector>

#include "procedural/batch/filter.h"
#include "procedural/color/map_filter_kernels.h"
#include "procedural/glsl/field.h"

namespace burl {

/// The largest number of breaks of a colour map in a shader: more would neither fit its uniforms
/// nor compile fast.
inline constexpr std::size_t most_shader_breaks = 32;

/// The reason why a texture cannot be filtered in a shader; empty where it can.
std::string no_filter_shader(const Filter& filter, const ColorMap& colors);

/// The parts of a shader that end with `real field_and_slopes(ivec2 texel, out vec2 slopes)`, the
/// field and its changes along the texel's sides. Besides the textures of glsl_field it reads the
/// sampler slope_map, the buffer lattice_sides and, where octaves fade, the buffers octave_shares
/// and lone_terms (maps/slope_map.h). Octaves without a stream kernel are evaluated on the texel's
/// line (line_field.h).
std::vector<GlslPart> glsl_field_slopes(const FieldShape& shape, bool fading);

/// The properties of a colour map and filter that the shader's text depends on.
struct FilterShape {
    struct Break {
        bool jumps = false, kinks = false;
    };
    bool both_axes = true;  ///< trapezoid if true, else the box of its variance
    std::vector<Break> breaks;
};

/// The values of the uniforms of the same names; colours are in linear light.
struct FilterUniforms {
    Vec3d map_base{0.0};
    std::vector<double> break_positions;
    std::vector<Vec3d> break_jumps, break_kinks;
};

FilterShape filter_shape(const MapBreaks& map, FilterKind kind);
FilterUniforms filter_uniforms(const MapBreaks& map);

/// Two functions: `bool has_break(real f, vec2 slopes)`, whether a break of the map lies in the
/// footprint, by the buffer break_distances (color/map_pieces.h) - without one the mean is the
/// colour at f - and `real3 filtered_mean(real f, vec2 slopes)` in linear light. They must follow
/// color/map_filter.glsl; color/index.glsl may come later.
std::string glsl_map_filter(const FilterShape& shape);

}  // namespace burl
