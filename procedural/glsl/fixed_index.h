#pragma once
// 8-bit colours of a 1999 texture by fixed_index.h as the text of a shader without float64 and
// without uniforms in the fragments, for software OpenGL.
#include "procedural/fixed/colors.h"
#include "procedural/glsl/field.h"

namespace burl {

/// What the text depends on.
struct FixedShape {
    std::vector<FieldShape::Group> groups;
    bool repeats = true;

    explicit FixedShape(const FixedIndex& index);
    std::size_t octaves() const;
    /// Lengths of the uniform arrays `octaves` and `terms`.
    std::size_t octave_pairs() const;
    std::size_t terms() const;
};

/// The uniforms of the same names (shaders/maps/fixed_index.vert).
struct FixedUniforms {
    std::vector<glm::uvec4> octaves, terms;
    glm::uvec4 index{0}, entry{0};
};
/// `columns`: of squares in the maps; `gap`: the colour where no span shows anything.
FixedUniforms fixed_uniforms(const FixedIndex& index, const FixedColors& colors,
                             std::uint32_t columns, const Rgb8& gap);

/// Macros that both shaders stand behind.
std::vector<std::pair<std::string, std::string>> glsl_fixed_macros(const FixedShape& shape);

/// The fragment shader, which draws `uint code`: r + 2^8 g + 2^16 b, with `undecided_code` where
/// that is so. It reads the buffers map_bases, map_sites0, map_sites1, ... (synthesize_site_map.h)
/// and color_entries.
std::vector<GlslPart> glsl_fixed_index(const FixedShape& shape);

}  // namespace burl
