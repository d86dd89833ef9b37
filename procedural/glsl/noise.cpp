#include "procedural/glsl/noise.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "procedural/noise/perlin1985.h"
#include "procedural/noise/perlin_noise.h"

namespace burl {

namespace {

/// The function `uint NAME(uint i)`: element i modulo 256 of a table of bytes, four to a word.
template <class Table>
std::string byte_table(std::string_view name, const Table& table) {
    std::string text = fmt::format("const uint {}_words[64] = uint[64](", name);
    for (std::size_t i = 0; i < 256; i += 4) {
        const std::uint32_t word = std::uint32_t(table[i]) | std::uint32_t(table[i + 1]) << 8 |
                                   std::uint32_t(table[i + 2]) << 16 |
                                   std::uint32_t(table[i + 3]) << 24;
        text += fmt::format("{}0x{:08x}u", i == 0 ? "" : i % 32 == 0 ? ",\n    " : ", ", word);
    }
    return text + fmt::format(
                      ");\n"
                      "uint {0}(uint i) {{\n"
                      "    return {0}_words[i >> 2 & 63u] >> ((i & 3u) << 3) & 255u;\n"
                      "}}\n",
                      name);
}

std::string published_tables() {
    return byte_table("published_number", published_permutation);
}

/// The tables of 1985; gradients have the digits that float32 needs to be read back unchanged.
std::string classic_tables_text() {
    const ClassicTables& tables = classic_tables();
    std::string text = byte_table("classic_number", tables.p);
    text += "const vec3 classic_gradients[256] = vec3[256](";
    for (std::size_t i = 0; i < 256; ++i) {
        const auto& g = tables.g3[i];
        text += fmt::format("{}vec3({:.9g}, {:.9g}, {:.9g})", i == 0 ? "" : ",\n    ", g[0], g[1],
                            g[2]);
    }
    return text +
           ");\n"
           "vec3 classic_gradient(uint number) {\n"
           "    return classic_gradients[number & 255u];\n"
           "}\n";
}

/// The parts of a kind of noise.
std::vector<GlslPart> parts_of(NoiseKind kind) {
    switch (kind) {
        case NoiseKind::value:
            return {{"noise/value.glsl"}};
        case NoiseKind::perlin:
            return {{"noise/perlin.glsl"}};
        case NoiseKind::perlin2002:
            return {{"noise/perlin.glsl"},
                    {"published permutation", published_tables()},
                    {"noise/perlin2002.glsl"}};
        case NoiseKind::perlin1985:
            return {{"tables of 1985", classic_tables_text()}, {"noise/perlin1985.glsl"}};
        case NoiseKind::simplex:
            return {{"noise/simplex.glsl"}};
        case NoiseKind::worley:
            return {{"noise/worley.glsl"}};
        case NoiseKind::cell:
        case NoiseKind::white:
            return {{"noise/cell.glsl"}};
    }
    return {};
}

/// The parts of a kind's gradients; they follow parts_of and noise/gradient.glsl.
std::vector<GlslPart> gradient_parts_of(NoiseKind kind) {
    switch (kind) {
        case NoiseKind::value:
            return {{"noise/value_gradient.glsl"}};
        case NoiseKind::perlin:
            return {{"noise/perlin_gradient.glsl"}};
        case NoiseKind::perlin2002:
            return {{"noise/perlin_gradient.glsl"}, {"noise/perlin2002_gradient.glsl"}};
        case NoiseKind::perlin1985:
            return {{"noise/perlin1985_gradient.glsl"}};
        case NoiseKind::simplex:
            return {{"noise/simplex_gradient.glsl"}};
        case NoiseKind::worley:
            return {{"noise/worley_gradient.glsl"}};
        case NoiseKind::cell:
        case NoiseKind::white:
            return {};
    }
    return {};
}

std::string_view feature_name(WorleyFeature feature) {
    return feature == WorleyFeature::f1   ? "worley_f1"
           : feature == WorleyFeature::f2 ? "worley_f2"
                                          : "worley_f2_f1";
}

/// The form of a function's result: a float, or a vec4 of the noise and its gradient.
struct Form {
    std::string_view type, suffix;
    bool sloped = false;
};
constexpr Form value_form{"float", "noise"}, sample_form{"vec4", "sample", true};

/// The fades of a value noise and, for a sample, their slopes.
std::string fades(Fade fade, bool timed, const Form& form) {
    const std::string t = timed ? "place + place" : "vec4(place + place, 0.0)";
    const char* part = timed ? "" : ".xyz";
    const std::string_view name = glsl_fade_name(fade);
    std::string text = fmt::format("{}_fade({}){}", name, t, part);
    if (form.sloped) text += fmt::format(", {}_fade_slope({}){}", name, t, part);
    return text;
}

/// The expression of an interpolated noise from the lattice planes `low` and `high` and the place,
/// of three coordinates or four.
std::string interpolated(const NoiseSpec& noise, bool timed, const Form& form) {
    switch (noise.kind) {
        case NoiseKind::value:
            return fmt::format("value_{}(seed, low, high, {})", form.suffix,
                               fades(noise.fade, timed, form));
        case NoiseKind::perlin:
            return fmt::format("perlin_{}(seed, low, high, place)", form.suffix);
        case NoiseKind::perlin2002:
            return fmt::format("perlin2002_{}(seed, low, high, place)", form.suffix);
        default:
            return timed ? fmt::format("{}(0.0)", form.type)
                         : fmt::format("perlin1985_{}(seed, low, high, place)", form.suffix);
    }
}

/// A random number in the form asked for; its gradient is 0 wherever it exists.
std::string flat(const std::string& number, const Form& form) {
    return form.sloped ? fmt::format("vec4({}, 0.0, 0.0, 0.0)", number) : number;
}

/// The expression of a noise that is not interpolated, from the site, its cell in 32 bits and, if
/// timed, the fourth coordinate's cell_w and place_w.
std::string from_cells(const NoiseSpec& noise, bool timed, const Form& form) {
    switch (noise.kind) {
        case NoiseKind::simplex:
            return timed ? fmt::format("simplex_{}(seed, site, cell_w, place_w)", form.suffix)
                         : fmt::format("simplex_{}(seed, site, period.xyz, {:.9g})", form.suffix,
                                       float(noise.radius2));
        case NoiseKind::worley:
            return fmt::format("{}{}(nearest_features(seed, cell, place, {}))",
                               feature_name(noise.feature), form.sloped ? "_sample" : "",
                               timed ? "period" : "period.xyz");
        case NoiseKind::cell:
            return flat("cell_noise(seed, cell)", form);
        default:
            return flat(timed ? "white_noise(seed, cell.xyz, site.place, cell.w, place_w)"
                              : "white_noise(seed, cell, site.place)",
                        form);
    }
}

/// The noise's periods; for simplex noise in three dimensions without one, that of its hash.
Period<4> cell_periods(const NoiseSpec& noise) {
    Period<4> period = noise.period;
    if (noise.kind == NoiseKind::simplex && !noise.time)
        for (std::uint32_t& p : period)
            if (p == 0) p = 768;
    return period;
}

/// Appends the parts that are not in the list yet.
void add_new(std::vector<GlslPart>& parts, std::vector<GlslPart> more) {
    for (GlslPart& part : more)
        if (std::ranges::find(parts, part) == parts.end()) parts.push_back(std::move(part));
}

}  // namespace

std::vector<GlslPart> glsl_noise_parts(std::span<const NoiseSpec> noises) {
    std::vector<GlslPart> parts{{"numbers/real.glsl"}, {"noise/lattice.glsl"}};
    for (const NoiseSpec& noise : noises) add_new(parts, parts_of(noise.kind));
    return parts;
}

std::vector<GlslPart> glsl_gradient_parts(std::span<const NoiseSpec> noises) {
    std::vector<GlslPart> parts;
    if (!noises.empty()) parts.push_back({"noise/gradient.glsl"});
    for (const NoiseSpec& noise : noises) add_new(parts, gradient_parts_of(noise.kind));
    return parts;
}

std::string glsl_split_noise(const NoiseSpec& noise, std::string_view name, bool sloped) {
    const Form& form = sloped ? sample_form : value_form;
    return fmt::format(
        "{} {}(uint seed, uvec3 cell, vec3 place) {{\n"
        "    uvec3 low = cell, high = cell + 1u;\n"
        "    return {};\n"
        "}}\n",
        form.type, name, interpolated(noise, false, form));
}

std::string glsl_site_noise(const NoiseSpec& noise, std::string_view name, bool sloped) {
    const Form& form = sloped ? sample_form : value_form;
    const bool timed = noise.time.has_value();
    const Period<4> period = cell_periods(noise);
    std::string text = fmt::format(
        "{} {}(uint seed, real3 p, real time) {{\n"
        "    const uvec4 period = uvec4({}u, {}u, {}u, {}u);\n"
        "    LatticeSite site = lattice_site(p, period.xyz);\n",
        form.type, name, period[0], period[1], period[2], period[3]);
    if (timed)
        text +=
            "    real cell_w, place_w;\n"
            "    site_along(time, period.w, cell_w, place_w);\n"
            "    uvec4 cell = uvec4(cell_bits(site), low_bits(cell_w));\n"
            "    vec4 place = vec4(vec3(site.place), float(place_w));\n";
    else
        text +=
            "    uvec3 cell = cell_bits(site);\n"
            "    vec3 place = vec3(site.place);\n";
    if (!is_interpolated(noise.kind))
        return text + fmt::format("    return {};\n}}\n", from_cells(noise, timed, form));
    const std::string_view size = timed ? "4" : "3", range = timed ? "" : ".xyz";
    return text + fmt::format(
                      "    uvec{0} low = cell;\n"
                      "    uvec{0} high = lattice_index(cell, ivec{0}(1), period{1});\n"
                      "    return {2};\n}}\n",
                      size, range, interpolated(noise, timed, form));
}

std::string_view glsl_fade_name(Fade fade) {
    return fade == Fade::linear ? "linear" : fade == Fade::smooth ? "smooth" : "quintic";
}

std::string_view glsl_shape_name(OctaveShape shape) {
    return shape == OctaveShape::plain      ? "plain"
           : shape == OctaveShape::absolute ? "absolute"
                                            : "ridged";
}

std::string glsl_octave_shape(OctaveShape shape, std::string_view name) {
    return fmt::format("float {}(float n) {{\n    return {};\n}}\n", name,
                       shape == OctaveShape::plain      ? "n"
                       : shape == OctaveShape::absolute ? "abs(n)"
                                                        : "(1.0 - abs(n)) * (1.0 - abs(n))");
}

}  // namespace burl
