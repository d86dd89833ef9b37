#pragma once
// The exact filters of the colour map (map_filter.h, stream_filter.h) as the text of shader
// functions, with the host's sequence of operations: the field with its slopes along a texel's
// sides, whether a break of the map lies within the footprint, and the map's mean over it.
#include <string>
#include <vector>

#include "procedural/batch/filter.h"
#include "procedural/color/map_filter_kernels.h"
#include "procedural/glsl/field.h"

namespace burl {

/// Breaks of a colour map in a shader: more would neither fit its uniforms nor be compiled soon.
inline constexpr std::size_t most_shader_breaks = 32;

/// Why a texture cannot be filtered in a shader; empty where it can.
std::string no_filter_shader(const Filter& filter, const ColorMap& colors);

/// The parts of a shader that end with `real field_and_slopes(ivec2 texel, out vec2 slopes)`, the
/// field and what it changes by along the texel's sides, reading besides what glsl_field reads the
/// sampler slope_map, the buffer lattice_sides and, where octaves fade, the buffers octave_shares
/// and lone_terms (synthesize_slope_map.h); octaves without a stream kernel are evaluated on the
/// texel's line (glsl_line_field.h).
std::vector<GlslPart> glsl_field_slopes(const FieldShape& shape, bool fading);

/// What the text of a filter depends on.
struct FilterShape {
    struct Break {
        bool jumps = false, kinks = false;
    };
    bool both_axes = true;  ///< trapezoids; else boxes of the same variance
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

/// `bool has_break(real f, vec2 slopes)`, whether a break of the map lies in the footprint, by the
/// buffer break_distances (break_distance.h): where none does the mean is the colour at f; and
/// `real3 filtered_mean(real f, vec2 slopes)` in linear light. Stands behind map_filter.glsl;
/// color_index.glsl may follow.
std::string glsl_map_filter(const FilterShape& shape);

}  // namespace burl
