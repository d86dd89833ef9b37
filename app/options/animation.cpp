#include "app/options/animation.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/parameters.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

bool parse_number(std::string_view text, double& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
}

/// The parameter with several numbers of which the path names one; null for any other path.
const Parameter* parameter_with_item(std::string_view path) {
    const std::size_t dot = path.rfind('.');
    if (dot == std::string_view::npos) return nullptr;
    const Parameter* parameter = find_parameter(path.substr(0, dot));
    return parameter && parameter->type == ParameterType::numbers ? parameter : nullptr;
}

/// Throws Error(usage) for a path that is no number outside the atlas; a path that the parameter
/// table does not have is left to load_recipe.
void check_path(NumberMove& key) {
    const std::string& text = key.said;
    if (key.path.starts_with("camera."))
        throw Error(
            ExitCode::usage,
            fmt::format("--animate {}: only pictures have a camera; `burl render` moves it", text));
    if (key.path.starts_with("atlas."))
        throw Error(ExitCode::usage,
                    fmt::format("--animate {}: all frames share one atlas, so nothing of it can "
                                "change over time",
                                text));
    if (parameter_with_item(key.path)) return;
    const Parameter* parameter = find_parameter(key.path);
    if (!parameter) return;  // which is for load_recipe to say
    if (parameter->type == ParameterType::numbers)
        throw Error(ExitCode::usage,
                    fmt::format("--animate {}: {} is {} numbers; animate one of them, such as "
                                "{}.0=FROM:TO",
                                text, key.path, parameter->count, key.path));
    key.whole = parameter->type == ParameterType::integer;
    if (key.whole || parameter->type == ParameterType::number) return;
    throw Error(ExitCode::usage, fmt::format("--animate {}: {} is a {}, only numbers can be "
                                             "animated (`burl list parameters`)",
                                             text, key.path, to_string(parameter->type)));
}

/// Parses "PATH=FROM:TO" of a recipe's number. Throws Error(usage) as parse_move and check_path do.
NumberMove parse_key(const std::string& text) {
    NumberMove key = parse_move(text);
    check_path(key);
    return key;
}

/// The parsed --animate options of a recipe. Throws Error(usage) for a number that is set or moved
/// twice.
std::vector<NumberMove> parse_keys(const MovedRecipe& moved, const KeyedAnimation& own) {
    const std::vector<RecipeEdit> edits = moved.options.edits();
    std::vector<NumberMove> keys;
    for (const std::string& text : moved.keys) {
        const NumberMove key = parse_key(text);
        for (const RecipeEdit& edit : edits)
            if (edit.path == key.path)
                throw Error(ExitCode::usage,
                            fmt::format("{} does nothing: --animate {} says {} in every frame; "
                                        "leave one of them out",
                                        edit.said, text, key.path));
        for (const NumberMove& other : keys)
            if (other.path == key.path)
                throw Error(ExitCode::usage, fmt::format("--animate: {} is given twice", key.path));
        for (const KeyTrack& track : own.tracks)
            if (track.path == key.path)
                throw Error(ExitCode::usage,
                            fmt::format("--animate {}: the recipe has keys for that number; leave "
                                        "--animate out, or its \"animation\"",
                                        text));
        keys.push_back(key);
    }
    return keys;
}

/// A recipe with the numbers that --animate moves.
struct Track {
    const RecipeOptions& options;
    std::vector<NumberMove> keys;
};

/// The track's recipe at frame `frame` of n, `seconds` after the first frame. An error of
/// load_keyed() that begins with --set is thrown with --animate and the frame instead.
Recipe recipe_in_frame(const Track& track, double seconds, int frame, int n, bool loop) {
    RecipeOptions options = track.options;
    for (const NumberMove& key : track.keys)
        options.settings.push_back(fmt::format("{}={}", key.path, value_at(key, frame, n, loop)));
    try {
        return recipe_at(options.load_keyed(), seconds);
    } catch (const Error& error) {
        std::string sentence = error.what();
        constexpr std::string_view set = "--set";
        if (!sentence.starts_with(set)) throw;
        sentence.replace(0, set.size(), "--animate");
        throw Error(error.code(), fmt::format("{} (frame {})", sentence, frame + 1));
    }
}

/// Whether any of the recipes has keys, and the --time of all.
struct KeysAndTime {
    bool keyed = false;
    std::optional<double> time{};
};

/// Throws Error(usage) for a --time where no recipe has keys.
void check_time(const KeysAndTime& found) {
    if (found.time && !found.keyed)
        throw Error(ExitCode::usage,
                    "--time: no recipe of the picture has keys over time; leave it out");
}

/// The recipes of a single picture, at the times of --time.
std::vector<Recipe> still_recipes(std::span<const MovedRecipe> recipes) {
    std::vector<Recipe> result;
    KeysAndTime found;
    for (const MovedRecipe& moved : recipes) {
        const Recipe recipe = moved.options.load_keyed();
        found.keyed |= !recipe.animation.tracks.empty();
        if (moved.options.time) found.time = moved.options.time;
        result.push_back(recipe_at(recipe, moved.options.time.value_or(0.0)));
    }
    check_time(found);
    return result;
}

