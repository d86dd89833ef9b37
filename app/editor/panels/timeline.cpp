#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/editor/panels/panels.h"
#include "app/editor/session/groups.h"
#include "app/editor/widgets/flow.h"
#include "app/editor/widgets/keys.h"
#include "app/editor/widgets/widgets.h"
#include "app/recipe/edit/key_check.h"
#include "app/recipe/edit/key_edit.h"
#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/edit/leaves.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

constexpr std::size_t rows_seen = 4;
// Sizes at interface scale 1.
constexpr float label_width = 220.0f, diamond_size = 6.0f, tick_gap = 60.0f, number_width = 64.0f;

bool has_key_now(const EditSession& session, const std::string& path) {
    const KeyedAnimation& animation = session.recipe().animation;
    const KeyTrack* track = find_track(animation, path);
    return track && key_near(animation, *track, session.time()) < track->keys.size();
}

/// Adds a key with the present value of the number edited last at the clock's time; where it has
/// one, that holds the value already.
void set_key(EditSession& session) {
    const std::string path = session.touched();
    const auto number = find_number(slider_json(session.still()), path);
    if (number && !has_key_now(session, path))
        session.change_keys(
            with_key(session.recipe().animation, path, session.time(), number->value));
}

/// Removes the key of the number edited last at the clock's time.
void remove_key(EditSession& session) {
    const std::string path = session.touched();
    const KeyedAnimation& animation = session.recipe().animation;
    const std::size_t key = key_near(animation, *find_track(animation, path), session.time());
    session.change_with([&] { return with_key_removed(session.recipe(), path, key); });
}

constexpr const char* remove_all = "Remove all its keys";

float button_width(const char* label) {
    return ImGui::CalcTextSize(label).x + 2.0f * ImGui::GetStyle().FramePadding.x;
}

