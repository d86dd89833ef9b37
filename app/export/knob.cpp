#include "app/export/knob.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/base/shader_numbers.h"
#include "app/export/formula_glsl.h"
#include "app/recipe/edit/formula.h"
#include "procedural/color/srgb.h"
#include "procedural/model/texture_json.h"

namespace burl {

namespace {

/// Shares of a range at which shaders are sampled, after a first one. At the ends, and at round
/// numbers, a shader may be simpler than elsewhere.
constexpr std::array shares{0.0314, 0.1773, 0.2929, 0.5303, 0.7071, 0.8861, 0.9763};

/// The first share, which no two controls have: where both have one value, a shader may be simpler.
double first_share(std::size_t number) {
    return 0.35 +
           0.15 * (0.6180339887 * double(number) - std::floor(0.6180339887 * double(number)));
}

/// The value at a share of a range; of a range over decades by its logarithm.
double at_share(double low, double high, double share) {
    if (low > 0.0 && high > 8.0 * low) return low * std::pow(high / low, share);
    return low + share * (high - low);
}

std::vector<double> samples_of(double low, double high, bool whole, double first) {
    std::vector<double> samples;
    const auto add = [&](double share) {
        const double value = at_share(low, high, share);
        const double sample =
            whole ? std::clamp(std::round(value), std::ceil(low), std::floor(high)) : value;
        if (std::ranges::find(samples, sample) == samples.end()) samples.push_back(sample);
    };
    add(first);
    for (const double share : shares) add(share);
    return samples;
}

/// The expression, rounded to a whole number.
std::string rounded(const std::string& name) {
    return fmt::format("floor({} + 0.5)", name);
}

bool is_whole(const RecipePlace& place) {
    return place.parameter && place.parameter->type == ParameterType::integer;
}

/// The variable of a formula; without a name where GLSL has no equal.
KnobVariable formula_variable(const std::string& formula, const std::string& x, bool whole) {
    const std::string text = formula_glsl(formula, x);
    if (text.empty()) return {};
    const auto value = [formula](double number) { return formula_value(formula, number); };
    if (!whole) return {"(" + text + ")", value};
    return {rounded(text), [value](double number) { return std::round(value(number)); }};
}

double code_light(double code) {
    return srgb_decode(code / 255.0);
}

/// The control's name as the end of an identifier.
std::string identifier(std::string_view name) {
    std::string result = "knob";
    bool gap = true;
    for (const char c : name) {
        const char small = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
        const bool fits = (small >= 'a' && small <= 'z') || (small >= '0' && small <= '9');
        if (fits && gap) result += '_';
        if (fits) result += small;
        gap = !fits;
    }
    return result;
}

}  // namespace

std::vector<KnobDial> Knob::color_dials(std::size_t number) const {
    const Rgb8 color = color_from_hex(state_.value.get<std::string>());
    std::vector<KnobDial> dials;
    for (std::size_t c = 0; c < 3; ++c) {
        KnobDial dial{number, double(c == 0 ? color.r : c == 1 ? color.g : color.b)};
        // Codes that no two components of a control share, nor of the controls beside it.
        for (std::size_t k = 0; k < 4; ++k)
            dial.samples.push_back(double(20 + (37 * (3 * number + c) + 61 * k) % 211));
        dial.nudge = 7.0;
        dial.variables.push_back({fmt::format("{}.{}", uniform_, "rgb"[c]), code_light});
        dials.push_back(std::move(dial));
    }
    return dials;
}

std::vector<KnobDial> Knob::dials(std::size_t number, const Json& recipe) const {
    if (is_color()) return color_dials(number);
    const auto [low, high] = *state_.control.range;
    KnobDial dial{number, state_.value.get<double>(),
                  samples_of(low, high, state_.whole, first_share(number))};
    dial.nudge = state_.whole ? 0.0 : 1e-3 * dial.samples[0];
    const std::string x = state_.whole ? rounded(uniform_) : uniform_;
    dial.variables.push_back({x, [](double value) { return value; }});
    const std::vector<RecipePlace> places = recipe_places(recipe);
    for (const std::string& entry : state_.control.sets) {
        const auto [path, formula] = control_target(entry);
        if (formula.empty()) continue;
        KnobVariable one = formula_variable(formula, x, is_whole(*find_place(places, path)));
        if (!one.name.empty()) dial.variables.push_back(std::move(one));
    }
    return {dial};
}

std::string Knob::setting(std::span<const double> dials) const {
    if (!is_color()) return fmt::format("{}={}", name(), dials[0]);
    const auto code = [&](std::size_t c) { return unsigned(std::lround(dials[c])); };
    const std::string alpha =
        state_.value.get<std::string>().substr(std::min<std::size_t>(7, value().size()));
    return fmt::format("{}=#{:02x}{:02x}{:02x}{}", name(), code(0), code(1), code(2), alpha);
}

std::string Knob::value() const {
    return is_color() ? state_.value.get<std::string>()
                      : fmt::format("{}", state_.value.get<double>());
}

std::string Knob::definition() const {
    std::string comment = in_glsl_comment(name()), type = "float", initial;
    if (is_color()) {
        const Rgb8 color = color_from_hex(value());
        type = "vec3";
        initial =
            fmt::format("vec3({}, {}, {})", shader_number(code_light(color.r)),
                        shader_number(code_light(color.g)), shader_number(code_light(color.b)));
        comment += fmt::format(", a colour in linear light, {} in sRGB", value());
    } else {
        const auto [low, high] = *state_.control.range;
        initial = shader_number(state_.value.get<double>());
        comment +=
            fmt::format(", {}from {} to {}", state_.whole ? "a whole number " : "", low, high);
    }
    if (!state_.control.about.empty()) comment += ": " + in_glsl_comment(state_.control.about);
    return fmt::format("// {}\nuniform {} {} = {};\n", comment, type, uniform_, initial);
}

std::string Knob::left_behind(const Json& recipe) const {
    const std::vector<RecipePlace> places = recipe_places(recipe);
    for (const std::string& entry : state_.control.sets) {
        const auto [path, formula] = control_target(entry);
        const RecipePlace& place = *find_place(places, path);
        if (is_color()) {
            if (place.value != state_.value) return path;
            continue;
        }
        const double x = state_.value.get<double>(), is = place.value.get<double>();
        const double exact = formula.empty() ? x : formula_value(formula, x);
        const double wanted = is_whole(place) ? std::round(exact) : exact;
        if (!(std::abs(is - wanted) <= 1e-6 * std::max(std::abs(is), std::abs(wanted))))
            return path;
    }
    return "";
}

std::vector<Knob> knobs_of(const Json& recipe) {
    std::vector<Knob> knobs;
    std::vector<std::string> taken;
    for (ControlState& state : control_states(recipe)) {
        const std::string name = identifier(state.control.name);
        std::string uniform = name;
        for (int i = 2; std::ranges::find(taken, uniform) != taken.end(); ++i)
            uniform = fmt::format("{}_{}", name, i);
        taken.push_back(uniform);
        knobs.emplace_back(std::move(state), uniform);
    }
    return knobs;
}

std::string in_glsl_comment(std::string text) {
    for (char& c : text)
        if (c < ' ' || c > '~' || c == '\\') c = '?';
    return text;
}

}  // namespace burl
