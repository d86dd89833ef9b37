#pragma once
// The state of an editor besides its textures: the recipe with its undo stack, the animation clock
// and the log. Independent of windows and OpenGL.
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/base/json_text.h"
#include "app/edit/graph_edit.h"
#include "app/editor/session/history.h"

namespace burl {

/// A line of the log panel.
struct LogLine {
    bool problem = false;
    std::string text;
};

/// A selected key of the track at `path`; an empty path: none.
struct KeyChoice {
    std::string path{};
    std::size_t key = 0;
    bool operator==(const KeyChoice&) const = default;
};

/// The state of the timeline of a recipe with animation tracks.
struct EditTimeline {
    /// Whether the panel is shown, and whether the animation plays.
    bool open = false, playing = false;
    bool scrubbing = false;  ///< the pointer drags the time
    KeyChoice chosen{};

    /// Whether the time is about to change, so that a coarse level of the texture is enough.
    bool moving() const { return playing || scrubbing; }
};

/// The edited recipe. All functions are called by one thread.
class EditSession {
  public:
    /// `recipe_path` is a file or a preset's name; the recipe's image names are relative to it.
    EditSession(Recipe recipe, const std::string& recipe_path);

    const EditHistory& history() const { return history_; }
    EditHistory& history() { return history_; }
    const Recipe& recipe() const { return history_.recipe(); }
    const std::string& recipe_path() const { return history_.path(); }

    EditTimeline timeline{};
    /// The states A and B, kept to compare with; empty: none.
    std::array<std::optional<Recipe>, 2> kept{};
    /// Whether a slider, a drag or the clock is changing the recipe.
    bool moving() const { return history_.in_gesture() || timeline.moving(); }
    /// The time on the animation clock in seconds; setting it is no edit.
    double time() const { return time_; }
    void set_time(double seconds) { time_ = seconds; }
    /// The recipe at that time with its animation tracks evaluated: the texture seen and the values
    /// sliders show. Where the values there form no valid recipe, the error is logged and the
    /// values without animation are returned.
    const Recipe& still();

    /// Sets a parameter of still() by its path as in --set; an animated number gets a key at the
    /// present time. An invalid value changes nothing, is logged and returns false.
    bool set(const std::string& path, const Json& value);
    /// Sets several parameters ("path=value") as one step, all or none; errors as for one
    /// parameter.
    bool set(const std::vector<std::string>& settings);
    /// Replaces still() as one step; changed animated numbers get keys at the present time.
    bool change_still(const Recipe& still);
    /// Replaces the animation as one step. change_with() replaces the whole recipe by the result of
    /// `edit`, which throws Error where there is none; the error is logged and false returned.
    bool change_keys(KeyedAnimation animation);
    bool change_with(const std::function<Recipe()>& edit) { return step(edit); }
    /// Takes a step of building (app/edit); logs what was lost with it, or why it is refused, and
    /// returns the place of its node, empty where there is none.
    std::optional<std::string> build(const std::function<GraphEdit(const Recipe&)>& edit);
    /// Opens a recipe with nothing built yet, of no file, for the same atlas, as one step.
    void open_new();
    /// The path of the number edited last, which the next key animates; empty: none, or the recipe
    /// no longer has it.
    const std::string& touched();
    void touch(std::string path);
    /// Opens a file or preset as one step; a read error is logged and returns false.
    bool open_recipe(const std::string& path);
    /// Opens a recipe that the caller has read from `path`, as one step.
    void take_recipe(Recipe recipe, const std::string& path);
    /// Replaces the recipe by recipe JSON from the clipboard as one step; errors are logged and
    /// return false.
    bool paste_recipe(const std::string& json);
    /// Opens recipe JSON that belongs to no file as one step; error messages name `origin`.
    bool recover_recipe(const std::string& json, const std::string& origin);
    /// Writes the recipe to a file, with its images named relative to the file's folder, and marks
    /// it saved. Throws Error(io).
    void save_recipe(const std::string& path);

    /// Logs a message.
    void tell(std::string text) { add({false, std::move(text)}); }
    /// Logs a problem.
    void complain(std::string text) { add({true, std::move(text)}); }
    /// The log's last thousand lines, oldest first.
    const std::deque<LogLine>& log() const { return log_; }
    /// Returns and clears the last problem logged; empty: none since the last call.
    std::optional<std::string> take_problem() { return std::exchange(problem_, {}); }

  private:
    void add(LogLine line);
    bool step(const std::function<Recipe()>& load);

    EditHistory history_;
    std::deque<LogLine> log_;
    std::optional<std::string> problem_;
    double time_ = 0.0;
    std::string touched_;
    /// History revision at which `touched_` was found in the recipe.
    std::optional<std::uint64_t> touched_revision_;
    /// A cached still(), with the recipe and the time it was evaluated for.
    struct Still {
        Recipe of{};  ///< recipe with its animation
        double time = 0.0;
        Recipe recipe{};     ///< recipe without animation
        bool fails = false;  ///< whether evaluation failed, so that the error is logged once
    };
    std::optional<Still> still_;
};

/// The shortest list of settings ("path=value") that turn `base` into `recipe`. Settings cannot
/// change the kind of texture or node: then `possible` is false and the list is empty.
struct RecipeSettings {
    bool possible = true;
    std::vector<std::string> settings{};
};
RecipeSettings settings_between(const Recipe& base, const Recipe& recipe);

/// Returns the command `burl bake MESH -o OUT --recipe BASE --set ...`, quoted for a shell, that
/// bakes the recipe's texture. Where settings cannot express the recipe or exceed 4000 characters,
/// it is "--recipe NAME.json", for the recipe's JSON to be saved as. `output`: the options that
/// choose the output, by default -o NAME.glb. `pose`: the argument of --pose; empty: none.
std::string bake_command(const std::string& mesh, const std::string& base_path, const Recipe& base,
                         const Recipe& recipe, std::vector<std::string> output = {},
                         const std::string& pose = {});

/// A time on the clock; `ended`: the end of an animation that does not loop.
struct ClockStep {
    double seconds = 0.0;
    bool ended = false;
};
/// Returns the time `dt` seconds after `seconds`.
ClockStep clock_after(const KeyedAnimation& animation, double seconds, double dt);

/// Starts playing, from the beginning where the clock is at the end; or stops at the nearest frame.
void toggle_playing(EditSession& session);

/// Advances the session's clock by `dt` seconds while the animation plays.
void advance(EditSession& session, double dt);

}  // namespace burl
