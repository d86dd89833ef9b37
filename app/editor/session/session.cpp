#include "app/editor/session/session.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/base/atomic_file.h"
#include "app/edit/steps.h"
#include "app/options/idle_options.h"
#include "app/recipe/edit/images.h"
#include "app/recipe/edit/key_check.h"
#include "app/recipe/edit/key_edit.h"
#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/edit/leaves.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

constexpr std::size_t log_capacity = 1000;

class Differences {
  public:
    RecipeSettings found;

    void compare(const Json& base, const Json& value, const std::string& path) {
        if (base == value) return;
        if (base.is_object() && value.is_object()) {
            if (base.contains("node") && base["node"] != value.value("node", "")) {
                found.possible = false;
                return;
            }
            return compare_objects(base, value, path);
        }
        const bool items = base.is_array() && value.is_array() && base.size() == value.size() &&
                           !value.empty() && value[0].is_object();
        if (!items) {
            found.settings.push_back(fmt::format("{}={}", path, value.dump()));
            return;
        }
        for (std::size_t i = 0; i < value.size(); ++i)
            compare(base[i], value[i], fmt::format("{}.{}", path, i));
    }

  private:
    void compare_objects(const Json& base, const Json& value, const std::string& path) {
        for (const auto& [key, old] : base.items())
            if (!value.contains(key)) found.possible = false;
        for (const auto& [key, now] : value.items()) {
            const std::string below = path.empty() ? key : fmt::format("{}.{}", path, key);
            compare(base.contains(key) ? base[key] : Json(), now, below);
        }
    }
};

/// Longest list of settings on a command line, in characters; strokes of paint are longer.
constexpr std::size_t long_settings = 4000;

std::size_t length_of(const std::vector<std::string>& settings) {
    std::size_t length = 0;
    for (const std::string& setting : settings) length += setting.size();
    return length;
}

/// Whether a setting has no effect on the recipe, which `burl bake` would refuse.
bool is_idle(const std::string& path, const Recipe& recipe, const std::string& pose) {
    return !idle_reason(recipe, path).empty() || (pose.empty() && path.starts_with(idle_pose.key));
}

/// Quotes a word for a shell, in single quotes where it needs them.
std::string quoted(const std::string& word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./:=,@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

/// Whether the recipe has images and the settings change none of them.
bool keeps_images(const Recipe& recipe, const std::vector<std::string>& settings) {
    const auto other = [](const std::string& setting) {
        const std::size_t end = setting.find('=');
        const std::string path = setting.substr(0, end);
        return path.ends_with(".file") || path.ends_with(".wrap") ||
               setting.substr(end + 1).starts_with('{');
    };
    const bool any = !recipe.texture.images.empty() || !recipe.bump.input.images.empty();
    return any && std::ranges::none_of(settings, other);
}

/// Applies settings to a recipe. Unchanged images are not read again, and unchanged strokes of
/// paint bypass JSON, which would take longer than a frame.
Recipe with_settings(Recipe recipe, const std::string& origin,
                     const std::vector<std::string>& settings) {
    std::vector<PaintStroke> paint;
    const auto paints = [](const std::string& setting) { return setting.starts_with("paint"); };
    const bool apart = std::ranges::none_of(settings, paints);
    if (apart && keeps_images(recipe, settings)) return with_numbers(recipe, settings);
    if (apart) paint.swap(recipe.paint);
    Recipe result = parse_recipe(to_json(recipe), origin, settings);
    if (apart) result.paint = std::move(paint);
    return result;
}

}  // namespace

EditSession::EditSession(Recipe recipe, const std::string& recipe_path)
    : history_(std::move(recipe), recipe_path) {}

void EditSession::add(LogLine line) {
    if (line.problem) problem_ = line.text;
    log_.push_back(std::move(line));
    if (log_.size() > log_capacity) log_.pop_front();
}

bool EditSession::step(const std::function<Recipe()>& load) {
    try {
        history_.change(load());
        return true;
    } catch (const Error& error) {
        complain(error.what());
        return false;
    }
}

bool EditSession::set(const std::string& path, const Json& value) {
    return set(std::vector{fmt::format("{}={}", path, value.dump())});
}

bool EditSession::set(const std::vector<std::string>& settings) {
    return step([&] {
        return with_still(recipe(), time_, with_settings(still(), recipe_path(), settings));
    });
}

bool EditSession::change_still(const Recipe& still) {
    return step([&] { return with_still(recipe(), time_, still); });
}

bool EditSession::change_keys(KeyedAnimation animation) {
    Recipe changed = recipe();
    changed.animation = std::move(animation);
    return step([&] { return std::move(changed); });
}

