#include "app/options/command_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/messages.h"
#include "app/base/progress.h"
#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/parameters.h"
#include "app/recipe/spelling.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

/// The words as a sentence has them: "a, b or c".
std::string alternatives(std::span<const std::string_view> words) {
    if (words.size() < 2) return fmt::format("{}", fmt::join(words, ""));
    return fmt::format("{} or {}", fmt::join(words.first(words.size() - 1), ", "), words.back());
}

/// The long name of an option: "--size" for "-s,--size".
std::string_view long_name(std::string_view option) {
    return option.substr(option.rfind("--"));
}

/// Adds the edits of --filter, KIND or supersample:N. Throws Error(usage) where another kind has a
/// number of samples.
void append_filter(const std::string& text, std::vector<RecipeEdit>& edits) {
    const std::size_t colon = text.find(':');
    const std::string option = "--filter " + text;
    edits.push_back({option, "filter.kind", text.substr(0, colon)});
    if (colon == std::string::npos) return;
    if (!text.starts_with("supersample:"))
        throw Error(ExitCode::usage,
                    fmt::format("{}: only supersample takes a number of samples", option));
    edits.push_back({option, "filter.samples", text.substr(colon + 1)});
}

/// Adds the edits of --size, N or WxH.
void append_size(const std::string& text, std::vector<RecipeEdit>& edits) {
    const std::string option = "--size " + text;
    const std::size_t by = text.find('x');
    std::uint32_t width = 0, height = 0;
    const char *const begin = text.data(), *const end = begin + text.size();
    const bool pair =
        by != std::string::npos && std::from_chars(begin, end, width).ptr == begin + by &&
        std::from_chars(begin + by + 1, end, height).ptr == end && width > 0 && height > 0;
    edits.push_back({option, "atlas.size", pair ? std::to_string(std::max(width, height)) : text});
    if (!pair || width == height) return;
    edits.push_back({option, width > height ? "atlas.height" : "atlas.width",
                     std::to_string(std::min(width, height))});
}

void append_precision(const std::string& text, std::vector<RecipeEdit>& edits) {
    const FixedFormat format = parse_precision(text).format;
    const std::string option = "--precision " + text;
    edits.push_back({option, "precision.kind", text.substr(0, text.find(':'))});
    if (!text.starts_with("fixed")) return;
    edits.push_back({option, "precision.integer_bits", std::to_string(format.integer_bits)});
    edits.push_back({option, "precision.fraction_bits", std::to_string(format.fraction_bits)});
}

/// Throws Error(usage) where two edits set one number, since the first would have no effect.
void check_said_once(const std::vector<RecipeEdit>& edits) {
    for (std::size_t i = 0; i < edits.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (respelled_path(edits[i].path) == respelled_path(edits[k].path))
                throw Error(ExitCode::usage,
                            fmt::format("{} and {} say the same thing; give one of them",
                                        edits[i].said, edits[k].said));
}

/// Throws Error(usage) for an edit of a number that the recipe's keys move, since it would have no
/// effect.
void check_not_keyed(const std::vector<RecipeEdit>& edits, const KeyedAnimation& animation) {
    for (const KeyTrack& track : animation.tracks)
        for (const RecipeEdit& edit : edits)
            if (respelled_path(edit.path) == track.path)
                throw Error(ExitCode::usage,
                            fmt::format("{} does nothing: the recipe has keys for that number; "
                                        "leave it out, or change its \"animation\"",
                                        edit.said));
}

/// The error of load_recipe(), with the option that the user gave in place of --set.
Error with_option(const Error& error, const std::vector<RecipeEdit>& edits) {
    const std::string sentence = error.what();
    for (const RecipeEdit& edit : edits) {
        const std::string front = fmt::format("--set {}: ", edit.setting());
        if (sentence.starts_with(front))
            return Error(error.code(),
                         fmt::format("{}: {}", edit.said, sentence.substr(front.size())));
    }
    return error;
}

/// The word of --no-skip that stands for all skip_names.
constexpr const char* all_skips = "all";

constexpr double megabyte = 1024.0 * 1024.0, usual_megabytes = 1024.0, most_megabytes = 1 << 20;

}  // namespace