/// The --time at which recipes stand still in all frames; none: their keys run. Throws Error(usage)
/// where nothing else moves.
std::optional<double> time_held(std::span<const MovedRecipe> recipes,
                                const AnimationOptions& animation) {
    KeysAndTime found;
    for (const MovedRecipe& moved : recipes)
        if (moved.options.time) found.time = moved.options.time;
    if (!found.time) return {};
    if (!animation.recipes_may_rest)
        throw Error(ExitCode::usage,
                    "--time is one moment and --frames runs through all of them; leave one of them "
                    "out");
    for (const MovedRecipe& moved : recipes)
        found.keyed |= !moved.options.load_keyed().animation.tracks.empty();
    check_time(found);
    return found.time;
}

}  // namespace

void AnimationOptions::add(CLI::App& verb) {
    auto* animate = verb.add_option("--animate", keys,
                                    "A number of the recipe over time, PATH=FROM:TO; may be "
                                    "repeated; writes OUT.0001.png, OUT.0002.png, ...");
    animate->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    auto* count = verb.add_option("--frames", frames,
                                  "Frames of the animation: of the recipe's keys, of --animate, or "
                                  "of both");
    count->check(CLI::Range(2, most_frames));
    animate->needs(count);
    verb.add_flag("--loop", loop, "The frame after the last one is the first: TO is never reached")
        ->needs(count);
}

NumberMove parse_move(const std::string& text) {
    const std::size_t equals = text.find('='), colon = text.find(':', equals);
    if (equals == std::string::npos || equals == 0 || colon == std::string::npos)
        throw Error(ExitCode::usage,
                    fmt::format("--animate: \"{}\" must have the form PATH=FROM:TO", text));
    NumberMove move{text, text.substr(0, equals)};
    const std::string_view values = text;
    const std::string_view from = values.substr(equals + 1, colon - equals - 1);
    const std::string_view to = values.substr(colon + 1);
    if (!parse_number(from, move.from) || !parse_number(to, move.to))
        throw Error(ExitCode::usage,
                    fmt::format("--animate {}: FROM and TO must be numbers, but they are \"{}\" "
                                "and \"{}\"",
                                text, from, to));
    return move;
}

double value_at(const NumberMove& move, int i, int n, bool loop) {
    const double t = double(i) / double(loop ? n : n - 1);
    const double value = (1.0 - t) * move.from + t * move.to;
    return move.whole ? std::round(value) : value;
}

std::vector<std::vector<Recipe>> frame_recipes(std::span<const MovedRecipe> recipes,
                                               const AnimationOptions& animation) {
    if (!animation.asked()) return {still_recipes(recipes)};
    const std::optional<double> held = time_held(recipes, animation);
    std::vector<Track> tracks;
    KeyedAnimation clock;
    bool moves = animation.recipes_may_rest;
    for (const MovedRecipe& moved : recipes) {
        const KeyedAnimation own = moved.options.load_keyed().animation;
        tracks.push_back({moved.options, parse_keys(moved, own)});
        const bool longest = clock.tracks.empty() || own.seconds > clock.seconds;
        if (tracks.size() == 1 || (!own.tracks.empty() && longest)) clock = own;
        moves |= !own.tracks.empty() || !moved.keys.empty();
    }
    if (!moves)
        throw Error(ExitCode::usage,
                    "--frames: the recipe has no keys over time; say what changes with --animate "
                    "PATH=FROM:TO");
    clock.loop |= animation.loop;
    std::vector<std::vector<Recipe>> frames;
    for (int i = 0; i < animation.frames; ++i) {
        const double seconds = held.value_or(frame_seconds(clock, i, animation.frames));
        frames.emplace_back();
        for (const Track& track : tracks)
            frames.back().push_back(
                recipe_in_frame(track, seconds, i, animation.frames, clock.loop));
    }
    return frames;
}

std::vector<Recipe> frame_recipes(const RecipeOptions& options, const AnimationOptions& animation) {
    if (!animation.asked()) return {options.load()};
    const MovedRecipe only{options, animation.keys};
    std::vector<Recipe> recipes;
    for (std::vector<Recipe>& frame : frame_recipes({&only, 1}, animation))
        recipes.push_back(std::move(frame.front()));
    return recipes;
}

std::string frame_path(const std::string& out_path, std::size_t number) {
    std::filesystem::path path(out_path);
    return path.replace_extension(fmt::format(".{:04}{}", number, path.extension().string()))
        .string();
}

std::vector<std::string> frame_paths(const std::string& out_path,
                                     const AnimationOptions& animation) {
    if (!animation.asked()) return {out_path};
    std::vector<std::string> paths;
    for (std::size_t i = 1; i <= std::size_t(animation.frames); ++i)
        paths.push_back(frame_path(out_path, i));
    return paths;
}

}  // namespace burl
