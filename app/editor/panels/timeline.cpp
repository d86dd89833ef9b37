#include <fmt/format.h>
#include <imgui.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/editor/panels/keys.h"
#include "app/editor/panels/panels.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/session/groups.h"
#include "app/recipe/edit/key_check.h"
#include "app/recipe/edit/key_edit.h"
#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/edit/leaves.h"

namespace burl {

namespace {

constexpr std::size_t rows_seen = 4;
// Sizes at interface scale 1.
constexpr float label_width = 220.0f, diamond_size = 6.0f, tick_gap = 60.0f;
constexpr ImU32 lane_color = IM_COL32(40, 44, 52, 255), tick_color = IM_COL32(120, 126, 138, 255);
constexpr ImU32 head_color = IM_COL32(240, 90, 70, 255), key_color = IM_COL32(214, 176, 72, 255);
constexpr ImU32 chosen_color = IM_COL32(255, 232, 150, 255), edge_color = IM_COL32(20, 20, 20, 255);

bool has_key_now(const EditSession& session, const std::string& path) {
    const KeyedAnimation& animation = session.recipe().animation;
    const KeyTrack* track = find_track(animation, path);
    return track && key_near(animation, *track, session.time()) < track->keys.size();
}

/// Adds a key with the present value of the number edited last at the clock's time, or removes the
/// key it has there.
void toggle_key(EditSession& session) {
    const std::string path = session.touched();
    const KeyedAnimation& animation = session.recipe().animation;
    const auto number = find_number(slider_json(session.still()), path);
    if (!number) return;
    if (!has_key_now(session, path)) {
        session.change_keys(with_key(animation, path, session.time(), number->value));
        return;
    }
    const std::size_t key = key_near(animation, *find_track(animation, path), session.time());
    session.change_with([&] { return with_key_removed(session.recipe(), path, key); });
}

/// The timeline in one frame.
class TimelinePanel {
  public:
    explicit TimelinePanel(const PanelContext& context)
        : session_(context.session),
          items_(context.items),
          timeline_(session_.timeline),
          animation_(session_.recipe().animation),
          recipe_(slider_json(session_.still())),
          words_(node_words(recipe_)),
          groups_(parameter_groups(recipe_leaves(recipe_), words_)) {}

    void show() {
        clock();
        key_row();
        lane_low_ = ImGui::GetCursorScreenPos().x + scaled(label_width);
        lane_width_ = std::max(
            10.0f, ImGui::GetContentRegionAvail().x - scaled(label_width) - 2.0f * diamond_);
        ruler();
        if (ImGui::BeginChild("tracks")) tracks();
        ImGui::EndChild();
    }

  private:
    float scaled(float pixels) const { return pixels * scale_; }
    float x_of(double seconds) const {
        return lane_low_ + lane_width_ * float(seconds / animation_.seconds);
    }
    double seconds_at(float x) const {
        return animation_.seconds * double((x - lane_low_) / lane_width_);
    }

    std::string label(const std::string& path) const { return number_label(groups_, words_, path); }

    void clock() {
        if (ImGui::Button(timeline_.playing ? "Pause" : "Play", {scaled(64.0f), 0.0f}))
            toggle_playing(session_);
        items_.note("timeline.play");
        ImGui::SameLine();
        const int frame = int(std::lround(session_.time() * animation_.rate)) + 1;
        ImGui::TextUnformatted(fmt::format("{:5.2f} s   frame {:3} of {}", session_.time(), frame,
                                           frame_count(animation_))
                                   .c_str());
        ImGui::SameLine(0.0f, 24.0f);
        length();
        ImGui::SameLine();
        rate();
        ImGui::SameLine();
        KeyedAnimation edited = animation_;
        if (ImGui::Checkbox("loop", &edited.loop)) session_.change_keys(edited);
        items_.note("timeline.loop");
    }

    void length() {
        KeyedAnimation edited = animation_;
        const double low = 0.01, high = 3600.0;
        ImGui::SetNextItemWidth(scaled(64.0f));
        const bool moved = ImGui::DragScalar("s", ImGuiDataType_Double, &edited.seconds, 0.02f,
                                             &low, &high, "%.2f", ImGuiSliderFlags_AlwaysClamp);
        items_.note("timeline.seconds");
        follow_gesture(session_.history());
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("How long the animation is");
        if (moved) session_.change_keys(edited);
    }

    void rate() {
        KeyedAnimation edited = animation_;
        ImGui::SetNextItemWidth(scaled(44.0f));
        const bool moved = ImGui::DragInt("frames/s", &edited.rate, 0.1f, 1, 240, "%d",
                                          ImGuiSliderFlags_AlwaysClamp);
        items_.note("timeline.rate");
        follow_gesture(session_.history());
        if (moved) session_.change_keys(edited);
    }

