#include "procedural/model/texture_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "procedural/noise/names.h"

namespace burl {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array wraps{Named{"repeat", Wrap::repeat}, Named{"clamp", Wrap::clamp}};
constexpr std::array ranges{Named{"unit", NoiseRange::unit}, Named{"signed", NoiseRange::bipolar}};
constexpr std::array weights{Named{"raw", false}, Named{"normalized", true}};

template <class T, std::size_t N>
using Names = std::array<Named<T>, N>;

template <class T, std::size_t N>
T value_of(const Names<T, N>& names, const std::string& name, T otherwise) {
    for (const auto& known : names)
        if (name == known.name) return known.value;
    return otherwise;
}

template <class T, std::size_t N>
std::string_view name_of(const Names<T, N>& names, T value) {
    for (const auto& known : names)
        if (value == known.value) return known.name;
    return "";
}

/// Sets `target` to the key's value, if the key is there.
template <class T>
void read(const Json& json, const char* key, T& target) {
    if (json.contains(key)) target = json[key].get<T>();
}

void read(const Json& json, const char* key, std::uint32_t& target) {
    // Whole numbers may be written as 4.0 or 1e3.
    if (json.contains(key)) target = std::uint32_t(json[key].get<double>());
}

void read(const Json& json, const char* key, Vec3d& target) {
    if (!json.contains(key)) return;
    for (int axis = 0; axis < 3; ++axis) target[axis] = json[key][std::size_t(axis)].get<double>();
}

void read(const Json& json, const char* key, Period<3>& target) {
    if (!json.contains(key)) return;
    for (std::size_t axis = 0; axis < 3; ++axis)
        target[axis] = std::uint32_t(json[key][axis].get<double>());
}

template <class T, std::size_t N>
void read(const Json& json, const char* key, const Names<T, N>& names, T& target) {
    if (json.contains(key)) target = value_of(names, json[key].get<std::string>(), target);
}

Json to_json(const Vec3d& v) {
    return Json::array({v.x, v.y, v.z});
}

/// The ten coefficients under the names of eq. (3).
template <class QuadricType, class Function>
void for_each_coefficient(QuadricType& q, Function&& function) {
    function("A", q.a), function("B", q.b), function("C", q.c), function("D", q.d);
    function("E", q.e), function("F", q.f), function("G", q.g), function("H", q.h);
    function("I", q.i), function("J", q.j);
}

NoiseTerm noise_from_json(const Json& json) {
    NoiseTerm term;
    read(json, "kind", noise_kinds, term.kind);
    read(json, "fade", fade_names, term.fade);
    read(json, "feature", feature_names, term.feature);
    read(json, "radius2", term.radius2);
    read(json, "period", term.period);
    if (json.contains("time")) term.time = json["time"].get<double>();
    read(json, "time_period", term.time_period);
    read(json, "sum", sum_names, term.shape);
    read(json, "weights", weights, term.normalized);
    if (json.contains("range"))
        term.range = value_of(ranges, json["range"].get<std::string>(), NoiseRange::unit);
    read(json, "amplitude", term.amplitude);
    read(json, "frequency", term.frequency);
    read(json, "phase", term.phase);
    if (json.contains("matrix")) term.matrix = json["matrix"].get<std::array<double, 12>>();
    read(json, "seed", term.seed);
    read(json, "octaves", term.octaves);
    read(json, "lacunarity", term.lacunarity);
    read(json, "gain", term.gain);
    return term;
}

Json noise_to_json(const NoiseTerm& term) {
    const NoiseTerm defaults;
    Json json;
    json["kind"] = name_of(noise_kinds, term.kind);
    if (term.kind == NoiseKind::value || term.fade != defaults.fade)
        json["fade"] = name_of(fade_names, term.fade);
    if (term.feature != defaults.feature) json["feature"] = name_of(feature_names, term.feature);
    if (term.radius2 != defaults.radius2) json["radius2"] = term.radius2;
    if (term.period != defaults.period) json["period"] = term.period;
    if (term.time) json["time"] = *term.time;
    if (term.time_period != defaults.time_period) json["time_period"] = term.time_period;
    if (term.shape != defaults.shape) json["sum"] = name_of(sum_names, term.shape);
    if (term.normalized) json["weights"] = name_of(weights, term.normalized);
    if (term.range) json["range"] = name_of(ranges, *term.range);
    json["amplitude"] = term.amplitude;
    if (!term.matrix || term.frequency != defaults.frequency)
        json["frequency"] = to_json(term.frequency);
    if (!term.matrix || term.phase != defaults.phase) json["phase"] = to_json(term.phase);
    if (term.matrix) json["matrix"] = *term.matrix;
    json["seed"] = term.seed;
    json["octaves"] = term.octaves;
    json["lacunarity"] = term.lacunarity;
    json["gain"] = term.gain;
    return json;
}

Json field_to_json(const Texture& texture) {
    Json json{{"node", "field"}, {"quadric", Json::object()}, {"noise", Json::array()}};
    for_each_coefficient(texture.quadric, [&json](const char* name, double coefficient) {
        if (coefficient != 0.0) json["quadric"][name] = coefficient;
    });
    for (const NoiseTerm& term : texture.noise) json["noise"].push_back(noise_to_json(term));
    return json;
}

void read_field(const Json& json, Texture& texture) {
    if (json.contains("quadric"))
        for_each_coefficient(texture.quadric, [&](const char* name, double& coefficient) {
            read(json["quadric"], name, coefficient);
        });
    if (!json.contains("noise")) return;
    for (const Json& term : json["noise"]) texture.noise.push_back(noise_from_json(term));
}

}  // namespace

Rgb8 color_from_hex(const std::string& text) {
    const auto channel = [&text](std::size_t at) {
        return std::uint8_t(std::stoul(text.substr(at, 2), nullptr, 16));
    };
    return {channel(1), channel(3), channel(5)};
}

std::string color_to_hex(const Rgb8& color) {
    return fmt::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b);
}

Texture texture_from_json(const Json& json) {
    Texture texture;
    read(json, "wrap", wraps, texture.colors.wrap);
    if (json.contains("stops")) {
        for (const Json& stop : json["stops"])
            texture.colors.stops.push_back(
                {stop[0].get<double>(), color_from_hex(stop[1].get<std::string>())});
    } else {
        texture.colors.stops = {{0.0, {0, 0, 0}}, {1.0, {255, 255, 255}}};
    }
    if (json.contains("input")) read_field(json["input"], texture);
    return texture;
}

Json stops_to_json(const std::vector<ColorStop>& stops) {
    Json json = Json::array();
    for (const ColorStop& stop : stops)
        json.push_back(Json::array({stop.position, color_to_hex(stop.color)}));
    return json;
}

Json texture_to_json(const Texture& texture) {
    return Json{{"node", "color_map"},
                {"wrap", name_of(wraps, texture.colors.wrap)},
                {"stops", stops_to_json(texture.colors.stops)},
                {"input", field_to_json(texture)}};
}

}  // namespace burl
