#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/panels/panels.h"
#include "app/editor/session/groups.h"
#include "app/editor/session/stops.h"
#include "app/editor/widgets/slider.h"
#include "app/editor/widgets/widgets.h"
#include "app/recipe/edit/leaves.h"
#include "atlas/base/json.h"
#include "procedural/model/texture_json.h"

namespace burl {

namespace {

constexpr float bar_height = 28.0f, handle_size = 7.0f;  // at interface scale 1
constexpr float least_width = 10.0f;                     // least width of a bar, in a narrow window
constexpr std::size_t bar_colors = 256;
constexpr Rgb8 dark_behind{60, 60, 60}, light_behind{200, 200, 200};  // behind what is transparent

const Json& at_path(const Json& recipe, const std::string& path) {
    const Json* place = &recipe;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        const std::string key = path.substr(begin, end - begin);
        place = place->is_array() ? &(*place)[std::size_t(std::stoul(key))] : &(*place)[key];
        begin = end + 1;
    }
    return *place;
}

ImU32 color_code(const Rgb8& color) {
    return IM_COL32(color.r, color.g, color.b, 255);
}

/// The editor of one colour map.
class MapEditor {
  public:
    MapEditor(const PanelContext& context, std::string path, StopSelection& selection)
        : context_(context),
          path_(std::move(path)),
          selection_(selection),
          recipe_(slider_json(context.session.still())),
          map_(texture_from_json(at_path(recipe_, path_)).colors) {}

    void show() {
        ImGui::PushID(path_.c_str());
        bar();
        for (std::size_t i = 0; i < map_.stops.size(); ++i) stop(i);
        ImGui::SetCursorScreenPos({low_.x, low_.y + bar_height + 3.0f * handle_size});
        ImGui::Dummy({width_, 1.0f});
        wrap();
        if (selection_.map == path_ && selection_.stop < map_.stops.size()) selected();
        ImGui::PopID();
    }

  private:
    EditHistory& history() { return context_.session.history(); }
    void set_stops(const std::vector<ColorStop>& stops) {
        context_.session.set(path_ + ".stops", stops_to_json(stops));
    }
    float x_of(double position) const { return low_.x + float(position) * width_; }

    /// Draws the map as a bar; a click between the stops adds a stop.
    void bar() {
        low_ = ImGui::GetCursorScreenPos();
        width_ = std::max(least_width, ImGui::GetContentRegionAvail().x - 2.0f * handle_size);
        low_.x += handle_size;
        ImGui::SetCursorScreenPos(low_);
        const bool clicked = ImGui::InvisibleButton("bar", {width_, bar_height});
        context_.items.note(path_ + ".bar");
        tip("A click adds a stop of the colour that is there.");
        draw_half(0.0f, dark_behind);
        draw_half(0.5f, light_behind);
        if (!clicked) return;
        std::size_t at = 0;
        const double position = double((ImGui::GetIO().MousePos.x - low_.x) / width_);
        set_stops(with_stop_added(map_, position, at));
        selection_ = {path_, at};
    }

    /// Draws the map over the colour `behind` in the half of the bar that begins at `share` of its
    /// height.
    void draw_half(float share, const Rgb8& behind) const {
        const std::vector<Rgb8> colors = map_colors(map_, bar_colors, behind);
        const float step = width_ / float(bar_colors), top = low_.y + share * bar_height;
        for (std::size_t i = 0; i < bar_colors; ++i)
            ImGui::GetWindowDrawList()->AddRectFilled(
                {low_.x + step * float(i), top},
                {low_.x + step * float(i + 1) + 0.5f, top + 0.5f * bar_height},
                color_code(colors[i]));
    }

    void stop(std::size_t index) {
        const float x = x_of(map_.stops[index].position), y = low_.y + bar_height;
        ImGui::PushID(int(index));
        ImGui::SetCursorScreenPos({x - handle_size, y});
        ImGui::InvisibleButton("stop", {2.0f * handle_size, 2.5f * handle_size});
        context_.items.note(path_ + ".stops." + std::to_string(index));
        drag(index);
        draw(index, x, y);
        ImGui::PopID();
    }

    void drag(std::size_t index) {
        if (ImGui::IsItemActivated()) {
            history().begin_gesture();
            selection_ = {path_, index};
            context_.session.touch(path_ + ".stops." + std::to_string(index) + ".0");
        }
        // The stop that is dragged has another index once it has passed others.
        const std::size_t dragged = selection_.stop;
        if (ImGui::IsItemActive() && ImGui::GetIO().MouseDelta.x != 0.0f &&
            dragged < map_.stops.size()) {
            const float share = ImGui::GetIO().KeyShift ? 0.1f : 1.0f;
            const double by = double(share * ImGui::GetIO().MouseDelta.x / width_);
            move_selected(map_.stops[dragged].position + by);
        }
        if (ImGui::IsItemDeactivated()) history().end_gesture();
        if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(1)) remove(index);
    }

