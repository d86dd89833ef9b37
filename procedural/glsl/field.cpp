#include "procedural/glsl/field.h"

#include <algorithm>

#include <fmt/format.h>

#include "procedural/numbers/lattice_hash.h"

namespace burl {

namespace {

/// The seed of an octave with the part of the hash that does not depend on the texel.
std::array<std::uint32_t, 3> prepared_seed(NoiseKind kind, std::uint32_t seed) {
    if (kind != NoiseKind::simplex) return {seed * LatticeHash::prime_seed, 0, 0};
    return {LatticeHash::shift(seed, 0), LatticeHash::shift(seed, 1), LatticeHash::shift(seed, 2)};
}

/// The lines that add a group's sum to f; its octaves are numbered from `first` on.
std::string group_text(const FieldShape::Group& group, std::size_t number, std::size_t first) {
    std::string text;
    if (number > 0)
        text += fmt::format(
            "    cells = textureLod(map_cells[{0}], at, 0.0);\n"
            "    places = textureLod(map_places[{0}], at, 0.0);\n",
            number);
    text += fmt::format("    StreamSite site{} = StreamSite(cells.xyz, places.xyz);\n", number);
    for (std::size_t k = group.octaves; k-- > 0;)
        text += fmt::format("    {0}sum{1} {2} weights[{3}] * {4};\n",
                            k + 1 == group.octaves ? "exact float " : "", number,
                            k + 1 == group.octaves ? "=" : "+=", first + k,
                            glsl_octave_noise(group, number, k, first + k));
    return text + fmt::format("    f += scales[{0}] * real(sum{0});\n", number);
}

std::size_t octave_count(const FieldShape& shape) {
    std::size_t count = 0;
    for (const FieldShape::Group& group : shape.groups) count += group.octaves;
    return count;
}

bool has_simplex(const FieldShape& shape) {
    return std::ranges::find(shape.groups, NoiseKind::simplex, &FieldShape::Group::kind) !=
           shape.groups.end();
}

/// The lines that add octave i of those without a stream kernel to f.
std::string lone_text(std::size_t i) {
    return fmt::format(
        "    uvec4 xy{0} = texelFetch(lone_xy[{0}], texel, 0);\n"
        "    uvec4 z{0} = texelFetch(lone_z[{0}], texel, 0);\n"
        "    real3 p{0} = real3(real_from_bits(xy{0}.x, xy{0}.y), real_from_bits(xy{0}.z, "
        "xy{0}.w),\n"
        "                     real_from_bits(z{0}.x, z{0}.y));\n"
        "    f += lone_scales[{0}] *\n"
        "         real(lone_shape{0}(lone_noise{0}(lone_seeds[{0}], p{0}, lone_times[{0}])));\n",
        i);
}

std::string field_text(const FieldShape& shape) {
    std::string text = glsl_field_uniforms(shape) + glsl_lone_functions(shape);
    text +=
        "// The field f: the quadric q and the octaves' sums.\n"
        "real field(ivec2 texel) {\n"
        "    vec2 at = (vec2(texel) + 0.5) * map_scale;\n"
        "    uvec4 cells = textureLod(map_cells[0], at, 0.0);\n"
        "    uvec4 places = textureLod(map_places[0], at, 0.0);\n"
        "    exact real f = real_from_bits(places.w, cells.w) + constant;\n";
    std::size_t first = 0;
    for (std::size_t i = 0; i < shape.groups.size(); ++i) {
        text += group_text(shape.groups[i], i, first);
        first += shape.groups[i].octaves;
    }
    for (std::size_t i = 0; i < shape.lone.size(); ++i) text += lone_text(i);
    return text + "    return f;\n}\n";
}

}  // namespace

FieldOctaves::FieldOctaves(const Texture& texture) {
    const std::vector<Octave> octaves = expand_octaves(texture);
    groups = group_octaves(octaves);
    for (const Octave& octave : octaves) {
        constant += octave.offset;
        if (!has_kernel(octave)) lone.push_back(octave);
    }
}

FieldShape FieldOctaves::shape() const {
    FieldShape shape;
    for (const OctaveGroup& group : groups)
        shape.groups.push_back({group.kind, group.fade, group.octaves.size()});
    for (const Octave& octave : lone) {
        shape.lone.push_back({octave.noise, octave.shape});
        NoiseSpec& noise = shape.lone.back().noise;
        noise.seed = 0;
        if (noise.time) noise.time = 0.0;
    }
    return shape;
}

FieldUniforms FieldOctaves::uniforms() const {
    FieldUniforms uniforms;
    uniforms.constant = constant;
    for (const OctaveGroup& group : groups) {
        uniforms.scales.push_back(group.scale * stream_unit(group.kind));
        uniforms.radii.push_back(float(group.radius2));
        for (const StreamOctave& octave : group.octaves) {
            uniforms.seeds.push_back(prepared_seed(group.kind, octave.seed));
            uniforms.weights.push_back(octave.weight);
        }
    }
    for (const Octave& octave : lone) {
        uniforms.lone_seeds.push_back(octave.noise.seed);
        uniforms.lone_times.push_back(octave.noise.time.value_or(0.0));
        uniforms.lone_scales.push_back(octave.scale);
    }
    return uniforms;
}

std::string glsl_octave_noise(const FieldShape::Group& group, std::size_t number, std::size_t k,
                              std::size_t octave, bool sloped) {
    const std::string site =
        k == 0 ? fmt::format("site{}", number) : fmt::format("doubled(site{}, {})", number, k);
    const char* suffix = sloped ? "_gradient" : "";
    if (group.kind == NoiseKind::simplex)
        return fmt::format("stream_simplex{}({}, seeds[{}], radii[{}])", suffix, site, octave,
                           number);
    const std::string name = group.kind == NoiseKind::perlin
                                 ? "perlin"
                                 : fmt::format("value_{}", glsl_fade_name(group.fade));
    return fmt::format("stream_{}{}({}, seeds[{}].x)", name, suffix, site, octave);
}

std::string glsl_lone_functions(const FieldShape& shape) {
    std::string text;
    for (std::size_t i = 0; i < shape.lone.size(); ++i) {
        text += glsl_site_noise(shape.lone[i].noise, fmt::format("lone_noise{}", i));
        text += glsl_octave_shape(shape.lone[i].shape, fmt::format("lone_shape{}", i));
    }
    return text;
}

std::string glsl_field_uniforms(const FieldShape& shape) {
    std::string text = fmt::format(
        "uniform usampler2D map_cells[{0}], map_places[{0}];\n"
        "uniform vec2 map_scale;  // 1 / the maps' size, for lookups: llvmpipe fetches slower\n"
        "uniform real constant;   // sum of the octaves' offsets\n",
        shape.maps());
    if (!shape.groups.empty())
        text += fmt::format(
            "uniform uvec3 seeds[{0}];\n"
            "uniform float weights[{0}];\n"
            "uniform real scales[{1}];  // one factor for each group of octaves\n",
            octave_count(shape), shape.groups.size());
    if (has_simplex(shape)) text += fmt::format("uniform float radii[{}];\n", shape.groups.size());
    if (!shape.lone.empty())
        text += fmt::format(
            "uniform usampler2D lone_xy[{0}], lone_z[{0}];\n"
            "uniform uint lone_seeds[{0}];\n"
            "uniform real lone_times[{0}], lone_scales[{0}];\n",
            shape.lone.size());
    return text + "\n";
}

std::vector<GlslPart> glsl_noises_of(const FieldShape& shape) {
    std::vector<NoiseSpec> noises;
    for (const FieldShape::Lone& lone : shape.lone) noises.push_back(lone.noise);
    std::vector<GlslPart> parts = glsl_noise_parts(noises);
    parts.push_back({"numbers/real_bits.glsl"});
    if (!shape.groups.empty()) parts.push_back({"noise/stream_noise.glsl"});
    return parts;
}

std::vector<GlslPart> glsl_field(const FieldShape& shape) {
    std::vector<GlslPart> parts = glsl_noises_of(shape);
    parts.push_back({"field", field_text(shape)});
    return parts;
}

}  // namespace burl
