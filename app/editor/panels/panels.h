#pragma once
// The editor's panels: each shows a part of the session and passes edits to it. The only state of
// their own is what is shown and selected.
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <imgui.h>

#include "app/editor/jobs/figures.h"
#include "app/editor/session/autosave.h"
#include "app/editor/session/session.h"
#include "app/editor/widgets/items.h"
#include "app/pipeline/stage_records.h"

namespace burl {

/// The session that a panel shows and edits, and the registry for its widgets.
struct PanelContext {
    EditSession& session;
    EditItems& items;
};

/// Draws the recipe's name and what it says about itself.
void recipe_heading(const Recipe& recipe);

/// Draws a slider or colour field for every control of the recipe (app/recipe/edit/controls.h),
/// each an item of its name; nothing for a recipe without controls. A change is that of --set.
void controls_panel(const PanelContext& context);

/// Draws a slider for every parameter in the tables (app/recipe/edit/leaves.h), grouped as in the
/// recipe; the pose's weight only where the mesh has a pose (`posed`).
void parameters_panel(const PanelContext& context, bool posed);

/// The selected stop of a colour map.
struct StopSelection {
    std::string map{};  ///< path of the map; empty: none
    std::size_t stop = 0;
};
/// Draws the recipe's colour maps as bars with stops: drags move stops, clicks add them, and the
/// selected stop can be recoloured and removed; a check box sets the wrap mode.
void color_maps_panel(const PanelContext& context, StopSelection& selection);

/// Draws the one colour map at a path so.
void color_map_editor(const PanelContext& context, const std::string& path,
                      StopSelection& selection);

/// Draws the list of steps, the present one marked; a click goes to one. Above it are the two
/// states that can be kept to compare with.
void steps_panel(const PanelContext& context);

/// The content of the metrics panel: figures of the atlas, times and work of the pipeline's stages,
/// and facts about the machine and the renderer.
struct MetricsView {
    std::vector<std::pair<std::string, std::string>> facts{};  ///< pairs of name and value
    std::shared_ptr<const AtlasFigures> atlas{};               ///< null: not ready
    StageRecords records{};
};
void metrics_panel(const MetricsView& view);

/// Draws the log, newest line last.
void log_panel(const PanelContext& context);

/// A line of the list of keys: what is pressed, several parted by ", " or "; ", and what it does.
struct KeyLine {
    const char* keys;
    const char* does;  ///< null: `keys` is the heading of what follows
};

/// The list of keys and gestures.
std::span<const KeyLine> keys_listed();

/// Draws the window of keys and gestures; returns false once it was closed.
bool cheat_sheet(const PanelContext& context);

/// Draws the window of recipes left behind by crashed editors, each to be taken or thrown away;
/// nothing where there are none. Returns the view (LeftRecipe::view) of one that was taken.
std::optional<std::string> recovery_window(const PanelContext& context, EditAutosave& autosave);

/// The height that the timeline's rows need in a panel of that width, in screen coordinates.
float timeline_height(EditSession& session, float width);
/// Draws the timeline below the object: clock, scrub bar, and the keys of animated numbers as
/// diamonds.
void timeline_panel(const PanelContext& context);
/// Handles the keys of the timeline: K, and while it is open Space, I and Delete.
void timeline_shortcuts(EditSession& session);

}  // namespace burl
