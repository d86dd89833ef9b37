#pragma once
// The editor's panels. Each shows a part of the session and hands what a person does to it; none
// keeps a state of its own but what it shows of itself.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/panels/items.h"
#include "app/editor/session/session.h"
#include "app/editor/work/figures.h"
#include "app/pipeline/stage_records.h"

namespace burl {

/// What a panel needs: the session, and where items are noted.
struct PanelContext {
    EditSession& session;
    EditItems& items;
};

/// Sliders for everything in the parameter tables (app/recipe/leaves.h), grouped as the recipe is;
/// that of the pose where there is one.
void parameters_panel(const PanelContext& context, bool posed);

/// The colour maps of the recipe as bars with stops: drag, click to add, recolour, delete; wrap.
struct StopSelection {
    std::string map{};  ///< path of the map; empty: none
    std::size_t stop = 0;
};
void color_maps_panel(const PanelContext& context, StopSelection& selection);

/// Figures of the atlas, times and work of the pipeline's stages, machine and renderer.
struct MetricsView {
    std::vector<std::pair<std::string, std::string>> facts{};  ///< name, value
    std::shared_ptr<const AtlasFigures> atlas{};               ///< null: not yet
    StageRecords records{};
};
void metrics_panel(const PanelContext& context, const MetricsView& view);

/// What there was to tell, newest last.
void log_panel(const PanelContext& context);

/// Keys and gestures; false once it was closed.
bool cheat_sheet(const PanelContext& context);

}  // namespace burl
