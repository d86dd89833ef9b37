#pragma once
// What an editor holds besides its pictures: the recipe with its history, where it came from, and
// what there was to tell. It knows neither windows nor OpenGL.
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/base/json_text.h"
#include "app/editor/session/history.h"

namespace burl {

/// A line for the log panel.
struct LogLine {
    bool problem = false;
    std::string text;
};

class EditSession {
  public:
    /// `recipe_path`: a file or a preset's name, the origin of the images that it names.
    EditSession(Recipe recipe, const std::string& recipe_path);

    const EditHistory& history() const { return history_; }
    EditHistory& history() { return history_; }
    const Recipe& recipe() const { return history_.recipe(); }
    const std::string& recipe_path() const { return history_.path(); }

    /// Where the clock of a recipe with keys over time stands, in seconds; moving it is no edit.
    double time() const { return time_; }
    void set_time(double seconds) { time_ = seconds; }
    /// The recipe at that time, without keys: what is seen and what sliders show.
    const Recipe& still();

    /// One parameter of still(), by its path as --set takes it: a number that has keys gets one at
    /// the present time. A value that recipes refuse changes nothing, is logged, and gives false.
    bool set(const std::string& path, const Json& value);
    /// Several at once, "path=value"; all or none.
    bool set(const std::vector<std::string>& settings);
    /// An edit of still() as a whole, the same way.
    bool change_still(const Recipe& still);
    /// Other keys, and another recipe with its keys, each as one step; `edit` throws Error where
    /// there is no such recipe.
    bool change_keys(KeyedAnimation animation);
    bool change_with(const std::function<Recipe()>& edit) { return step(edit); }
    /// The number last under a hand, of which the next key will be; empty: none, or one that the
    /// recipe has no more.
    const std::string& touched();
    void touch(std::string path);
    /// A file or preset as one step; what cannot be read is logged and gives false.
    bool open_recipe(const std::string& path);
    /// One that was read from there, in the same way.
    void take_recipe(Recipe recipe, const std::string& path);
    /// Recipe JSON (the clipboard's) as one step.
    bool paste_recipe(const std::string& json);
    /// Recipe JSON that is not to be saved where it was found, as one step; messages name `origin`.
    bool recover_recipe(const std::string& json, const std::string& origin);
    /// Names the recipe's images from the file's folder on. Throws Error(io). The recipe counts as
    /// saved.
    void save_recipe(const std::string& path);

    void tell(std::string text) { add({false, std::move(text)}); }
    void complain(std::string text) { add({true, std::move(text)}); }
    /// The last thousand, oldest first.
    const std::deque<LogLine>& log() const { return log_; }
    /// What was complained of since the last call, the last of it; empty: nothing.
    std::optional<std::string> take_problem() { return std::exchange(problem_, {}); }

  private:
    void add(LogLine line);
    bool step(const std::function<Recipe()>& load);

    EditHistory history_;
    std::deque<LogLine> log_;
    std::optional<std::string> problem_;
    double time_ = 0.0;
    std::string touched_;
    std::optional<std::uint64_t> touched_revision_;  ///< of the recipe that is known to have it
    /// still() of a recipe with keys, and what it is of.
    struct Still {
        Recipe of{};
        double time = 0.0;
        Recipe recipe{};
        bool fails = false;
    };
    std::optional<Still> still_;
};

/// The settings ("path=value") that make `recipe` of `base`, as few as there are differences.
/// Empty and false in `possible` where settings cannot: another kind of texture, another node.
struct RecipeSettings {
    bool possible = true;
    std::vector<std::string> settings{};
};
RecipeSettings settings_between(const Recipe& base, const Recipe& recipe);

/// `burl bake MESH -o OUT --recipe BASE --set ...`, quoted for a shell, that makes the recipe's
/// texture; with the recipe's whole JSON to be saved where settings cannot say it, or not within
/// 4000 characters ("--recipe NAME.json"). `output`: the options that say what is written; none:
/// -o NAME.glb. `pose`: of --pose; empty: none.
std::string bake_command(const std::string& mesh, const std::string& base_path, const Recipe& base,
                         const Recipe& recipe, std::vector<std::string> output = {},
                         const std::string& pose = {});

}  // namespace burl