std::optional<std::string> EditSession::build(const std::function<GraphEdit(const Recipe&)>& edit) {
    history_.end_gesture();
    try {
        GraphEdit done = edit(recipe());
        for (const std::string& sentence : done.lost) tell(sentence);
        history_.change(std::move(done.recipe), std::move(done.words));
        return std::move(done.path);
    } catch (const Error& error) {
        complain(error.what());
        return {};
    }
}

void EditSession::open_new() {
    history_.open_unsaved(new_recipe(recipe()));
    time_ = 0.0;
    tell("new recipe");
}

const Recipe& EditSession::still() {
    if (recipe().animation.tracks.empty()) return recipe();
    if (still_ && still_->time == time_ && still_->of == recipe()) return still_->recipe;
    Still now{recipe(), time_, recipe(), false};
    now.recipe.animation = {};
    try {
        now.recipe = recipe_at(recipe(), time_);
    } catch (const Error& error) {
        now.fails = true;
        if (!still_ || !still_->fails) complain(error.what());  // logged once, not in every frame
    }
    still_ = std::move(now);
    return still_->recipe;
}

void EditSession::touch(std::string path) {
    touched_ = std::move(path);
    touched_revision_.reset();
}

const std::string& EditSession::touched() {
    if (touched_.empty() || touched_revision_ == history_.revision()) return touched_;
    touched_revision_ = history_.revision();
    if (!find_number(slider_json(still()), touched_)) touched_.clear();
    return touched_;
}

bool EditSession::open_recipe(const std::string& path) {
    try {
        take_recipe(load_recipe(path), path);
        return true;
    } catch (const Error& error) {
        complain(error.what());
        return false;
    }
}

void EditSession::take_recipe(Recipe recipe, const std::string& path) {
    history_.open(std::move(recipe), path);
    time_ = 0.0;
    tell(fmt::format("recipe {}", path));
}

bool EditSession::paste_recipe(const std::string& json) {
    history_.end_gesture();
    return step([&] { return parse_recipe(json, "the clipboard"); });
}

bool EditSession::recover_recipe(const std::string& json, const std::string& origin) {
    try {
        history_.open_unsaved(parse_recipe(json, origin));
        return true;
    } catch (const Error& error) {
        complain(error.what());
        return false;
    }
}

void EditSession::save_recipe(const std::string& path) {
    write_file(path, to_json(with_images_for(recipe(), recipe_path(), path)));
    history_.mark_saved(path);
    tell(fmt::format("saved {}", path));
}

RecipeSettings settings_between(const Recipe& base, const Recipe& recipe) {
    Differences differences;
    differences.compare(Json::parse(to_json(base)), Json::parse(to_json(recipe)), "");
    if (!differences.found.possible) differences.found.settings.clear();
    return std::move(differences.found);
}

std::string bake_command(const std::string& mesh, const std::string& base_path, const Recipe& base,
                         const Recipe& recipe, std::vector<std::string> output,
                         const std::string& pose) {
    const std::string name = recipe.name.empty() ? "texture" : recipe.name;
    if (output.empty()) output = {"-o", name + ".glb"};
    std::vector<std::string> words{"burl", "bake", mesh};
    words.insert(words.end(), output.begin(), output.end());
    if (!pose.empty()) words.insert(words.end(), {"--pose", pose});
    words.emplace_back("--recipe");
    RecipeSettings between = settings_between(base, recipe);
    std::erase_if(between.settings, [&](const std::string& setting) {
        return is_idle(setting.substr(0, setting.find('=')), recipe, pose);
    });
    if (length_of(between.settings) > long_settings) between = {false, {}};
    words.push_back(between.possible ? base_path : name + ".json");
    for (const std::string& setting : between.settings) {
        words.emplace_back("--set");
        words.push_back(setting);
    }
    std::ranges::transform(words, words.begin(), quoted);
    return fmt::format("{}", fmt::join(words, " "));
}

ClockStep clock_after(const KeyedAnimation& animation, double seconds, double dt) {
    const double then = seconds + dt;
    if (then < animation.seconds) return {then, false};
    if (animation.loop) return {std::fmod(then, animation.seconds), false};
    return {animation.seconds, true};
}

void toggle_playing(EditSession& session) {
    const KeyedAnimation& animation = session.recipe().animation;
    session.timeline.playing = !session.timeline.playing;
    if (!session.timeline.playing)
        session.set_time(nearest_frame(animation, session.time()));
    else if (!animation.loop && session.time() >= animation.seconds)
        session.set_time(0.0);
}

void advance(EditSession& session, double dt) {
    const KeyedAnimation& animation = session.recipe().animation;
    if (session.time() > animation.seconds) session.set_time(animation.seconds);
    if (!session.timeline.playing) return;
    const ClockStep step = clock_after(animation, session.time(), dt);
    session.set_time(step.seconds);
    if (step.ended) session.timeline.playing = false;
}

}  // namespace burl
