#include "app/options/light.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/messages.h"
#include "app/light/environment.h"
#include "app/options/command_options.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"

namespace burl {

namespace {

constexpr const char* usual_light = "studio";
constexpr const char* headlight_name = "headlight";
constexpr double most_stops = 20.0;

bool is_light_file(const std::string& light) {
    const std::string extension = lower_extension(light);
    return extension == ".exr" || extension == ".hdr";
}

/// Throws Error(usage) for a light that is neither a name nor the path of a picture.
void check_light(const std::string& light) {
    const std::vector<std::string> names = light_names();
    if (is_light_file(light) || std::ranges::find(names, light) != names.end()) return;
    const std::string_view nearest = nearest_word(light, names);
    const std::string hint = nearest.empty() ? "" : fmt::format("did you mean {}? ", nearest);
    throw Error(ExitCode::usage,
                fmt::format("--light {}: {}it must be {}, or a picture of all directions, .exr or "
                            ".hdr",
                            light, hint, fmt::join(names, ", ")));
}

/// The colour of six hexadecimal digits, with or without "#" before them.
std::optional<Rgb8> color_of(std::string_view text) {
    if (text.starts_with('#')) text.remove_prefix(1);
    std::uint32_t code = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), code, 16);
    if (text.size() != 6 || failure != std::errc() || end != text.data() + text.size()) return {};
    return Rgb8{std::uint8_t(code >> 16), std::uint8_t(code >> 8), std::uint8_t(code)};
}

}  // namespace

std::vector<std::string> light_names() {
    std::vector<std::string> names{headlight_name};
    for (const EnvironmentNote& note : environment_notes()) names.emplace_back(note.name);
    return names;
}

void LightArguments::add(CLI::App& verb) {
    verb.add_option("--light", light,
                    fmt::format("What lights the object: {}, or a picture of all directions (.exr, "
                                ".hdr) (default {})",
                                fmt::join(light_names(), ", "), usual_light));
    verb.add_option("--turn-light", turn, "Degrees by which the light is turned about the vertical")
        ->check(in_range(-360.0, 360.0));
    verb.add_option("--exposure", exposure, "Stops by which the light is brighter (default 0)")
        ->check(in_range(-most_stops, most_stops));
    verb.add_option("--tone", tone,
                    "Tone curve: neutral, which keeps what is brighter than white, or none "
                    "(default neutral)")
        ->check(one_of({"neutral", "none"}));
    verb.add_option("--background", background,
                    "What lies behind: RRGGBB, transparent, or light, the environment (default "
                    "b0b0b0)");
    verb.add_flag("--ground", ground, "Let the object throw a shadow on the ground below it");
}

LightOptions LightArguments::light_options() const {
    LightOptions options;
    options.light = light.value_or(usual_light);
    check_light(options.light);
    const auto refuse = [&](bool given, const char* option, const char* why) {
        if (given && options.is_headlight())
            throw Error(ExitCode::usage,
                        fmt::format("{} {}; leave it out, or name another --light", option, why));
    };
    refuse(turn.has_value(), "--turn-light", "does nothing: the headlight follows the eye");
    refuse(tone.has_value(), "--tone", "does nothing: the headlight is never brighter than white");
    refuse(background == "light", "--background light",
           "shows nothing: the headlight has no place");
    options.turn = turn.value_or(0.0);
    options.exposure = exposure.value_or(0.0);
    options.tone_curve = tone.value_or("neutral") == "neutral";
    return options;
}

Background LightArguments::background_asked() const {
    if (!background) return {};
    if (*background == "transparent") return {Background::Kind::transparent, {}};
    if (*background == "light") return {Background::Kind::light, {}};
    if (const auto color = color_of(*background)) return {Background::Kind::color, *color};
    throw Error(ExitCode::usage,
                fmt::format("--background {}: it must be six hexadecimal digits RRGGBB, as b0b0b0, "
                            "or transparent or light",
                            *background));
}

std::vector<std::string> LightArguments::files() const {
    if (!light || !is_light_file(*light)) return {};
    return {*light};
}

std::string LightArguments::given() const {
    if (light) return "--light";
    if (turn) return "--turn-light";
    if (exposure) return "--exposure";
    if (tone) return "--tone";
    if (background == "light") return "--background light";
    return ground ? "--ground" : "";
}

}  // namespace burl