    /// Draws the choice of the number that the next key animates.
    void key_row() {
        const std::string path = session_.touched();
        ImGui::SetNextItemWidth(scaled(260.0f));
        const std::string shown = path.empty() ? "choose a number" : label(path);
        const bool open = ImGui::BeginCombo("##number", shown.c_str(), ImGuiComboFlags_HeightLarge);
        items_.note("timeline.number");
        if (open) choices(path);
        ImGui::SameLine();
        ImGui::BeginDisabled(path.empty());
        if (ImGui::Button(has_key_now(session_, path) ? "Remove key" : "Set key",
                          {scaled(96.0f), 0.0f}))
            toggle_key(session_);
        items_.note("timeline.key");
        ImGui::EndDisabled();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s (I)", path.c_str());
        if (!find_track(animation_, path)) return;
        ImGui::SameLine();
        if (ImGui::Button("Remove all its keys"))
            session_.change_with(
                [&] { return with_track_removed(session_.recipe(), path, session_.time()); });
        items_.note("timeline.remove");
    }

    void choices(const std::string& path) {
        for (const RecipeNumber& number : recipe_numbers(slider_json(session_.still()))) {
            const std::string id = fmt::format("{}##{}", label(number.path), number.path);
            if (ImGui::Selectable(id.c_str(), number.path == path)) session_.touch(number.path);
            items_.note("timeline.number=" + number.path);
        }
        ImGui::EndCombo();
    }

    /// Draws the scrub bar, a ruler in seconds.
    void ruler() {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float height = ImGui::GetFrameHeight();
        ImGui::SetCursorScreenPos({lane_low_ - diamond_, at.y});
        ImGui::InvisibleButton("ruler", {lane_width_ + 2.0f * diamond_, height});
        items_.note("timeline.ruler");
        timeline_.scrubbing = ImGui::IsItemActive();
        if (timeline_.scrubbing) {
            timeline_.playing = false;
            session_.set_time(nearest_frame(animation_, seconds_at(ImGui::GetIO().MousePos.x)));
        }
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled({lane_low_, at.y}, {lane_low_ + lane_width_, at.y + height}, lane_color);
        ticks(list, at.y, height);
        const float x = x_of(session_.time());
        list.AddTriangleFilled({x - diamond_, at.y}, {x + diamond_, at.y},
                               {x, at.y + 1.6f * diamond_}, head_color);
        list.AddLine({x, at.y}, {x, at.y + height}, head_color, 2.0f);
    }

    void ticks(ImDrawList& list, float y, float height) const {
        const double fewest = animation_.seconds * double(scaled(tick_gap) / lane_width_);
        double step = std::pow(10.0, std::floor(std::log10(fewest)));
        for (const double factor : {2.0, 2.5, 2.0})  // steps of 1, 2, 5 and 10
            if (step < fewest) step *= factor;
        const int count = int(animation_.seconds / step + 1e-9);
        for (int i = 0; i <= count; ++i) {
            const float x = x_of(i * step);
            list.AddLine({x, y + 0.6f * height}, {x, y + height}, tick_color);
            const std::string text = fmt::format("{:.4g}", i * step);
            if (x + scaled(tick_gap) * 0.5f < lane_low_ + lane_width_)
                list.AddText({x + 3.0f, y + 0.5f * (height - ImGui::GetFontSize())}, tick_color,
                             text.c_str());
        }
    }

    void tracks() {
        if (animation_.tracks.empty())
            ImGui::TextWrapped(
                "Nothing moves yet: move a slider, set a key, go to another time, move the slider "
                "again.");
        for (const KeyTrack& track : animation_.tracks) {
            ImGui::PushID(track.path.c_str());
            row(track);
            ImGui::PopID();
        }
    }

    void row(const KeyTrack& track) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float height = ImGui::GetFrameHeight();
        ImGui::SetCursorScreenPos({at.x, at.y + ImGui::GetStyle().FramePadding.y});
        ease(track);
        ImGui::SameLine();
        const bool touched = track.path == session_.touched();
        const float label_room = lane_low_ - diamond_ - ImGui::GetCursorScreenPos().x - 4.0f;
        if (ImGui::Selectable(label(track.path).c_str(), touched, 0, {label_room, 0.0f}))
            session_.touch(track.path);
        items_.note("timeline.track:" + track.path);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", track.path.c_str());
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float middle = at.y + 0.5f * height;
        list.AddRectFilled({lane_low_, at.y + 2.0f},
                           {lane_low_ + lane_width_, at.y + height - 2.0f}, lane_color);
        const float x = x_of(session_.time());
        list.AddLine({x, at.y}, {x, at.y + height}, head_color, 1.0f);
        if (track.keys.size() > 1)
            list.AddLine(
                {x_of(track.keys.front().seconds), middle},
                {std::min(x_of(track.keys.back().seconds), lane_low_ + lane_width_), middle},
                tick_color, 2.0f);
        for (std::size_t i = 0; i < track.keys.size(); ++i)
            if (track.keys[i].seconds <= animation_.seconds) key(track, i, middle);
        ImGui::SetCursorScreenPos({at.x, at.y + height + 2.0f});
        ImGui::Dummy({1.0f, 0.0f});
    }

