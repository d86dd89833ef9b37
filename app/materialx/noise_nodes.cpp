// Noises, of the recipe's nodes with MaterialX's definitions.
#include <array>

#include "app/materialx/nodes.h"

namespace burl::materialx {

namespace {

/// The dimensions that a category's name ends with: "noise3d".
int dimensions_of(const NodeCall& call) {
    return call.node.tag.ends_with("2d") ? 2 : 3;
}

/// The place where a noise is evaluated.
Value place_of(const NodeCall& call) {
    return dimensions_of(call) == 2 ? call.geometry("texcoord", "UV0")
                                    : call.geometry("position", "Pobject");
}

/// A noise: the name of its node, which "_color" makes one of three numbers, and its inputs besides
/// the position.
struct Noise {
    std::string node;
    int dimensions;
    NodeInputs inputs{};
    Json parameters = Json::object();
    /// By how far the place of the fourth component is moved, as measured
    /// (tests/app/materialx/graphs.mtlx).
    std::array<double, 3> elsewhere{19.0, 73.0, 29.0};
    bool pairs = false;  ///< whether a vector2 is two numbers, the second of which is elsewhere
};

NodeRef noise_at(const NodeCall& call, const Noise& noise, const Value& place, bool color) {
    NodeInputs inputs{{"position", call.values().vector(place)}};
    inputs.insert(inputs.end(), noise.inputs.begin(), noise.inputs.end());
    Json parameters = noise.parameters;
    parameters["dimensions"] = noise.dimensions == 2 ? "2" : "3";
    return call.nodes().node(noise.node + (color ? "_color" : ""), color, inputs, parameters);
}

/// The place moved by a vector.
Value moved(const NodeCall& call, const Value& place, const std::vector<double>& by) {
    return call.values().apply("add", place.type, {place, call.values().constant(place.type, by)});
}

/// The noise's number at a place moved by its `elsewhere`.
NodeRef noise_elsewhere(const NodeCall& call, const Noise& noise, const Value& place) {
    std::vector<double> offset(noise.elsewhere.begin(), noise.elsewhere.end());
    offset.resize(std::size_t(noise.dimensions));
    return noise_at(call, noise, moved(call, place, offset), false);
}

/// The noise as a value of the node's type.
Value noise_value(const NodeCall& call, const Noise& noise) {
    const Value place = place_of(call);
    if (is_number(call.type)) return call.made(noise_at(call, noise, place, false));
    if (call.type == Type::vector2 && noise.pairs)
        return call.values().of_parts(
            call.type, {noise_at(call, noise, place, false), noise_elsewhere(call, noise, place)});
    const NodeRef color = noise_at(call, noise, place, true);
    if (size_of(call.type) < 4) return call.values().of_color(call.type, color);
    return call.values().of_color(call.type, color, noise_elsewhere(call, noise, place));
}

Value with_amplitude(const NodeCall& call, const Value& value) {
    return call.values().apply("multiply", call.type, {value, call.in("amplitude", 1.0)});
}

Value perlin(const NodeCall& call) {
    const Value value = noise_value(call, {"materialx_noise", dimensions_of(call)});
    return call.values().apply("add", call.type,
                               {with_amplitude(call, value), call.in("pivot", Type::number, 0.0)});
}

/// The inputs that a fractal has.
NodeInputs fractal_inputs(const NodeCall& call) {
    return {{"octaves", call.values().part(call.in("octaves", Type::integer, 3.0), 0)},
            {"lacunarity", call.number("lacunarity", 2.0)},
            {"diminish", call.number("diminish", 0.5)}};
}

Value fractal(const NodeCall& call) {
    const Noise noise{"materialx_fractal", dimensions_of(call), fractal_inputs(call),
                      Json::object(),      {19.0, 193.0, 17.0}, true};
    return with_amplitude(call, noise_value(call, noise));
}

Value cells(const NodeCall& call) {
    return noise_value(call, {"materialx_cellnoise", dimensions_of(call)});
}

/// The parameter of Worley's noise; nothing where the node's style is none of the two.
std::optional<Json> style_of(const NodeCall& call) {
    const auto style = call.constant("style", 0.0);
    if (style == 0.0) return Json{{"style", "distance"}};
    if (style == 1.0) return Json{{"style", "solid"}};
    return {};
}

Value worley(const NodeCall& call) {
    const auto style = style_of(call);
    if (!style) return call.refused("its style is neither 0 nor 1");
    return noise_value(call, {"materialx_worley",
                              dimensions_of(call),
                              {{"jitter", call.number("jitter", 1.0)}},
                              *style});
}

}  // namespace

std::span<const NodeRow> noise_rows() {
    static constexpr std::array rows{
        NodeRow{"noise2d", perlin},       NodeRow{"noise3d", perlin},
        NodeRow{"fractal2d", fractal},    NodeRow{"fractal3d", fractal},
        NodeRow{"cellnoise2d", cells},    NodeRow{"cellnoise3d", cells},
        NodeRow{"worleynoise2d", worley}, NodeRow{"worleynoise3d", worley}};
    return rows;
}

}  // namespace burl::materialx