void RecipeOptions::add_recipe(CLI::App& verb) {
    verb.add_option("-r,--recipe", recipe,
                    "Name of a preset or material, or recipe file (.json, .mtlx)")
        ->capture_default_str();
    add_settings(verb);
}

void RecipeOptions::add_settings(CLI::App& verb) {
    verb.add_option("--set", settings,
                    "Edit of the recipe, PATH=VALUE or CONTROL=VALUE; may be repeated")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    verb.add_option("--time", time, "Of a recipe with keys: its state after so many seconds")
        ->check(in_range(0.0, 3600.0));
}

void RecipeOptions::add_parameters(CLI::App& verb) {
    for (const RecipeParameter& parameter : burl::parameters())
        if (!parameter.use.option.empty()) parameters.push_back({&parameter});
    // In --help the texture's size comes after all that says how it is laid out.
    std::ranges::stable_partition(parameters, [](const ParameterOption& option) {
        return option.parameter->path != "atlas.size";
    });
    for (auto& [parameter, value] : parameters)
        verb.add_option(std::string(parameter->use.option), value,
                        fmt::format(fmt::runtime(parameter->use.help),
                                    alternatives(split_choices(parameter->choices))));
}

void RecipeOptions::add_filter(CLI::App& verb) {
    verb.add_option("--filter", filter,
                    fmt::format("Texel filter: {}:N", alternatives(enum_names<FilterKind>)));
}

void RecipeOptions::add_precision(CLI::App& verb, const std::string& otherwise) {
    verb.add_option("--precision", precision,
                    fmt::format("Arithmetic of the texture: float32, float64, or fixed:I.F, "
                                "integers with I bits before the point and F after it; left out: "
                                "the recipe's, or else {}",
                                otherwise));
}

std::optional<std::string> RecipeOptions::given(std::string_view path) const {
    for (const auto& [parameter, value] : parameters)
        if (parameter->path == path) return value;
    return {};
}

std::vector<RecipeEdit> RecipeOptions::edits() const {
    std::vector<RecipeEdit> edits;
    for (const std::string& setting : settings) {
        const std::size_t equals = std::min(setting.find('='), setting.size());
        edits.push_back({"--set " + setting, setting.substr(0, equals),
                         setting.substr(std::min(equals + 1, setting.size()))});
    }
    for (const auto& [parameter, value] : parameters)
        if (value && parameter->path == "atlas.size")
            append_size(*value, edits);
        else if (value)
            edits.push_back({fmt::format("{} {}", long_name(parameter->use.option), *value),
                             std::string(parameter->path), *value});
    if (filter) append_filter(*filter, edits);
    if (precision) append_precision(*precision, edits);
    return edits;
}

Recipe RecipeOptions::load_keyed() const {
    const std::vector<RecipeEdit> all = edits();
    check_said_once(all);
    std::vector<std::string> texts = settings;
    for (std::size_t i = settings.size(); i < all.size(); ++i) texts.push_back(all[i].setting());
    try {
        Recipe keyed = load_recipe(recipe, texts, *images);
        check_not_keyed(all, keyed.animation);
        return keyed;
    } catch (const Error& error) {
        throw with_option(error, all);
    }
}

Recipe RecipeOptions::load() const {
    const Recipe keyed = load_keyed();
    if (time && keyed.animation.tracks.empty())
        throw Error(
            ExitCode::usage,
            fmt::format("--time: the recipe {} has no keys over time; leave it out", recipe));
    return recipe_at(keyed, time.value_or(0.0));
}

