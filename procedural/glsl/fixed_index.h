#pragma once
// 8-bit colours of a 1999 texture by the fixed-point index (fixed/index.h) as the text of a shader
// without float64 and without uniforms in the fragments, for software OpenGL.
#include "procedural/fixed/colors.h"
#include "procedural/glsl/field.h"

namespace burl {

/// The properties of an index that the shader's text depends on.
struct FixedShape {
    std::vector<FieldShape::Group> groups;
    bool repeats = true;

    explicit FixedShape(const FixedIndex& index);
    std::size_t octaves() const;
    /// The length of the uniform array `octaves`.
    std::size_t octave_pairs() const;
    /// The length of the uniform array `terms`.
    std::size_t terms() const;
};

/// The values of the uniforms of the same names (shaders/maps/fixed_index.vert).
struct FixedUniforms {
    std::vector<glm::uvec4> octaves, terms;
    glm::uvec4 index{0}, entry{0};
};
/// The uniforms of an index; `columns` is the maps' width in squares, `gap` the colour where no
/// span shows anything.
FixedUniforms fixed_uniforms(const FixedIndex& index, const FixedColors& colors,
                             std::uint32_t columns, const Rgb8& gap);

/// The macros that must be defined before both shaders.
std::vector<std::pair<std::string, std::string>> glsl_fixed_macros(const FixedShape& shape);

/// The parts of the fragment shader, which draws `uint code`: r + 2^8 g + 2^16 b, with
/// `undecided_code` where the index does not decide the colour. It reads the buffers map_bases,
/// map_sites0, map_sites1, ... (maps/site_map.h) and color_entries.
std::vector<GlslPart> glsl_fixed_index(const FixedShape& shape);

}  // namespace burl
