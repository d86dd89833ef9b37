#include "procedural/glsl/fixed_index.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "procedural/numbers/lattice_hash.h"

namespace burl {

namespace {

const char* noise_name(const FieldShape::Group& group) {
    if (group.kind == NoiseKind::perlin) return "stream_perlin";
    return group.fade == Fade::linear   ? "stream_value_linear"
           : group.fade == Fade::smooth ? "stream_value_smooth"
                                        : "stream_value_quintic";
}

/// The expression of component 0 or 1 of octave i's pair.
std::string octave_word(std::size_t i, std::size_t word) {
    return fmt::format("octave_pairs[{}].{}", i / 2, "xyzw"[2 * (i % 2) + word]);
}

/// The lines that add a group's sum, from the finest octave to the coarsest, to the index; its
/// octaves are numbered from `first` on.
std::string index_group_text(const FieldShape::Group& group, std::size_t number,
                             std::size_t first) {
    std::string text =
        fmt::format("    HashSite site{0} = map_site(texelFetch(map_sites{0}, place));\n", number);
    for (std::size_t k = group.octaves; k-- > 0;)
        text += fmt::format("    {0} uintBitsToFloat({1}) * {2}(doubled(site{3}, {4}), {5});\n",
                            k + 1 == group.octaves ? fmt::format("exact float sum{} =", number)
                                                   : fmt::format("sum{} +=", number),
                            octave_word(first + k, 1), noise_name(group), number, k,
                            octave_word(first + k, 0));
    return text + fmt::format("    index += fixed_term(sum{0}, term_words[{0}]);\n", number);
}

/// The seeds and weights of all octaves in turn, four words to a texel.
std::vector<glm::uvec4> octave_words(std::span<const OctaveGroup> groups) {
    std::vector<std::uint32_t> words;
    for (const OctaveGroup& group : groups)
        for (const StreamOctave& octave : group.octaves) {
            words.push_back(octave.seed * LatticeHash::prime_seed);
            words.push_back(std::bit_cast<std::uint32_t>(octave.weight));
        }
    words.resize(std::max<std::size_t>(4, (words.size() + 3) / 4 * 4));
    std::vector<glm::uvec4> texels;
    for (std::size_t i = 0; i < words.size(); i += 4)
        texels.emplace_back(words[i], words[i + 1], words[i + 2], words[i + 3]);
    return texels;
}

/// The largest value that a clamped index is limited to: above 1 by more than its tolerance. 0 for
/// an index that repeats.
std::uint32_t largest_index(const FixedIndex& index, const FixedColors& colors,
                            std::uint32_t tolerance) {
    if (index.repeats) return 0;
    const double above = std::ldexp(4.0 * tolerance, index.fraction_bits - colors.step_bits());
    return std::uint32_t(std::ldexp(1.0, index.fraction_bits) + std::ceil(above));
}

}  // namespace

FixedShape::FixedShape(const FixedIndex& index) : repeats(index.repeats) {
    for (const OctaveGroup& group : index.groups)
        groups.push_back({group.kind, group.fade, group.octaves.size()});
}

std::size_t FixedShape::octaves() const {
    std::size_t count = 0;
    for (const FieldShape::Group& group : groups) count += group.octaves;
    return count;
}

std::size_t FixedShape::octave_pairs() const {
    return std::max<std::size_t>(1, (octaves() + 1) / 2);
}

std::size_t FixedShape::terms() const {
    return std::max<std::size_t>(1, groups.size());
}

FixedUniforms fixed_uniforms(const FixedIndex& index, const FixedColors& colors,
                             std::uint32_t columns, const Rgb8& gap) {
    FixedUniforms uniforms{octave_words(index.groups), {}};
    for (const FixedTerm& term : index.terms)
        uniforms.terms.emplace_back(std::bit_cast<std::uint32_t>(term.whole),
                                    std::uint32_t(term.factor), std::uint32_t(term.shift), 0u);
    if (uniforms.terms.empty()) uniforms.terms.emplace_back(0u);
    const std::uint32_t tolerance = fixed_tolerance(index, colors.step_bits());
    uniforms.index = {
        index.constant, largest_index(index, colors, tolerance), columns,
        std::uint32_t(gap.r) | std::uint32_t(gap.g) << 8 | std::uint32_t(gap.b) << 16};
    uniforms.entry = {index.fraction_bits - colors.bits, 32 - index.fraction_bits + colors.bits,
                      tolerance, 0};
    return uniforms;
}

std::vector<std::pair<std::string, std::string>> glsl_fixed_macros(const FixedShape& shape) {
    return {{"OCTAVE_PAIRS", std::to_string(shape.octave_pairs())},
            {"TERMS", std::to_string(shape.terms())},
            {"ENTRY_MARGIN", fmt::format("{}u", FixedColors::margin)},
            {"COLOR_REPEATS", shape.repeats ? "1" : "0"}};
}

std::vector<GlslPart> glsl_fixed_index(const FixedShape& shape) {
    std::string text = "uniform usamplerBuffer map_bases";
    for (std::size_t i = 0; i < shape.groups.size(); ++i) text += fmt::format(", map_sites{}", i);
    text +=
        ";\n"
        "layout(location = 0) out uint code;\n"
        "\n"
        "void main() {\n"
        "    int place = texel_place(ivec2(gl_FragCoord.xy));\n"
        "    uint base = texelFetch(map_bases, place).x;\n"
        "    int index = int(base + index_words.x);\n";
    std::size_t first = 0;
    for (std::size_t i = 0; i < shape.groups.size(); ++i) {
        text += index_group_text(shape.groups[i], i, first);
        first += shape.groups[i].octaves;
    }
    text += "    code = base == no_base ? index_words.w : fixed_color(index);\n}\n";
    std::vector<GlslPart> parts = glsl_noise_parts({});
    parts.push_back({"noise/stream_noise.glsl"});
    parts.push_back({"maps/fixed_index.glsl"});
    parts.push_back({"colors", text});
    return parts;
}

}  // namespace burl