    void ease(const KeyTrack& track) {
        const bool smooth = track.ease == KeyEase::smooth;
        if (ImGui::SmallButton(to_string(track.ease).data())) {
            KeyedAnimation edited = animation_;
            for (KeyTrack& other : edited.tracks)
                if (other.path == track.path)
                    other.ease = smooth ? KeyEase::linear : KeyEase::smooth;
            session_.change_keys(edited);
        }
        items_.note("timeline.ease:" + track.path);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("How it goes from key to key; smooth: at rest in every key");
    }

    void key(const KeyTrack& track, std::size_t index, float y) {
        const float x = x_of(track.keys[index].seconds);
        ImGui::PushID(int(index));
        ImGui::SetCursorScreenPos({x - diamond_, y - diamond_});
        ImGui::InvisibleButton("key", {2.0f * diamond_, 2.0f * diamond_});
        items_.note(fmt::format("timeline.key:{}.{}", track.path, index));
        const bool chosen = timeline_.chosen == KeyChoice{track.path, index};
        ImGui::GetWindowDrawList()->AddNgonFilled({x, y}, diamond_ + 1.0f, edge_color, 4);
        ImGui::GetWindowDrawList()->AddNgonFilled({x, y}, diamond_ - 0.5f,
                                                  chosen ? chosen_color : key_color, 4);
        key_input(track, index);
        ImGui::PopID();
    }

    /// Handles input on a key: a press selects it and sets the clock to its time, a drag moves it,
    /// and a right click removes it.
    void key_input(const KeyTrack& track, std::size_t index) {
        follow_gesture(session_.history());
        if (ImGui::IsItemActivated()) {
            timeline_.playing = false;
            timeline_.chosen = {track.path, index};
            session_.touch(track.path);
            session_.set_time(track.keys[index].seconds);
        }
        if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, 2.0f)) {
            const double to = seconds_at(ImGui::GetIO().MousePos.x);
            session_.change_keys(
                with_key_moved(session_.recipe().animation, track.path, index, to));
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%.3g at %.2f s\nDrag: move. Right-click: remove.",
                              track.keys[index].value, track.keys[index].seconds);
            if (ImGui::IsMouseClicked(1))
                session_.change_with(
                    [&] { return with_key_removed(session_.recipe(), track.path, index); });
        }
    }

    EditSession& session_;
    EditItems& items_;
    EditTimeline& timeline_;
    const KeyedAnimation animation_;  ///< animation at the start of the frame
    const Json recipe_;
    const NodeWords words_;  ///< names of nodes, for labels
    const std::vector<ParameterGroup> groups_;
    const float scale_ = float(interface_scale());
    const float diamond_ = diamond_size * scale_;
    float lane_low_ = 0.0f, lane_width_ = 1.0f;
};

void remove_chosen(EditSession& session) {
    EditTimeline& timeline = session.timeline;
    const KeyTrack* track = find_track(session.recipe().animation, timeline.chosen.path);
    if (track && timeline.chosen.key < track->keys.size())
        session.change_with([&] {
            return with_key_removed(session.recipe(), timeline.chosen.path, timeline.chosen.key);
        });
    timeline.chosen = {};
}

}  // namespace

float timeline_height(const EditSession& session) {
    const std::size_t rows =
        std::clamp<std::size_t>(session.recipe().animation.tracks.size(), 2, rows_seen);
    const ImGuiStyle& style = ImGui::GetStyle();
    return 3.0f * ImGui::GetFrameHeightWithSpacing() +
           float(rows) * (ImGui::GetFrameHeightWithSpacing() + 2.0f) + 2.0f * style.WindowPadding.y;
}

void timeline_panel(const PanelContext& context) {
    if (ImGui::Begin("Timeline", nullptr, fixed_window)) TimelinePanel(context).show();
    ImGui::End();
}

void timeline_shortcuts(EditSession& session) {
    EditTimeline& timeline = session.timeline;
    if (pressed("K")) timeline.open = !timeline.open;
    if (!timeline.open) return;
    if (pressed("Space") && !ImGui::GetIO().NavVisible) toggle_playing(session);
    if (pressed("I")) toggle_key(session);
    if (pressed("Delete")) remove_chosen(session);
}

}  // namespace burl
