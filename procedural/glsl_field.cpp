#include "procedural/glsl_field.h"

#include <algorithm>

#include <fmt/format.h>

#include "procedural/lattice_hash.h"
#include "procedural/noise_names.h"

namespace burl {

namespace {

/// What the seed of an octave becomes before a texel is known.
std::array<std::uint32_t, 3> prepared_seed(NoiseKind kind, std::uint32_t seed) {
    if (kind != NoiseKind::simplex) return {seed * LatticeHash::prime_seed, 0, 0};
    return {LatticeHash::shift(seed, 0), LatticeHash::shift(seed, 1), LatticeHash::shift(seed, 2)};
}

std::string_view fade_name(Fade fade) {
    return fade == Fade::linear ? "linear" : fade == Fade::smooth ? "smooth" : "quintic";
}

/// The noise of a group's octave k, which is number `octave` of all.
std::string octave_noise(const FieldShape::Group& group, std::size_t number, std::size_t k,
                         std::size_t octave) {
    const std::string site =
        k == 0 ? fmt::format("site{}", number) : fmt::format("doubled(site{}, {})", number, k);
    if (group.kind == NoiseKind::simplex)
        return fmt::format("stream_simplex({}, seeds[{}], radii[{}])", site, octave, number);
    const std::string name = group.kind == NoiseKind::perlin
                                 ? "stream_perlin"
                                 : fmt::format("stream_value_{}", fade_name(group.fade));
    return fmt::format("{}({}, seeds[{}].x)", name, site, octave);
}

/// A group's sum, added to f. Its octaves are numbered from `first` on.
std::string group_text(const FieldShape::Group& group, std::size_t number, std::size_t first) {
    std::string text;
    if (number > 0)
        text += fmt::format(
            "    cells = texelFetch(map_cells[{0}], texel, 0);\n"
            "    places = texelFetch(map_places[{0}], texel, 0);\n",
            number);
    text += fmt::format("    StreamSite site{} = StreamSite(cells.xyz, places.xyz);\n", number);
    for (std::size_t k = group.octaves; k-- > 0;)
        text += fmt::format("    {0}sum{1} {2} weights[{3}] * {4};\n",
                            k + 1 == group.octaves ? "exact float " : "", number,
                            k + 1 == group.octaves ? "=" : "+=", first + k,
                            octave_noise(group, number, k, first + k));
    return text + fmt::format("    f += scales[{0}] * real(sum{0});\n", number);
}

std::size_t octave_count(const FieldShape& shape) {
    std::size_t count = 0;
    for (const FieldShape::Group& group : shape.groups) count += group.octaves;
    return count;
}

std::string uniforms_text(const FieldShape& shape) {
    const std::size_t groups = shape.groups.size();
    std::string text = fmt::format("uniform usampler2D map_cells[{0}], map_places[{0}];\n",
                                   std::max<std::size_t>(groups, 1));
    text += "uniform real constant;  // of all octaves\n";
    if (groups == 0) return text;
    text += fmt::format(
        "uniform uvec3 seeds[{0}];\n"
        "uniform float weights[{0}];\n"
        "uniform real scales[{1}];  // of groups of octaves\n",
        octave_count(shape), groups);
    if (std::ranges::find(shape.groups, NoiseKind::simplex, &FieldShape::Group::kind) !=
        shape.groups.end())
        text += fmt::format("uniform float radii[{}];\n", groups);
    return text;
}

}  // namespace

FieldShape field_shape(const std::vector<OctaveGroup>& groups) {
    FieldShape shape;
    for (const OctaveGroup& group : groups)
        shape.groups.push_back({group.kind, group.fade, group.octaves.size()});
    return shape;
}

FieldUniforms field_uniforms(const std::vector<OctaveGroup>& groups,
                             std::span<const Octave> octaves) {
    FieldUniforms uniforms;
    for (const OctaveGroup& group : groups) {
        uniforms.scales.push_back(group.scale * stream_unit(group.kind));
        uniforms.radii.push_back(float(group.radius2));
        for (const StreamOctave& octave : group.octaves) {
            uniforms.seeds.push_back(prepared_seed(group.kind, octave.seed));
            uniforms.weights.push_back(octave.weight);
        }
    }
    for (const Octave& octave : octaves) uniforms.constant += octave.offset;
    return uniforms;
}

std::string no_field_shader(std::span<const Octave> octaves) {
    for (const Octave& octave : octaves) {
        if (has_kernel(octave)) continue;
        const NoiseSpec& noise = octave.noise;
        std::string what;
        for (const auto& [name, kind, text] : noise_kinds)
            if (kind == noise.kind) what = fmt::format("{} noise", name);
        if (octave.shape != OctaveShape::plain) what += " with a shape";
        if (noise.time) what += " with a time";
        if (noise.period != Period<4>{}) what += " with a period";
        return fmt::format("{} is not among the noises of the single pass on OpenGL", what);
    }
    return "";
}

std::string glsl_field(const FieldShape& shape) {
    std::string text = uniforms_text(shape);
    text +=
        "\n// f = q + the octaves' sums.\n"
        "real field(ivec2 texel) {\n"
        "    uvec4 cells = texelFetch(map_cells[0], texel, 0);\n"
        "    uvec4 places = texelFetch(map_places[0], texel, 0);\n"
        "    exact real f = real_from_bits(places.w, cells.w) + constant;\n";
    std::size_t first = 0;
    for (std::size_t i = 0; i < shape.groups.size(); ++i) {
        text += group_text(shape.groups[i], i, first);
        first += shape.groups[i].octaves;
    }
    return text + "    return f;\n}\n";
}

}  // namespace burl
