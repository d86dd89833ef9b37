#include "app/recipe/parameters.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <deque>
#include <optional>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/recipe/names.h"
#include "app/recipe/recipe.h"
#include "app/recipe/schema_tree.h"
#include "procedural/model/texture_json.h"

namespace burl {

namespace {

using enum ParameterType;

/// The type of a value that a member has once, at most once or any number of times.
template <class T>
struct Item {
    using Value = T;
};
template <class T>
struct Item<std::optional<T>> {
    using Value = T;
};
template <class T>
struct Item<std::vector<T>> {
    using Value = T;
};

template <class T>
inline constexpr bool is_optional = std::same_as<T, std::optional<typename Item<T>::Value>>;
template <class T>
inline constexpr bool is_list = std::same_as<T, std::vector<typename Item<T>::Value>>;
template <class T>
inline constexpr bool is_choice = std::is_enum_v<T> || std::same_as<T, bool>;

template <class T>
constexpr ParameterType parameter_type() {
    if (is_choice<T>) return ParameterType::choice;
    if (std::integral<T>) return ParameterType::integer;
    if (std::floating_point<T>) return ParameterType::number;
    if (std::same_as<T, std::string>) return ParameterType::text;
    return std::same_as<T, Rgb8> ? ParameterType::color : ParameterType::numbers;
}

/// Sets a value from JSON that has been checked.
template <class T>
void read_value(const Parameter& parameter, const Json& json, T& value) {
    if constexpr (is_optional<T>) {
        read_value(parameter, json, value.emplace());
    } else if constexpr (is_list<T>) {
        for (const Json& item : json) read_value(parameter, item, value.emplace_back());
    } else if constexpr (is_choice<T>) {
        const auto words = split_choices(parameter.choices);
        value = T(std::ranges::find(words, json.get<std::string>()) - words.begin());
    } else if constexpr (std::integral<T>) {
        value = T(json.get<double>());  // also written as 4.0 or 1e3
    } else if constexpr (std::same_as<T, Vec3d>) {
        value = {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
    } else if constexpr (std::same_as<T, Rgb8>) {
        value = color_from_hex(json.get<std::string>());
    } else {
        value = json.get<T>();
    }
}

/// Returns a value as JSON; null for an optional without one.
template <class T>
Json value_json(const Parameter& parameter, const T& value) {
    if constexpr (is_optional<T>) {
        return value ? value_json(parameter, *value) : Json();
    } else if constexpr (is_list<T>) {
        Json items = Json::array();
        for (const auto& item : value) items.push_back(value_json(parameter, item));
        return items;
    } else if constexpr (is_choice<T>) {
        return split_choices(parameter.choices)[std::size_t(value)];
    } else if constexpr (std::same_as<T, Vec3d>) {
        return {value.x, value.y, value.z};
    } else if constexpr (std::same_as<T, Rgb8>) {
        return color_to_hex(value);
    } else {
        return value;
    }
}

/// Returns a view of a text that lives as long as the table.
std::string_view kept(std::string text) {
    static std::deque<std::string> texts;
    return texts.emplace_back(std::move(text));
}

/// A default as the table writes it: whole numbers have no point; empty for null.
std::string_view default_text(const Json& json) {
    if (json.is_null()) return "";
    if (json.is_number()) return kept(fmt::format("{}", json.get<double>()));
    if (!json.is_array()) return kept(json.dump());
    return kept(fmt::format("[{}]", fmt::join(json.get<std::vector<double>>(), ",")));
}

/// The range of a number, both ends included, the step of one notch of a slider, and its unit;
/// the words for a bool's false and true, separated by "|".
struct Range {
    double low = 0.0, high = 0.0, step = 0.0;
    std::string_view unit{}, words{};
};

/// The parameter that a member stands for: its type, its default, its words and how JSON of it is
/// read and written follow from the member.
template <class Owner, class Member>
RecipeParameter row(std::string_view path, Member Owner::*member, const Range& range,
                    std::string_view tip, const ParameterUse& use = {}) {
    using Value = typename Item<Member>::Value;
    static_assert(!std::is_enum_v<Value> || NamedEnum<Value>, "enum_names has no words for it");
    const auto& [low, high, step, unit, words] = range;
    Parameter parameter{path, parameter_type<Value>(), low, high, step, 1, unit, "", words, tip};
    if constexpr (NamedEnum<Value>)
        parameter.choices = kept(fmt::format("{}", fmt::join(enum_names<Value>, "|")));
    if (parameter.type == ParameterType::numbers)
        parameter.count = value_json(parameter, Value{}).size();
    if (!use.required)
        parameter.default_value = default_text(value_json(parameter, Owner{}.*member));
    return {parameter, use, &typeid(Owner),
            [=](const Json& json, void* owner) {
                read_value(parameter, json, static_cast<Owner*>(owner)->*member);
            },
            [=](const void* owner) {
                return value_json(parameter, static_cast<const Owner*>(owner)->*member);
            }};
}

std::string only_atlases(AtlasKind wanted, const Recipe& recipe) {
    if (recipe.atlas.kind == wanted) return "";
    return fmt::format(
        "only {0} atlases have it, and this one is {1}; add --atlas {0}, or leave it out",
        to_string(wanted), to_string(recipe.atlas.kind));
}

std::string only_quads(const Recipe& recipe) {
    return only_atlases(AtlasKind::quad, recipe);
}

std::string only_bilinear_quads(const Recipe& recipe) {
    const std::string why = only_quads(recipe);
    if (!why.empty() || recipe.atlas.overscan == Overscan::bilinear) return why;
    return "with overscan nearest there is none of it; add --overscan bilinear, or leave it out";
}

std::string only_patches(const Recipe& recipe) {
    return only_atlases(AtlasKind::patch, recipe);
}

std::string only_supersample(const Recipe& recipe) {
    if (recipe.filter.kind == FilterKind::supersample) return "";
    return "only --filter supersample takes samples; add that, or leave it out";
}

std::string only_fixed(const Recipe& recipe) {
    if (recipe.precision.kind == PrecisionKind::fixed) return "";
    return "only fixed point has these bits; use --precision fixed:I.F, or leave it out";
}

template <class Owner>
RecipeParameter coefficient(std::string_view path, double Owner::*member, std::string_view tip,
                            std::string_view label) {
    return row(path, member, {-1e9, 1e9, 0.05}, tip, {.label = label});
}

/// An option that few people need.
ParameterUse rare_option(std::string_view option, std::string_view help,
                         std::string (*idle)(const Recipe&) = nullptr,
                         std::string_view label = "") {
    return {option, help, label, true, false, idle};
}

/// The name of a node, which is no member.
RecipeParameter node_row(std::string_view path, std::string_view name, std::string_view tip) {
    return {{path, choice, 0, 0, 0, 1, "", kept(fmt::format("\"{}\"", name)), name, tip}};
}

// Members of the 1999 model give a type, a default and words; texture_json.h reads and writes them.
std::vector<RecipeParameter> make_table() {
    return {
        {{"burl", integer, 1, 1, 1, 1, "", "1", "", "version of this format"}},
        row("name", &Recipe::name, {}, "what the texture is called"),
        row("atlas.kind", &AtlasOptions::kind, {}, "how triangles are packed",
            {.option = "-a,--atlas", .help = "Atlas: {}"}),
        row("atlas.size", &AtlasOptions::size, {1, max_atlas_size, 256, "texels"},
            "width and height of the texture; quad: a power of two",
            {.option = "-s,--size", .help = "Side N of the N x N texture, in texels"}),
        row("atlas.overscan", &AtlasOptions::overscan, {},
            "the look-up the texture is prepared for",
            rare_option("--overscan", "Lookup the atlas is made for: {}", nullptr, "for lookups")),
        row("atlas.weight", &AtlasOptions::weight, {},
            "what a pair's share of a quad atlas follows; the other kinds ignore it",
            rare_option("--weight", "What a pair's share of a quad atlas follows: {}", only_quads)),
        row("atlas.partition", &AtlasOptions::partition, {},
            "how a quad atlas finds clusters: by bisecting coordinates, or the graph of "
            "neighbouring pairs",
            rare_option("--partition",
                        "How a quad atlas finds clusters: rcb (coordinates) or graph", only_quads)),
        row("atlas.gutter", &AtlasOptions::gutter, {0, 64, 1, "texels"},
            "quad, bilinear: texels round every pair that go on with its triangles; fewer in small "
            "blocks",
            rare_option("--gutter", "Texels that a quad atlas leaves round every pair",
                        only_bilinear_quads)),
        row("atlas.diagonals", &AtlasOptions::diagonals, {},
            "quad, bilinear: whether pairs meet on the diagonal, or lie apart where they would "
            "meet in a kink",
            rare_option("--diagonals",
                        "Pairs of a quad atlas: shared, or with overscan for more than 8 bits",
                        only_bilinear_quads, "pairs meet")),
        row("atlas.tries", &AtlasOptions::tries, {1, 6, 1},
            "partitions a patch atlas is chosen from; the other kinds ignore it",
            rare_option("--tries", "Partitions a patch atlas is chosen from, 1 to 6",
                        only_patches)),
        row("solid.space", &SolidOptions::space, {},
            "unit: the mesh's box centred, longest side 1; object: the file's coordinates"),
        row("solid.scale", &SolidOptions::scale, {1e-6, 1e6, 0.1},
            "solid coordinates are multiplied by it"),
        row("solid.rotate", &SolidOptions::rotate, {-360, 360, 4.5, "degrees"},
            "turns solid coordinates about x, then y, then z, before the scale", {.label = "turn"}),
        row("solid.translate", &SolidOptions::translate, {-1e6, 1e6, 0.05},
            "added to solid coordinates after the scale", {.label = "move"}),
        node_row("texture.node", "color_map", "kind of the tree's root"),
        row("texture.wrap", &ColorMap::wrap, {}, "the map's index modulo one, or clamped to [0,1]"),
        row("texture.stops.*.0", &ColorStop::position, {0, 1, 0.01},
            "index of a stop, not below the stop before it", {.required = true}),
        row("texture.stops.*.1", &ColorStop::color, {}, "sRGB colour of a stop",
            {.required = true}),
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
        coefficient("texture.input.quadric.J", &Quadric::j, "constant", "constant"),
        row("texture.input.noise.*.kind", &NoiseTerm::kind, {},
            "which noise; docs/reference/noise.md defines them"),
        row("texture.input.noise.*.fade", &NoiseTerm::fade, {},
            "interpolation between lattice points; value noise only"),
        row("texture.input.noise.*.feature", &NoiseTerm::feature, {},
            "distance to the nearest or the second nearest point, or their difference; worley only",
            {.label = "distance to"}),
        row("texture.input.noise.*.radius2", &NoiseTerm::radius2, {0.1, 0.6, 0.05},
            "squared radius of the kernels; simplex only, continuous up to 0.5",
            {.label = "kernel radius, squared"}),
        row("texture.input.noise.*.period", &NoiseTerm::period, {0, largest_period, 1, "cells"},
            "whole cells of the first octave after which the noise repeats; 0: never",
            {.label = "repeats after"}),
        row("texture.input.noise.*.time", &NoiseTerm::time, {-1e9, 1e9, 0.1, "cells"},
            "fourth lattice coordinate, the same in every octave; left out: noise of three "
            "dimensions",
            {.rare = true}),
        row("texture.input.noise.*.time_period", &NoiseTerm::time_period,
            {0, largest_period, 1, "cells"},
            "whole cells along time after which the noise repeats; 0: never",
            {.label = "repeats in time after", .rare = true}),
        row("texture.input.noise.*.sum", &NoiseTerm::shape, {},
            "what octaves add: n, |n| or (1 - |n|)^2", {.label = "octaves add"}),
        row("texture.input.noise.*.weights", &NoiseTerm::normalized, {.words = "raw|normalized"},
            "normalized: amplitudes are divided by the sum of gain^k", {.rare = true}),
        row("texture.input.noise.*.range", &NoiseTerm::range, {},
            "n from 0 or about 0; left out: unit for value, worley, turbulence and ridged",
            {.label = "values", .rare = true}),
        row("texture.input.noise.*.amplitude", &NoiseTerm::amplitude, {-1e6, 1e6, 0.05},
            "factor of the first octave"),
        row("texture.input.noise.*.frequency", &NoiseTerm::frequency, {-1e6, 1e6, 0.1},
            "lattice cells per unit of s, t and r"),
        row("texture.input.noise.*.phase", &NoiseTerm::phase, {-1e9, 1e9, 0.1, "cells"},
            "added to the lattice coordinates of every octave, never scaled", {.label = "shift"}),
        row("texture.input.noise.*.matrix", &NoiseTerm::matrix, {-1e9, 1e9, 0.1},
            "3 rows of 4: affine map to lattice coordinates in place of frequency and phase",
            {.rare = true}),
        row("texture.input.noise.*.seed", &NoiseTerm::seed, {0, 4294967295.0, 1},
            "number of the random lattice; octave k uses seed + k"),
        row("texture.input.noise.*.octaves", &NoiseTerm::octaves, {1, 24, 1},
            "how many octaves are summed", {.label = "detail (octaves)"}),
        row("texture.input.noise.*.lacunarity", &NoiseTerm::lacunarity, {0.01, 16, 0.05},
            "frequency ratio from one octave to the next", {.label = "octave spacing"}),
        row("texture.input.noise.*.gain", &NoiseTerm::gain, {0, 2, 0.05},
            "amplitude ratio from one octave to the next", {.label = "roughness"}),
        row("bump.height", &Bump::height, {-1e6, 1e6, 0.001, "solid units"},
            "rise of the surface where bump.input grows by 1; solid.scale does not change it"),
        row("filter.kind", &Filter::kind, {}, "how a texel's area is averaged"),
        row("filter.samples", &Filter::samples, {1, 1024, 1},
            "supersample: places per texel; squares are spread best", {.idle = only_supersample}),
        row("filter.octaves", &Filter::band_limit, {.words = "keep|fade"},
            "fade: octaves finer than a texel are left out, the last one in part"),
        row("precision.kind", &Precision::kind, {},
            "arithmetic of the texture; left out: float32 for bakes, float64 for render --direct"),
        row("precision.integer_bits", &FixedFormat::integer_bits, {1, 16, 1, "bits"},
            "fixed: bits before the point, the sign's among them", {.idle = only_fixed}),
        row("precision.fraction_bits", &FixedFormat::fraction_bits, {2, 16, 1, "bits"},
            "fixed: bits after the point", {.idle = only_fixed}),
        row("paint.*.mode", &PaintStroke::mode, {},
            "erase: takes away the paint of the strokes before it"),
        row("paint.*.color", &PaintStroke::color, {}, "sRGB colour"),
        row("paint.*.radius", &PaintStroke::radius, {1e-6, 1e6, 0.005, "solid units"},
            "of the ball that is moved along the points; solid.scale does not change it"),
        row("paint.*.hardness", &PaintStroke::hardness, {0, 1, 0.05},
            "share of the radius that is covered evenly; from there on less and less"),
        row("paint.*.opacity", &PaintStroke::opacity, {0, 1, 0.05},
            "share of the stroke's colour where it covers most"),
        row("paint.*.points.*", &PaintStroke::points, {-1e9, 1e9, 0.01, "solid units"},
            "a point of the stroke's line, before solid.scale", {.required = true}),
        row("pose.weight", &PoseOptions::weight, {0, 1, 0.05},
            "of a mesh with a pose, how far it has gone there; the texture sticks to it"),
        row("animation.seconds", &KeyedAnimation::seconds, {0.01, 3600, 0.1, "s"},
            "how long the animation is"),
        row("animation.rate", &KeyedAnimation::rate, {1, 240, 1, "frames/s"},
            "frames a second of the editor's clock and of frames that it exports"),
        row("animation.end", &KeyedAnimation::loop, {.words = "stop|loop"},
            "loop: the end is the beginning, and no frame is made of it"),
        row("animation.tracks.*.path", &KeyTrack::path, {},
            "the number that changes, as --set takes it; nothing of the atlas", {.required = true}),
        row("animation.tracks.*.ease", &KeyTrack::ease, {},
            "how it goes from key to key; smooth: at rest in every key"),
        row("animation.tracks.*.keys.*.0", &KeyPoint::seconds, {0, 3600, 0.1, "s"},
            "when a key is, later than the key before it", {.required = true}),
        row("animation.tracks.*.keys.*.1", &KeyPoint::value, {-1e9, 1e9, 0.1},
            "what the number is then, within its own range", {.required = true})};
}

bool is_digits(std::string_view part) {
    return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::span<const RecipeParameter> parameters() {
    static const std::vector<RecipeParameter> table = make_table();
    return table;
}

const RecipeParameter* find_parameter(std::string_view path) {
    const auto parts = split_path(path);
    const auto all = parameters();
    const auto found = std::ranges::find_if(all, [&](const RecipeParameter& one) {
        return std::ranges::equal(split_path(one.path), parts, [](auto known, auto part) {
            return known == part || (known == "*" && is_digits(part));
        });
    });
    return found == all.end() ? nullptr : &*found;
}

std::string_view to_string(ParameterType type) {
    constexpr std::array<std::string_view, 6> names{"number", "integer", "numbers",
                                                    "text",   "choice",  "color"};
    return names[std::size_t(type)];
}

std::vector<std::string_view> split_choices(std::string_view choices) {
    std::vector<std::string_view> words;
    while (!choices.empty()) {
        const std::size_t end = std::min(choices.find('|'), choices.size());
        words.push_back(choices.substr(0, end));
        choices.remove_prefix(std::min(end + 1, choices.size()));
    }
    return words;
}

}  // namespace burl
