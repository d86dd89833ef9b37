#include "procedural/glsl_noise.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "procedural/perlin1985.h"
#include "procedural/published_permutation.h"

namespace burl {

namespace {

/// `uint NAME(uint i)`: number i modulo 256 of the table, of which four share a word.
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

/// The gradients as float32 numbers that read back the same.
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

std::vector<GlslPart> parts_of(NoiseKind kind) {
    switch (kind) {
        case NoiseKind::value:
            return {{"noise_value.glsl"}};
        case NoiseKind::perlin:
            return {{"noise_perlin.glsl"}};
        case NoiseKind::perlin2002:
            return {{"noise_perlin.glsl"},
                    {"published permutation", published_tables()},
                    {"noise_perlin2002.glsl"}};
        case NoiseKind::perlin1985:
            return {{"tables of 1985", classic_tables_text()}, {"noise_perlin1985.glsl"}};
        case NoiseKind::simplex:
            return {{"noise_simplex.glsl"}};
        case NoiseKind::worley:
            return {{"noise_worley.glsl"}};
        case NoiseKind::cell:
        case NoiseKind::white:
            return {{"noise_cell.glsl"}};
    }
    return {};
}

std::string_view fade_name(Fade fade) {
    return fade == Fade::linear   ? "linear_fade"
           : fade == Fade::smooth ? "smooth_fade"
                                  : "quintic_fade";
}

std::string_view feature_name(WorleyFeature feature) {
    return feature == WorleyFeature::f1   ? "worley_f1"
           : feature == WorleyFeature::f2 ? "worley_f2"
                                          : "worley_f2_f1";
}

/// Of the lattice planes `low` and `high` and the place, of three coordinates or four.
std::string interpolated(const NoiseSpec& noise, bool timed) {
    switch (noise.kind) {
        case NoiseKind::value:
            return fmt::format("value_noise(seed, low, high, {}({}){})", fade_name(noise.fade),
                               timed ? "place + place" : "vec4(place + place, 0.0)",
                               timed ? "" : ".xyz");
        case NoiseKind::perlin:
            return "perlin_noise(seed, low, high, place)";
        case NoiseKind::perlin2002:
            return "perlin2002_noise(seed, low, high, place)";
        default:
            return timed ? "0.0" : "perlin1985_noise(seed, low, high, place)";
    }
}

/// Of the site, its cell in 32 bits, and if timed the fourth coordinate's cell_w and place_w.
std::string from_cells(const NoiseSpec& noise, bool timed) {
    switch (noise.kind) {
        case NoiseKind::simplex:
            return timed ? "simplex_noise(seed, site, cell_w, place_w)"
                         : fmt::format("simplex_noise(seed, site, period.xyz, {:.9g})",
                                       float(noise.radius2));
        case NoiseKind::worley:
            return fmt::format("{}(nearest_features(seed, cell, place, {}))",
                               feature_name(noise.feature), timed ? "period" : "period.xyz");
        case NoiseKind::cell:
            return "cell_noise(seed, cell)";
        default:
            return timed ? "white_noise(seed, cell.xyz, site.place, cell.w, place_w)"
                         : "white_noise(seed, cell, site.place)";
    }
}

/// The periods, and for simplex noise in three dimensions the one after which its hash repeats.
Period<4> cell_periods(const NoiseSpec& noise) {
    Period<4> period = noise.period;
    if (noise.kind == NoiseKind::simplex && !noise.time)
        for (std::uint32_t& p : period)
            if (p == 0) p = 768;
    return period;
}

}  // namespace

std::vector<GlslPart> glsl_noise_parts(std::span<const NoiseSpec> noises) {
    std::vector<GlslPart> parts{{"real.glsl"}, {"noise_lattice.glsl"}};
    for (const NoiseSpec& noise : noises)
        for (GlslPart& part : parts_of(noise.kind))
            if (std::ranges::find(parts, part) == parts.end()) parts.push_back(std::move(part));
    return parts;
}

std::string glsl_split_noise(const NoiseSpec& noise, std::string_view name) {
    return fmt::format(
        "float {}(uint seed, uvec3 cell, vec3 place) {{\n"
        "    uvec3 low = cell, high = cell + 1u;\n"
        "    return {};\n"
        "}}\n",
        name, interpolated(noise, false));
}

std::string glsl_site_noise(const NoiseSpec& noise, std::string_view name) {
    const bool timed = noise.time.has_value();
    const Period<4> period = cell_periods(noise);
    std::string text = fmt::format(
        "float {}(uint seed, real3 p, real time) {{\n"
        "    const uvec4 period = uvec4({}u, {}u, {}u, {}u);\n"
        "    LatticeSite site = lattice_site(p, period.xyz);\n",
        name, period[0], period[1], period[2], period[3]);
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
        return text + fmt::format("    return {};\n}}\n", from_cells(noise, timed));
    const std::string_view size = timed ? "4" : "3", range = timed ? "" : ".xyz";
    return text + fmt::format(
                      "    uvec{0} low = cell;\n"
                      "    uvec{0} high = lattice_index(cell, ivec{0}(1), period{1});\n"
                      "    return {2};\n}}\n",
                      size, range, interpolated(noise, timed));
}

std::string glsl_octave_shape(OctaveShape shape, std::string_view name) {
    return fmt::format("float {}(float n) {{\n    return {};\n}}\n", name,
                       shape == OctaveShape::plain      ? "n"
                       : shape == OctaveShape::absolute ? "abs(n)"
                                                        : "(1.0 - abs(n)) * (1.0 - abs(n))");
}

}  // namespace burl