Precision parse_precision(const std::string& text) {
    const auto kind = enum_named<PrecisionKind>(text);
    if (kind && *kind != PrecisionKind::fixed) return {kind, {}};
    Precision precision{PrecisionKind::fixed, {}};
    auto& [integer, fraction] = precision.format;
    const std::string_view begin = "fixed:";
    const char *const first = text.data() + std::min(begin.size(), text.size()), *const last =
                                                                                     text.data() +
                                                                                     text.size();
    const auto before = std::from_chars(first, last, integer);
    const bool dot = before.ec == std::errc() && before.ptr != last && *before.ptr == '.';
    const auto after = std::from_chars(dot ? before.ptr + 1 : last, last, fraction);
    if (!text.starts_with(begin) || !dot || after.ec != std::errc() || after.ptr != last ||
        integer < 1 || integer > 16 || fraction < 2 || fraction > 16)
        throw Error(ExitCode::usage,
                    fmt::format("--precision {}: must be float32, float64, or fixed:I.F with 1 to "
                                "16 bits before the point and 2 to 16 after it, as fixed:8.8",
                                text));
    return precision;
}

void add_pose(CLI::App& verb, std::string& pose) {
    verb.add_option("--pose", pose,
                    "Another shape of the mesh, to which its texture sticks: a mesh file with the "
                    "same faces, or a pose of the mesh's own file: a morph target, a moment of an "
                    "animation (NAME@SECONDS) or \"nodes\"; pose.weight says how far");
}

std::vector<std::string> option_names(const CLI::App& verb) {
    std::vector<std::string> names;
    for (const CLI::Option* option : verb.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& words) {
    const std::string_view nearest = nearest_word(word, words);
    return nearest.empty() ? "" : fmt::format("did you mean {}? ", nearest);
}

CLI::Validator in_range(double low, double high) {
    const std::string bounds = fmt::format("{:.3g} to {:.3g}", low, high);
    return {[=](std::string& text) {
                double value = 0.0;
                const bool fits =
                    CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
                return fits ? "" : fmt::format("{} is not a number from {}", text, bounds);
            },
            bounds};
}

CLI::Validator one_of(const std::vector<std::string>& words) {
    return {[=](std::string& text) -> std::string {
                if (std::ranges::find(words, text) != words.end()) return "";
                const std::string_view nearest = nearest_word(text, words);
                return fmt::format(
                    "{} is none of {}{}", text, fmt::join(words, ", "),
                    nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest));
            },
            CLI::IsMember(words).get_description()};
}

void add_threads(CLI::App& verb, int& threads) {
    verb.add_option("-j,--threads", threads,
                    "Threads to use, 0 for all; the result never depends on it")
        ->check(CLI::Range(0, 1024));
}

void add_progress(CLI::App& verb, std::string& mode) {
    verb.add_option("--progress", mode,
                    "What is told on stderr of long work: line (one line, drawn anew), plain (a "
                    "line every ten seconds), json (for programs), none, or auto: line on a "
                    "terminal, else plain")
        ->check(one_of({progress_modes.begin(), progress_modes.end()}))
        ->capture_default_str();
}

void EconomyOptions::add_skips(CLI::App& verb) {
    std::vector<std::string> words(skip_names.begin(), skip_names.end());
    words.emplace_back(all_skips);
    verb.add_option("--no-skip", forbidden,
                    "Do work that is otherwise left out, by its name, or all; may be repeated. "
                    "The result is the same")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->check(one_of(words));
}

void EconomyOptions::add_cache(CLI::App& verb) {
    verb.add_option("--cache", cache_megabytes,
                    "Memory for what one texture leaves to the next, in MB (1024 for --frames, "
                    "else 0)")
        ->check(in_range(0.0, most_megabytes));
}

Skips EconomyOptions::skips() const {
    Skips skips;
    for (std::size_t k = 0; k < skip_names.size(); ++k)
        if (std::ranges::any_of(forbidden, [&](const std::string& word) {
                return word == skip_names[k] || word == all_skips;
            }))
            skips.forbid(Skip(k));
    return skips;
}

std::size_t EconomyOptions::cache_bytes(bool several) const {
    return std::size_t(cache_megabytes.value_or(several ? usual_megabytes : 0.0) * megabyte);
}

}  // namespace burl