    /// Moves the selected stop; where stops of the map have keys, those must keep their indices.
    void move_selected(double position) {
        const auto& tracks = context_.session.recipe().animation.tracks;
        const bool keyed = std::ranges::any_of(tracks, [&](const KeyTrack& track) {
            return track.path.starts_with(path_ + ".stops.");
        });
        std::size_t at = selection_.stop;
        set_stops(keyed ? with_stop_moved_between(map_.stops, at, position)
                        : with_stop_moved(map_.stops, at, position));
        selection_.stop = at;
        context_.session.touch(path_ + ".stops." + std::to_string(at) + ".0");
    }

    void draw(std::size_t index, float x, float y) const {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const bool chosen = selection_.map == path_ && selection_.stop == index;
        list.AddTriangleFilled({x, y - 1.0f}, {x - handle_size, y + 2.0f * handle_size},
                               {x + handle_size, y + 2.0f * handle_size},
                               color_code(map_.stops[index].color));
        list.AddTriangle({x, y - 1.0f}, {x - handle_size, y + 2.0f * handle_size},
                         {x + handle_size, y + 2.0f * handle_size},
                         chosen ? palette().star : ImGui::GetColorU32(ImGuiCol_Text),
                         chosen ? 2.0f : 1.0f);
    }

    void remove(std::size_t index) {
        set_stops(with_stop_removed(map_.stops, index));
        selection_ = {};
    }

    void wrap() {
        bool repeat = map_.wrap == Wrap::repeat;
        if (check_box(context_.items, "repeat", path_ + ".wrap", repeat))
            context_.session.set(path_ + ".wrap", to_string(repeat ? Wrap::repeat : Wrap::clamp));
        tip("Whether the map begins again beyond its ends, or keeps their colours.");
    }

    /// Draws position, colour and alpha of the selected stop as numbers.
    void selected() {
        const ColorStop& stop = map_.stops[selection_.stop];
        double position = stop.position;
        begin_row("place", path_);
        const bool moved = slide("##place", position, {0.0, 1.0}, SliderScale::linear, "%.3f");
        context_.items.note(path_ + ".place");
        follow_gesture(history());
        tip("Where along the map the colour is, from 0 to 1.");
        begin_row("colour", path_);
        ColorStop edited = stop;
        const bool colored = edit_color("##colour", edited.color, edited.alpha);
        context_.items.note(path_ + ".colour");
        follow_gesture(history());
        tip("The stop's colour and how opaque it is; right-click for other notations.");
        const bool unwanted = ImGui::Button("Delete the stop");
        context_.items.note(path_ + ".delete");
        tip("Takes the stop away; so does a right click on it.");
        if (moved) return move_selected(position);
        if (colored) replace(edited);
        if (unwanted) remove(selection_.stop);
    }

    void replace(const ColorStop& edited) {
        std::vector<ColorStop> stops = map_.stops;
        stops[selection_.stop] = edited;
        set_stops(stops);
    }

    const PanelContext& context_;
    std::string path_;
    StopSelection& selection_;
    Json recipe_;
    ColorMap map_;
    ImVec2 low_{};
    float width_ = 0.0f;
};

}  // namespace

void color_map_editor(const PanelContext& context, const std::string& path,
                      StopSelection& selection) {
    MapEditor(context, path, selection).show();
}

void color_maps_panel(const PanelContext& context, StopSelection& selection) {
    const Json recipe = slider_json(context.session.still());
    const std::vector<std::string> paths = color_map_paths(recipe);
    if (paths.empty()) ImGui::TextWrapped("This recipe has no colour map.");
    const NodeWords words = node_words(recipe);
    for (const std::string& path : paths) {
        ImGui::PushFont(heading_font());
        ImGui::TextUnformatted(map_title(words, path).c_str());
        ImGui::PopFont();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", path.c_str());
        context.items.note(path + ".title");
        MapEditor(context, path, selection).show();
        ImGui::Separator();
    }
    if (paths.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
    ImGui::TextWrapped(
        "Click a bar to add a stop, drag the handles below it; a handle that was clicked has its "
        "place and colour here. Right-click takes it away.");
    ImGui::PopStyleColor();
}

}  // namespace burl
