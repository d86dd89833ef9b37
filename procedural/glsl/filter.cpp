// A break's numbers are uniforms, so that colours change without a new shader; the text depends on
// which breaks jump and which kink.
#include "procedural/glsl/filter.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "procedural/color/map_pieces.h"
#include "procedural/glsl/line_field.h"

namespace burl {

namespace {

/// The lines that add a group's sum and gradient to f and the slopes; its octaves are numbered from
/// `first` on.
std::string group_text(const FieldShape::Group& group, std::size_t number, std::size_t first,
                       bool fading) {
    std::string text;
    if (number > 0)
        text += fmt::format(
            "    cells = texelFetch(map_cells[{0}], texel, 0);\n"
            "    places = texelFetch(map_places[{0}], texel, 0);\n",
            number);
    text += fmt::format(
        "    StreamSite site{0} = StreamSite(cells.xyz, places.xyz);\n"
        "    exact vec4 sum{0} = vec4(0.0);\n",
        number);
    for (std::size_t k = group.octaves; k-- > 0;)
        text += fmt::format(
            "    sum{0} = sum{0} + {4}(vec4(weights[{1}], vec3(weights[{1}] * {2}.0)) * {3});\n",
            number, first + k, 1u << k, glsl_octave_noise(group, number, k, first + k, true),
            fading ? fmt::format("texelFetch(octave_shares, shares + {}).x * ", first + k) : "");
    return text + fmt::format(
                      "    f += scales[{0}] * real(sum{0}.x);\n"
                      "    slopes.x += exact_dot(sum{0}.yzw, texelFetch(lattice_sides, sides + "
                      "{1}).xyz);\n"
                      "    slopes.y += exact_dot(sum{0}.yzw, texelFetch(lattice_sides, sides + "
                      "{2}).xyz);\n",
                      number, 2 * number, 2 * number + 1);
}

/// The functions lone_sampleI: the noises of lone octaves with their gradients.
std::string lone_functions(const FieldShape& shape) {
    std::string text;
    for (std::size_t i = 0; i < shape.lone.size(); ++i)
        text += glsl_site_noise(shape.lone[i].noise, fmt::format("lone_sample{}", i), true);
    return text;
}

/// The lines that add octave i of those without a stream kernel to f and the slopes, on the texel's
/// `line`.
std::string lone_text(std::size_t i, std::size_t count, OctaveShape shape, bool fading) {
    std::string text = glsl_lone_line(i);
    text += fading ? fmt::format(
                         "    uvec4 term{0} = texelFetch(lone_terms, line.owner * {1} + {0});\n"
                         "    real scale{0} = real_from_bits(term{0}.x, term{0}.y);\n",
                         i, count)
                   : fmt::format("    real scale{0} = lone_scales[{0}];\n", i);
    text += fmt::format(
        "    vec4 n{0} = {1}_sample("
        "lone_sample{0}(lone_seeds[{0}], point_on(lone{0}, lone{0}.column),\n"
        "                                   lone_times[{0}]));\n"
        "    real3 gradient{0} = real3(n{0}.yzw);\n"
        "    f += scale{0} * real(n{0}.x);\n"
        "    slopes.x += float(scale{0} * dot_product(gradient{0}, lone{0}.step));\n"
        "    slopes.y += float(scale{0} * dot_product(gradient{0}, lone{0}.down));\n",
        i, glsl_shape_name(shape));
    if (fading) text += fmt::format("    f += real_from_bits(term{0}.z, term{0}.w);\n", i);
    return text;
}

/// The parts that must precede a field with slopes.
std::vector<GlslPart> slope_parts(const FieldShape& shape) {
    std::vector<NoiseSpec> noises;
    for (const FieldShape::Lone& lone : shape.lone) noises.push_back(lone.noise);
    std::vector<GlslPart> parts = glsl_noise_parts(noises);
    std::ranges::copy(glsl_gradient_parts(noises), std::back_inserter(parts));
    for (const char* file :
         {"numbers/real_bits.glsl", "noise/stream_noise.glsl", "noise/stream_gradient.glsl"})
        parts.push_back({file});
    if (!noises.empty())
        for (const char* file : {"maps/texel_line.glsl", "maps/line_field.glsl"})
            parts.push_back({file});
    return parts;
}

/// The function `real3 NAME_mean(Footprint at)`.
std::string mean_text(const FilterShape& shape, std::string_view name) {
    std::string text = fmt::format(
        "real3 {}_mean(Footprint at) {{\n"
        "    exact real3 sum = real3(0.0);\n"
        "    real2 share;\n",
        name);
    for (std::size_t i = 0; i < shape.breaks.size(); ++i) {
        text += fmt::format("    share = {}_shares(at, break_positions[{}]);\n", name, i);
        if (shape.breaks[i].jumps)
            text += fmt::format("    sum = sum + share.x * break_jumps[{}];\n", i);
        if (shape.breaks[i].kinks)
            text += fmt::format("    sum = sum + share.y * break_kinks[{}];\n", i);
    }
    return text + fmt::format(
                      "    exact real3 mean = map_base + sum * {}_scale(at);\n"
                      "    return mean;\n"
                      "}}\n",
                      name);
}

bool is_exact(FilterKind kind) {
    return kind == FilterKind::exact || kind == FilterKind::trapezoid ||
           kind == FilterKind::trapezoid2;
}

}  // namespace

std::string no_filter_shader(const Filter& filter, const ColorMap& colors) {
    if (!is_exact(filter.kind)) return "";
    const std::size_t breaks = MapPieces(colors).breaks().size();
    if (breaks <= most_shader_breaks) return "";
    return fmt::format("the colour map has {} breaks, and OpenGL filters at most {}", breaks,
                       most_shader_breaks);
}

std::vector<GlslPart> glsl_field_slopes(const FieldShape& shape, bool fading) {
    std::size_t octaves = 0;
    for (const FieldShape::Group& group : shape.groups) octaves += group.octaves;
    std::string text = glsl_line_uniforms(shape) + lone_functions(shape);
    text +=
        "uniform usampler2D slope_map;\n"
        "uniform samplerBuffer lattice_sides;\n"
        "\n"
        "real field_and_slopes(ivec2 texel, out vec2 slopes_out) {\n"
        "    uvec4 cells = texelFetch(map_cells[0], texel, 0);\n"
        "    uvec4 places = texelFetch(map_places[0], texel, 0);\n"
        "    uvec4 slope = texelFetch(slope_map, texel, 0);\n"
        "    exact vec2 slopes = uintBitsToFloat(slope.xy);\n"
        "    exact real f = real_from_bits(places.w, cells.w) + constant;\n";
    text += fmt::format("    int sides = int(slope.z) * {};\n", 2 * shape.groups.size());
    if (fading) text += fmt::format("    int shares = int(slope.z) * {};\n", octaves);
    std::size_t first = 0;
    for (std::size_t i = 0; i < shape.groups.size(); ++i) {
        text += group_text(shape.groups[i], i, first, fading);
        first += shape.groups[i].octaves;
    }
    if (!shape.lone.empty())
        text +=
            "    TexelLine line;\n"
            "    texel_line(texel, line);\n";
    for (std::size_t i = 0; i < shape.lone.size(); ++i)
        text += lone_text(i, shape.lone.size(), shape.lone[i].shape, fading);
    text +=
        "    slopes_out = slopes;\n"
        "    return f;\n}\n";
    std::vector<GlslPart> parts = slope_parts(shape);
    parts.push_back({"slopes", text});
    return parts;
}

FilterShape filter_shape(const MapBreaks& map, FilterKind kind) {
    FilterShape shape{kind != FilterKind::exact, {}};
    for (const MapBreak& at : map.breaks)
        shape.breaks.push_back({at.jump != Vec3d(0.0), at.kink != Vec3d(0.0)});
    return shape;
}

FilterUniforms filter_uniforms(const MapBreaks& map) {
    FilterUniforms uniforms;
    uniforms.map_base = map.base;
    for (const MapBreak& at : map.breaks) {
        uniforms.break_positions.push_back(at.position);
        uniforms.break_jumps.push_back(at.jump);
        uniforms.break_kinks.push_back(at.kink);
    }
    return uniforms;
}

std::string glsl_map_filter(const FilterShape& shape) {
    const std::size_t breaks = std::max<std::size_t>(shape.breaks.size(), 1);
    std::string text = fmt::format(
        "real color_index(real f);\n"
        "uniform real3 map_base;\n"
        "uniform real break_positions[{0}];\n"
        "uniform real3 break_jumps[{0}], break_kinks[{0}];\n"
        "uniform samplerBuffer break_distances;\n\n",
        breaks);
    text += fmt::format(
        "bool has_break(real f, vec2 slopes) {{\n"
        "    float reach = (abs(slopes.x) + abs(slopes.y)) * 0.5;\n"
        "    int entry = int(color_index(f) * real({}.0));\n"
        "    return !isnan(f) && !(reach < texelFetch(break_distances, entry).x);\n"
        "}}\n\n",
        BreakDistance::entry_count);
    text += mean_text(shape, "narrow") + mean_text(shape, "box");
    if (shape.both_axes) text += mean_text(shape, "trapezoid");
    return text + fmt::format(
                      "\nreal3 filtered_mean(real f, vec2 slopes) {{\n"
                      "    Footprint whole = footprint_of(f, slopes, {}), at = reduced(whole);\n"
                      "    int method = method_for(whole);\n"
                      "    if (method == 1) return narrow_mean(at);\n"
                      "    return {};\n"
                      "}}\n",
                      shape.both_axes ? "true" : "false",
                      shape.both_axes ? "method == 2 ? box_mean(at) : trapezoid_mean(at)"
                                      : "box_mean(at)");
}

}  // namespace burl
