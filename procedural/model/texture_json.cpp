#include "procedural/model/texture_json.h"

#include <algorithm>
#include <iterator>

#include "procedural/model/members.h"
#include "procedural/noise/names.h"

namespace burl {

namespace {

using Json = nlohmann::ordered_json;

MemberParameter coefficient(std::string_view path, double Quadric::*member, std::string_view tip,
                            std::string_view label) {
    return member_row(path, member, {-1e9, 1e9, 0.05}, tip, {.label = label});
}

/// The name of a node, which is no member.
MemberParameter node_row(std::string_view path, std::string_view name, std::string_view tip) {
    const std::string_view quoted = members::kept(fmt::format("\"{}\"", name));
    return {{path, ParameterType::choice, 0, 0, 0, 1, "", quoted, name, tip}};
}

/// The colour of a stop, which is two members: colour and alpha.
MemberParameter stop_color_row() {
    MemberParameter row = member_row("texture.stops.*.1", &ColorStop::color, {},
                                     "sRGB colour of a stop", {.required = true});
    row.alpha = true;
    row.read = [](const Json& json, void* owner) {
        auto& stop = *static_cast<ColorStop*>(owner);
        const auto text = json.get<std::string>();
        stop.color = color_from_hex(text);
        stop.alpha = alpha_from_hex(text);
    };
    row.write = [](const void* owner) {
        const auto& stop = *static_cast<const ColorStop*>(owner);
        return Json(color_to_hex(stop.color, stop.alpha));
    };
    return row;
}

/// Rows of the colour map and of the quadric.
std::vector<MemberParameter> map_rows() {
    return {
        node_row("texture.node", "color_map", "kind of the tree's root"),
        member_row("texture.wrap", &ColorMap::wrap, {},
                   "the map's index modulo one, or clamped to [0,1]"),
        member_row("texture.stops.*.0", &ColorStop::position, {0, 1, 0.01},
                   "index of a stop, not below the stop before it", {.required = true}),
        stop_color_row(),
        node_row("texture.input.node", "field", "kind of the node that gives the index"),
        coefficient("texture.input.quadric.A", &Quadric::a, "coefficient of s^2", "s\u00b2"),
        coefficient("texture.input.quadric.B", &Quadric::b, "half the coefficient of s t", "2 s t"),
        coefficient("texture.input.quadric.C", &Quadric::c, "half the coefficient of s r", "2 s r"),
        coefficient("texture.input.quadric.D", &Quadric::d, "half the coefficient of s", "2 s"),
        coefficient("texture.input.quadric.E", &Quadric::e, "coefficient of t^2", "t\u00b2"),
        coefficient("texture.input.quadric.F", &Quadric::f, "half the coefficient of t r", "2 t r"),
        coefficient("texture.input.quadric.G", &Quadric::g, "half the coefficient of t", "2 t"),
        coefficient("texture.input.quadric.H", &Quadric::h, "coefficient of r^2", "r\u00b2"),
        coefficient("texture.input.quadric.I", &Quadric::i, "half the coefficient of r", "2 r"),
        coefficient("texture.input.quadric.J", &Quadric::j, "constant", "constant")};
}

/// Rows of a noise term.
std::vector<MemberParameter> noise_rows() {
    return {
        member_row("texture.input.noise.*.kind", &NoiseTerm::kind, {},
                   "which noise; docs/reference/noise.md defines them"),
        member_row("texture.input.noise.*.fade", &NoiseTerm::fade, {},
                   "interpolation between lattice points; value noise only"),
        member_row(
            "texture.input.noise.*.feature", &NoiseTerm::feature, {},
            "distance to the nearest or the second nearest point, or their difference; worley only",
            {.label = "distance to"}),
        member_row("texture.input.noise.*.radius2", &NoiseTerm::radius2, {0.1, 0.6, 0.05},
                   "squared radius of the kernels; simplex only, continuous up to 0.5",
                   {.label = "kernel radius, squared"}),
        member_row("texture.input.noise.*.period", &NoiseTerm::period,
                   {0, largest_period, 1, "cells"},
                   "whole cells of the first octave after which the noise repeats; 0: never",
                   {.label = "repeats after"}),
        member_row("texture.input.noise.*.time", &NoiseTerm::time, {-1e9, 1e9, 0.1, "cells"},
                   "fourth lattice coordinate, the same in every octave; left out: noise of three "
                   "dimensions",
                   {.rare = true}),
        member_row("texture.input.noise.*.time_period", &NoiseTerm::time_period,
                   {0, largest_period, 1, "cells"},
                   "whole cells along time after which the noise repeats; 0: never",
                   {.label = "repeats in time after", .rare = true}),
        member_row("texture.input.noise.*.sum", &NoiseTerm::shape, {},
                   "what octaves add: n, |n| or (1 - |n|)^2", {.label = "octaves add"}),
        member_row("texture.input.noise.*.weights", &NoiseTerm::normalized,
                   {.words = "raw|normalized"},
                   "normalized: amplitudes are divided by the sum of gain^k", {.rare = true}),
        member_row("texture.input.noise.*.range", &NoiseTerm::range, {},
                   "n from 0 or about 0; left out: unit for value, worley, turbulence and ridged",
                   {.label = "values", .rare = true}),
        member_row("texture.input.noise.*.amplitude", &NoiseTerm::amplitude, {-1e6, 1e6, 0.05},
                   "factor of the first octave"),
        member_row("texture.input.noise.*.frequency", &NoiseTerm::frequency, {-1e6, 1e6, 0.1},
                   "lattice cells per unit of s, t and r"),
        member_row("texture.input.noise.*.phase", &NoiseTerm::phase, {-1e9, 1e9, 0.1, "cells"},
                   "added to the lattice coordinates of every octave, never scaled",
                   {.label = "shift"}),
        member_row("texture.input.noise.*.matrix", &NoiseTerm::matrix, {-1e9, 1e9, 0.1},
                   "3 rows of 4: affine map to lattice coordinates in place of frequency and phase",
                   {.rare = true}),
        member_row("texture.input.noise.*.seed", &NoiseTerm::seed, {0, 4294967295.0, 1},
                   "number of the random lattice; octave k uses seed + k"),
        member_row("texture.input.noise.*.octaves", &NoiseTerm::octaves, {1, 24, 1},
                   "how many octaves are summed", {.label = "detail (octaves)"}),
        member_row("texture.input.noise.*.lacunarity", &NoiseTerm::lacunarity, {0.01, 16, 0.05},
                   "frequency ratio from one octave to the next", {.label = "octave spacing"}),
        member_row("texture.input.noise.*.gain", &NoiseTerm::gain, {0, 2, 0.05},
                   "amplitude ratio from one octave to the next", {.label = "roughness"})};
}

std::vector<MemberParameter> make_table() {
    std::vector<MemberParameter> table = map_rows();
    std::ranges::move(noise_rows(), std::back_inserter(table));
    return table;
}

/// Whether a noise term is written with this key even where it has its default.
bool is_always_written(std::string_view key, const NoiseTerm& term) {
    constexpr std::array<std::string_view, 6> always{"kind",    "amplitude",  "seed",
                                                     "octaves", "lacunarity", "gain"};
    if (key == "fade") return term.kind == NoiseKind::value;
    if (key == "frequency" || key == "phase") return !term.matrix;
    return std::ranges::find(always, key) != always.end();
}

Json field_to_json(const Texture& texture) {
    Json json{{"node", "field"}, {"quadric", Json::object()}, {"noise", Json::array()}};
    write_members(texture_parameters(), texture.quadric, json["quadric"],
                  [](std::string_view) { return false; });
    for (const NoiseTerm& term : texture.noise)
        write_members(texture_parameters(), term, json["noise"].emplace_back(),
                      [&](std::string_view key) { return is_always_written(key, term); });
    return json;
}

void read_field(const Json& json, Texture& texture) {
    if (json.contains("quadric"))
        read_members(texture_parameters(), json["quadric"], texture.quadric);
    if (json.contains("noise")) read_list(texture_parameters(), json["noise"], texture.noise);
}

}  // namespace

std::span<const MemberParameter> texture_parameters() {
    static const std::vector<MemberParameter> table = make_table();
    return table;
}

Rgb8 color_from_hex(const std::string& text) {
    const auto channel = [&text](std::size_t at) {
        return std::uint8_t(std::stoul(text.substr(at, 2), nullptr, 16));
    };
    return {channel(1), channel(3), channel(5)};
}

std::uint8_t alpha_from_hex(const std::string& text) {
    return text.size() == 9 ? std::uint8_t(std::stoul(text.substr(7), nullptr, 16)) : 255;
}

std::string color_to_hex(const Rgb8& color, std::uint8_t alpha) {
    const std::string text = fmt::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b);
    return alpha == 255 ? text : fmt::format("{}{:02x}", text, alpha);
}

Texture texture_from_json(const Json& json) {
    Texture texture;
    read_members(texture_parameters(), json, texture.colors);
    if (json.contains("stops"))
        read_list(texture_parameters(), json["stops"], texture.colors.stops);
    else
        texture.colors.stops = {{0.0, {0, 0, 0}}, {1.0, {255, 255, 255}}};
    if (json.contains("input")) read_field(json["input"], texture);
    return texture;
}

Json stops_to_json(const std::vector<ColorStop>& stops) {
    return list_json(texture_parameters(), stops);
}

Json texture_to_json(const Texture& texture) {
    Json json{{"node", "color_map"}};
    write_members(texture_parameters(), texture.colors, json);
    json["stops"] = stops_to_json(texture.colors.stops);
    json["input"] = field_to_json(texture);
    return json;
}

}  // namespace burl
