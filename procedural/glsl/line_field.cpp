#include "procedural/glsl/line_field.h"

#include <cmath>

#include <fmt/format.h>

#include "procedural/noise/lattice_site.h"

namespace burl {

namespace {

/// The function `float group_sumN(StreamSite site, int shares)`: the sum of the group's octaves,
/// numbered from `first` on.
std::string sum_text(const FieldShape::Group& group, std::size_t number, std::size_t first,
                     bool fading) {
    std::string text = fmt::format(
        "float group_sum{0}(StreamSite site{0}, int shares) {{\n"
        "    exact float sum = 0.0;\n",
        number);
    for (std::size_t k = group.octaves; k-- > 0;)
        text += fmt::format(
            "    sum = sum + {}(weights[{}] * {});\n",
            fading ? fmt::format("texelFetch(octave_shares, shares + {}).x * ", first + k) : "",
            first + k, glsl_octave_noise(group, number, k, first + k));
    return text + "    return sum;\n}\n";
}

/// The lines that add octave i of those without a stream kernel, at pI, to f.
std::string lone_text(std::size_t i, std::size_t count, bool fading) {
    const std::string noise = fmt::format(
        "real(lone_shape{0}(lone_noise{0}(lone_seeds[{0}], p{0}, lone_times[{0}])))", i);
    if (!fading) return fmt::format("    f = f + lone_scales[{}] * {};\n", i, noise);
    return fmt::format(
        "    uvec4 term{0} = texelFetch(lone_terms, owner * {1} + {0});\n"
        "    f = f + real_from_bits(term{0}.x, term{0}.y) * {2};\n"
        "    f = f + real_from_bits(term{0}.z, term{0}.w);\n",
        i, count, noise);
}

/// The function `real field_of(real q, StreamSite site0, ..., real3 p0, ..., int owner)`: f from
/// the quadric's value, the sites in the groups' lattices and the points in the lattices of octaves
/// without a stream kernel.
std::string field_of_text(const FieldShape& shape, bool fading) {
    std::string sums, parameters, body;
    std::size_t octaves = 0;
    for (std::size_t i = 0; i < shape.groups.size(); ++i) {
        sums += sum_text(shape.groups[i], i, octaves, fading);
        parameters += fmt::format(", StreamSite site{}", i);
        octaves += shape.groups[i].octaves;
    }
    for (std::size_t i = 0; i < shape.groups.size(); ++i)
        body += fmt::format("    f = f + scales[{0}] * real(group_sum{0}(site{0}, owner * {1}));\n",
                            i, octaves);
    for (std::size_t i = 0; i < shape.lone.size(); ++i) {
        parameters += fmt::format(", real3 p{}", i);
        body += lone_text(i, shape.lone.size(), fading);
    }
    return sums + fmt::format(
                      "real field_of(real q{}, int owner) {{\n"
                      "    exact real f = q + constant;\n"
                      "{}"
                      "    return f;\n}}\n\n",
                      parameters, body);
}

/// The parts of a field on a texel's line, those that must precede it included.
std::vector<GlslPart> field_parts(const FieldShape& shape, bool fading) {
    std::vector<GlslPart> parts = glsl_noises_of(shape);
    if (shape.groups.empty()) parts.push_back({"noise/stream_noise.glsl"});
    parts.push_back({"maps/texel_line.glsl"});
    parts.push_back({"maps/line_field.glsl"});
    parts.push_back({"field_of", glsl_line_uniforms(shape) + glsl_lone_functions(shape) +
                                     field_of_text(shape, fading)});
    return parts;
}

/// The text "lattices[4 i], lattices[4 i + 1], lattices[4 i + 2]".
std::string columns(std::string_view lattices, std::size_t i) {
    return fmt::format("{0}[{1}], {0}[{2}], {0}[{3}]", lattices, 4 * i, 4 * i + 1, 4 * i + 2);
}

/// The lines that declare the site of the texel's centre in group i's lattice.
std::string site_text(std::size_t i) {
    return fmt::format(
        "    StreamSite site{0} = StreamSite(texelFetch(map_cells[{0}], texel, 0).xyz,\n"
        "                                  texelFetch(map_places[{0}], texel, 0).xyz);\n",
        i);
}

/// The lines that declare the texel's sides in group i's lattice.
std::string side_text(std::size_t i) {
    return fmt::format(
        "    real3 u{0} = lattice_side(along({1}, line.step)),\n"
        "          v{0} = lattice_side(along({1}, line.down));\n",
        i, columns("lattices", i));
}

/// The function `real3 mean_color(ivec2 texel)`.
std::string mean_color_text(const FieldShape& shape) {
    std::string before, arguments;
    for (std::size_t i = 0; i < shape.groups.size(); ++i) {
        before += site_text(i) + side_text(i);
        arguments += fmt::format(", moved(site{0}, u{0}, v{0}, offset)", i);
    }
    for (std::size_t i = 0; i < shape.lone.size(); ++i) {
        before += glsl_lone_line(i);
        arguments += fmt::format(", line_point(lone{}, offset)", i);
    }
    return fmt::format(R"(
real3 linear_color(real f);

real3 mean_color(ivec2 texel) {{
    TexelLine line;
    if (!texel_line(texel, line)) return linear_color(real(0.0));
{}    exact real3 sum = real3(0.0);
    exact real all = real(0.0);
    for (int i = 0; i < sample_count; ++i) {{
        real2 offset = sample_offset(i, texel + tile_origin);
        real weight = gaussian_weight(offset);
        real f = field_of(quadric_at(line_point(line, offset)){}, line.owner);
        sum = sum + weight * linear_color(f);
        all = all + weight;
    }}
    exact real3 mean = sum / all;
    return mean;
}}
)",
                       before, arguments);
}

/// The function `real field_on(TexelLine line, real x)`, f at texel x of a row of corners.
std::string corner_text(const FieldShape& shape) {
    std::string before, arguments;
    for (std::size_t i = 0; i < shape.groups.size(); ++i) {
        before += fmt::format(
            "    StreamSite site{0} = stream_site(mapped(line, {1}, lattices[{2}]), x,\n"
            "        real2(lattice_limits[{3}], lattice_limits[{4}]));\n",
            i, columns("lattices", i), 4 * i + 3, 2 * i, 2 * i + 1);
        arguments += fmt::format(", site{}", i);
    }
    for (std::size_t i = 0; i < shape.lone.size(); ++i) {
        before += glsl_lone_line(i);
        arguments += fmt::format(", point_on(lone{}, x)", i);
    }
    return fmt::format(
        "real field_on(TexelLine line, real x) {{\n"
        "{}"
        "    return field_of(parabola_at(line.start, line.step, x){}, line.owner);\n"
        "}}\n\n",
        before, arguments);
}

/// The function `real field_and_slopes(ivec2 texel, out vec2 slopes)` from centre and corners.
std::string corner_slopes_text(const FieldShape& shape) {
    std::string before, arguments;
    for (std::size_t i = 0; i < shape.groups.size(); ++i) {
        before += site_text(i);
        arguments += fmt::format(", site{}", i);
    }
    for (std::size_t i = 0; i < shape.lone.size(); ++i) {
        before += glsl_lone_line(i);
        arguments += fmt::format(", point_on(lone{}, line.column)", i);
    }
    return fmt::format(R"(
real field_and_slopes(ivec2 texel, out vec2 slopes) {{
    real q = real_from_bits(texelFetch(map_places[0], texel, 0).w, texelFetch(map_cells[0], texel, 0).w);
    TexelLine line;
    slopes = vec2(0.0);
    if (!texel_line(texel, line)) return q;
{}    real f = field_of(q{}, line.owner);
    real4 at = real4(0.0);
    for (int i = 0; i < 4; ++i) {{
        real corner = field_on(corner_line(line, real(i < 2 ? -0.5 : 0.5)), line.column + real(i & 1));
        at = mix(at, real4(corner), equal(ivec4(i), ivec4(0, 1, 2, 3)));
    }}
    exact real more = (at.x - f) + (at.y - f) + (at.z - f) + (at.w - f);
    exact real mean = f + (real(0.25) * more) / real(3.0);
    exact real u = real(0.5) * ((at.y - at.x) + (at.w - at.z)), v = real(0.5) * ((at.z - at.x) + (at.w - at.y));
    slopes = vec2(u, v);
    return mean;
}}
)",
                       before, arguments);
}

}  // namespace