/// The widths of what the first rows of the timeline have, in screen coordinates.
std::vector<float> clock_widths() {
    const float scale = float(interface_scale()), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const auto field = [&](const char* unit) {
        return number_width * scale + gap + ImGui::CalcTextSize(unit).x;
    };
    return {std::max(button_width("Play"), button_width("Pause")),
            ImGui::CalcTextSize("00.00 s   frame 000 of 000").x, field("s"), field("frames/s"),
            ImGui::GetTextLineHeight() + gap + ImGui::CalcTextSize("loop").x};
}
std::vector<float> key_widths(EditSession& session) {
    std::vector<float> widths{260.0f * float(interface_scale()), button_width("Remove key")};
    if (find_track(session.recipe().animation, session.touched()))
        widths.push_back(button_width(remove_all));
    return widths;
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
        const float room = ImGui::GetContentRegionAvail().x;
        const float label_room = std::min(scaled(label_width), 0.45f * room);
        lane_low_ = ImGui::GetCursorScreenPos().x + label_room;
        lane_width_ = std::max(10.0f, room - label_room - 2.0f * diamond_);
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
        const std::vector<float> widths = clock_widths();
        Flow flow(widths);
        flow.next();
        if (ImGui::Button(timeline_.playing ? "Pause" : "Play", {widths[0], 0.0f}))
            toggle_playing(session_);
        items_.note("timeline.play");
        tip("Plays and stops (Space).");
        flow.next();
        const int frame = int(std::lround(session_.time() * animation_.rate)) + 1;
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(fmt::format("{:5.2f} s   frame {:3} of {}", session_.time(), frame,
                                           frame_count(animation_))
                                   .c_str());
        flow.next();
        length();
        flow.next();
        rate();
        flow.next();
        KeyedAnimation edited = animation_;
        if (check_box(items_, "loop", "timeline.loop", edited.loop)) session_.change_keys(edited);
        tip("Whether the end is the beginning again.");
    }

    void length() {
        KeyedAnimation edited = animation_;
        const double low = 0.01, high = 3600.0;
        ImGui::SetNextItemWidth(scaled(number_width));
        const bool moved = ImGui::DragScalar("s", ImGuiDataType_Double, &edited.seconds, 0.02f,
                                             &low, &high, "%.2f", ImGuiSliderFlags_AlwaysClamp);
        items_.note("timeline.seconds");
        follow_gesture(session_.history());
        tip("How long the animation is.");
        if (moved) session_.change_keys(edited);
    }

    void rate() {
        KeyedAnimation edited = animation_;
        ImGui::SetNextItemWidth(scaled(number_width));
        const bool moved = ImGui::DragInt("frames/s", &edited.rate, 0.1f, 1, 240, "%d",
                                          ImGuiSliderFlags_AlwaysClamp);
        items_.note("timeline.rate");
        follow_gesture(session_.history());
        tip("How many frames are exported for each second.");
        if (moved) session_.change_keys(edited);
    }

    /// Draws the choice of the number that the next key animates.
    void key_row() {
        const std::string path = session_.touched();
        const std::vector<float> widths = key_widths(session_);
        Flow flow(widths);
        flow.next();
        ImGui::SetNextItemWidth(std::min(widths[0], ImGui::GetContentRegionAvail().x));
        const std::string shown = path.empty() ? "choose a number" : label(path);
        const bool open = ImGui::BeginCombo("##number", shown.c_str(), ImGuiComboFlags_HeightLarge);
        items_.note("timeline.number");
        if (open) choices(path);
        flow.next();
        ImGui::BeginDisabled(path.empty());
        const bool has_key = has_key_now(session_, path);
        if (ImGui::Button(has_key ? "Remove key" : "Set key", {widths[1], 0.0f}))
            (has_key ? remove_key : set_key)(session_);
        items_.note("timeline.key");
        ImGui::EndDisabled();
        tip(fmt::format("{}{}", path, has_key ? "" : " (I)").c_str());
        if (widths.size() < 3) return;
        flow.next();
        if (ImGui::Button(remove_all))
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
        list.AddRectFilled({lane_low_, at.y}, {lane_low_ + lane_width_, at.y + height},
                           palette().lane);
        ticks(list, at.y, height);
        const float x = x_of(session_.time());
        list.AddTriangleFilled({x - diamond_, at.y}, {x + diamond_, at.y},
                               {x, at.y + 1.6f * diamond_}, palette().head);
        list.AddLine({x, at.y}, {x, at.y + height}, palette().head, 2.0f);
    }

    void ticks(ImDrawList& list, float y, float height) const {
        const double fewest = animation_.seconds * double(scaled(tick_gap) / lane_width_);
        double step = std::pow(10.0, std::floor(std::log10(fewest)));
        for (const double factor : {2.0, 2.5, 2.0})  // steps of 1, 2, 5 and 10
            if (step < fewest) step *= factor;
        const int count = int(animation_.seconds / step + 1e-9);
        for (int i = 0; i <= count; ++i) {
            const float x = x_of(i * step);
            list.AddLine({x, y + 0.6f * height}, {x, y + height}, palette().tick);
            const std::string text = fmt::format("{:.4g}", i * step);
            if (x + scaled(tick_gap) * 0.5f < lane_low_ + lane_width_)
                list.AddText({x + 3.0f, y + 0.5f * (height - ImGui::GetFontSize())}, palette().tick,
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
                           {lane_low_ + lane_width_, at.y + height - 2.0f}, palette().lane);
        const float x = x_of(session_.time());
        list.AddLine({x, at.y}, {x, at.y + height}, palette().head, 1.0f);
        if (track.keys.size() > 1)
            list.AddLine(
                {x_of(track.keys.front().seconds), middle},
                {std::min(x_of(track.keys.back().seconds), lane_low_ + lane_width_), middle},
                palette().tick, 2.0f);
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
        tip("How it goes from key to key; smooth: at rest in every key.");
    }

    void key(const KeyTrack& track, std::size_t index, float y) {
        const float x = x_of(track.keys[index].seconds);
        ImGui::PushID(int(index));
        ImGui::SetCursorScreenPos({x - diamond_, y - diamond_});
        ImGui::InvisibleButton("key", {2.0f * diamond_, 2.0f * diamond_});
        items_.note(fmt::format("timeline.key:{}.{}", track.path, index));
        const bool chosen = timeline_.chosen == KeyChoice{track.path, index};
        ImGui::GetWindowDrawList()->AddNgonFilled({x, y}, diamond_ + 1.0f, palette().edge, 4);
        ImGui::GetWindowDrawList()->AddNgonFilled({x, y}, diamond_ - 0.5f,
                                                  chosen ? palette().chosen : palette().key, 4);
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

float timeline_height(EditSession& session, float width) {
    const std::size_t rows =
        std::clamp<std::size_t>(session.recipe().animation.tracks.size(), 2, rows_seen);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float room = width - 2.0f * style.WindowPadding.x;
    const int lines = Flow::lines(clock_widths(), room) + Flow::lines(key_widths(session), room);
    return float(1 + lines) * ImGui::GetFrameHeightWithSpacing() +
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
    if (pressed("I")) set_key(session);
    if (pressed("Delete")) remove_chosen(session);
}

}  // namespace burl
