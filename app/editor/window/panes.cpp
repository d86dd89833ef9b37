#include "app/editor/window/panes.h"

#include <algorithm>
#include <cmath>

#include "app/editor/widgets/theme.h"

namespace burl {

namespace {

// Widths and heights in lines, so that they grow with the text.
constexpr float side_lines = 13.5f, least_lines = 6.0f;
constexpr float side_share = 0.32f;
constexpr float bar = 5.0f;  // the width of a splitter, in screen coordinates

/// Returns a length within [least, most], and most where these cross.
float within(float length, float least, float most) {
    return std::max(0.0f, std::floor(std::min(std::max(length, least), most)));
}

float side_width(const PaneWishes& wishes, double share) {
    const float wide = wishes.size.x, least = std::min(0.5f * wide, least_lines * wishes.line);
    if (share > 0.0) return within(float(share) * wide, least, wide - least);
    return within(std::max(side_share * wide, side_lines * wishes.line), least, 0.5f * wide);
}

float timeline_height(const PaneWishes& wishes, double share, float most) {
    if (wishes.timeline <= 0.0f) return 0.0f;
    const float wanted = share > 0.0 ? float(share) * wishes.size.y : wishes.timeline;
    return within(wanted, 3.0f * wishes.line, most);
}

/// Cuts the atlas off the rectangle that it shares with the object.
void split(Panes& panes, const PaneWishes& wishes, double share) {
    ScreenRect &object = panes.object, &atlas = panes.atlas;
    const float wide = object.high.x - object.low.x, high = object.high.y - object.low.y;
    panes.beside = wide >= 0.8f * high;
    atlas = object;
    const float whole = panes.beside ? wide : high;
    const float least = std::min(0.5f * whole, 3.0f * wishes.line);
    const float kept = whole - within(float(share) * whole, least, whole - least);
    (panes.beside ? object.high.x : object.high.y) =
        (panes.beside ? object.low.x : object.low.y) + kept;
    (panes.beside ? atlas.low.x : atlas.low.y) = panes.beside ? object.high.x : object.high.y;
}

/// A splitter: where it is, and in which direction it moves.
struct Splitter {
    const char* name;
    ScreenRect rect;
    bool sideways;
};

/// A splitter's state in a frame.
struct Drag {
    float at = 0.0f;  ///< where its middle is wanted
    bool moved = false, reset = false;
};

/// Draws a splitter as a window of its own, above those that it parts.
Drag drag(EditItems& items, const Splitter& splitter) {
    const ScreenRect& rect = splitter.rect;
    const ImVec2 size{std::max(1.0f, rect.high.x - rect.low.x),
                      std::max(1.0f, rect.high.y - rect.low.y)};
    ImGui::SetNextWindowPos(rect.low);
    ImGui::SetNextWindowSize(size);
    ImGui::Begin(splitter.name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::InvisibleButton("bar", size);
    items.note(splitter.name);
    const bool held = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
    if (held || hovered) {
        ImGui::SetMouseCursor(splitter.sideways ? ImGuiMouseCursor_ResizeEW
                                                : ImGuiMouseCursor_ResizeNS);
        ImGui::GetWindowDrawList()->AddRectFilled(rect.low, rect.high,
                                                  held ? palette().accent : palette().tick, 2.0f);
    }
    ImGui::End();
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    return {splitter.sideways ? pointer.x : pointer.y, held && ImGui::IsMouseDragging(0, 1.0f),
            hovered && ImGui::IsMouseDoubleClicked(0)};
}

ScreenRect upright(float x, float top, float bottom) {
    return {{x - 0.5f * bar, top}, {x + 0.5f * bar, bottom}};
}
ScreenRect level(float y, float left, float right) {
    return {{left, y - 0.5f * bar}, {right, y + 0.5f * bar}};
}

double share_at(float part, float whole) {
    return std::clamp(double(part / std::max(whole, 1.0f)), 0.05, 0.95);
}

void move_splitters(EditItems& items, const PaneWishes& wishes, const Panes& panes,
                    PaneShares& shares) {
    const PaneShares usual;
    const ScreenRect& side = panes.side;
    const Drag sides =
        drag(items, {"splitter:side", upright(side.low.x, side.low.y, side.high.y), true});
    if (sides.moved) shares.side = share_at(wishes.size.x - sides.at, wishes.size.x);
    if (sides.reset) shares.side = usual.side;
    if (const ScreenRect& timeline = panes.timeline; !timeline.empty()) {
        const Drag drawn =
            drag(items, {"splitter:timeline", level(timeline.low.y, 0.0f, timeline.high.x), false});
        if (drawn.moved) shares.timeline = share_at(wishes.size.y - drawn.at, wishes.size.y);
        if (drawn.reset) shares.timeline = usual.timeline;
    }
    const ScreenRect& atlas = panes.atlas;
    if (atlas.empty()) return;
    const ScreenRect both{panes.object.low, atlas.high};
    const ScreenRect between = panes.beside ? upright(atlas.low.x, both.low.y, both.high.y)
                                            : level(atlas.low.y, both.low.x, both.high.x);
    const Drag views = drag(items, {"splitter:atlas", between, panes.beside});
    if (views.moved)
        shares.atlas = panes.beside ? share_at(both.high.x - views.at, both.high.x - both.low.x)
                                    : share_at(both.high.y - views.at, both.high.y - both.low.y);
    if (views.reset) shares.atlas = usual.atlas;
}

}  // namespace

Panes panes_of(const PaneWishes& wishes, const PaneShares& shares) {
    const float wide = wishes.size.x, high = wishes.size.y, top = wishes.top;
    Panes panes;
    const float left = wide - side_width(wishes, shares.side);
    panes.side = {{left, top}, {wide, high}};
    const float tools =
        std::min((0.5f + float(wishes.tool_lines)) * wishes.line, std::max(0.0f, high - top));
    panes.tools = {{0.0f, top}, {left, top + tools}};
    const float room = std::max(0.0f, high - top - tools);
    const float strip = timeline_height(wishes, shares.timeline, 0.8f * room);
    panes.object = {{0.0f, top + tools}, {left, high - strip}};
    if (strip > 0.0f) panes.timeline = {{0.0f, high - strip}, {left, high}};
    if (wishes.atlas) split(panes, wishes, shares.atlas);
    return panes;
}

void splitters(EditItems& items, const PaneWishes& wishes, const Panes& panes, PaneShares& shares) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    move_splitters(items, wishes, panes, shares);
    ImGui::PopStyleVar(3);
}

}  // namespace burl