LineUniforms line_uniforms(const FieldOctaves& octaves, const Quadric& quadric) {
    LineUniforms uniforms;
    const auto add = [](const Affine3& map, std::vector<Vec3d>& columns) {
        for (int i = 0; i < 3; ++i) columns.push_back(map.linear[i]);
        columns.push_back(map.offset);
    };
    for (const OctaveGroup& group : octaves.groups) {
        add(group.lattice_from_solid, uniforms.lattices);
        uniforms.lattice_limits.push_back(std::ldexp(lattice_limit, -group.finest()));
        uniforms.lattice_limits.push_back(group.period());
    }
    for (const Octave& octave : octaves.lone)
        add(octave.lattice_from_solid, uniforms.lone_lattices);
    const auto& [a, b, c, d, e, f, g, h, i, j] = quadric;
    uniforms.quadric = {a, b, c, d, e, f, g, h, i, j};
    return uniforms;
}

std::string glsl_line_uniforms(const FieldShape& shape) {
    std::string text = glsl_field_uniforms(shape) +
                       "uniform samplerBuffer octave_shares;\n"
                       "uniform usamplerBuffer lone_terms;\n";
    if (!shape.groups.empty())
        text += fmt::format(
            "uniform real3 lattices[{}];\n"
            "uniform real lattice_limits[{}];\n",
            4 * shape.groups.size(), 2 * shape.groups.size());
    if (!shape.lone.empty())
        text += fmt::format("uniform real3 lone_lattices[{}];\n", 4 * shape.lone.size());
    return text + "\n";
}

std::string glsl_lone_line(std::size_t i) {
    return fmt::format("    TexelLine lone{} = in_lattice(mapped(line, {}, lone_lattices[{}]));\n",
                       i, columns("lone_lattices", i), 4 * i + 3);
}

std::vector<GlslPart> glsl_supersampled(const FieldShape& shape, bool fading) {
    std::vector<GlslPart> parts = field_parts(shape, fading);
    parts.push_back({"maps/supersample.glsl"});
    parts.push_back({"samples", mean_color_text(shape)});
    return parts;
}

std::vector<GlslPart> glsl_field_corners(const FieldShape& shape, bool fading) {
    std::vector<GlslPart> parts = field_parts(shape, fading);
    parts.push_back({"corners", corner_text(shape) + corner_slopes_text(shape)});
    return parts;
}

}  // namespace burl
