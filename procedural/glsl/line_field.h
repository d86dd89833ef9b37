#pragma once
// The field of a 1999 texture beside the texels' centres, as the text of shader functions with the
// sequence of operations, and so the bits, of field/sampler.h: the lattice coordinates at the
// centre are moved in fixed point, everything else is computed from the line of points that the
// texel's span shows (shaders/maps/texel_line.glsl).
#include <string>
#include <vector>

#include "procedural/glsl/field.h"

namespace burl {

/// The values of the uniforms of the same names.
struct LineUniforms {
    std::vector<Vec3d> lattices;         ///< maps of the groups: three columns and the offset each
    std::vector<Vec3d> lone_lattices;    ///< maps of the octaves without a stream kernel
    std::vector<double> lattice_limits;  ///< largest coordinate and period of each group
    std::vector<double> quadric;         ///< coefficients a to j
};
LineUniforms line_uniforms(const FieldOctaves& octaves, const Quadric& quadric);

/// The declarations of the uniforms of a field and of its lines, and of the buffers octave_shares
/// and lone_terms.
std::string glsl_line_uniforms(const FieldShape& shape);

/// The line of a function that declares loneI: the TexelLine `line` in the lattice of the I-th
/// octave without a stream kernel.
std::string glsl_lone_line(std::size_t i);

/// The parts of a shader that end with `real3 mean_color(ivec2 texel)`, the weighted mean, in
/// linear light, of the colours at the samples of maps/supersample.glsl. `real3 linear_color(real
/// f)` must follow. With `fading`, octaves fade by the buffers octave_shares and lone_terms
/// (maps/slope_map.h).
std::vector<GlslPart> glsl_supersampled(const FieldShape& shape, bool fading);

/// The parts of a shader that end with `real field_and_slopes(ivec2 texel, out vec2 slopes)`, the
/// field's mean over the texel and its changes along the texel's sides, from its values at centre
/// and corners (field/corner_samples.h).
std::vector<GlslPart> glsl_field_corners(const FieldShape& shape, bool fading);

}  // namespace burl
