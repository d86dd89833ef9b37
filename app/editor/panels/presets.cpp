#include "app/editor/panels/panels.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "app/editor/panels/widgets.h"
#include "app/recipe/preset_notes.h"

namespace burl {

namespace {

constexpr float least_side = 96.0f;  // minimum side of a tile at interface scale 1
constexpr float margin = 5.0f;       // space between a tile's edge and its ball
constexpr int picture_step = 128;    // sizes of thumbnails are multiples of this
constexpr float large_side = 256.0f, rest_seconds = 0.2f;  // tooltip: side of the ball, and delay

ImVec2 plus(const ImVec2& a, float x, float y) {
    return {a.x + x, a.y + y};
}

/// Shortens a name to a width, ending in dots where it does not fit.
std::string shortened(std::string name, float width) {
    if (ImGui::CalcTextSize(name.c_str()).x <= width) return name;
    while (!name.empty() && ImGui::CalcTextSize((name + "..").c_str()).x > width) name.pop_back();
    return name + "..";
}

int picture_side(float width) {
    const float pixels = width * ImGui::GetIO().DisplayFramebufferScale.x;
    return int(std::ceil(pixels / float(picture_step))) * picture_step;
}

class Gallery {
  public:
    Gallery(const PanelContext& context, const PresetPicture& picture)
        : context_(context), picture_(picture) {
        const float wide = ImGui::GetContentRegionAvail().x;
        const float least = least_side * float(interface_scale());
        columns_ = std::max(2, int(wide / least));
        side_ = std::max(2.0f * margin + 1.0f, std::floor(wide / float(columns_)));
    }

    /// Draws the tiles; returns the preset under the pointer or selected by keys, or null.
    const PresetNote* show(const std::vector<PresetNote>& presets) {
        const PresetNote* looked_at = nullptr;
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 2.0f));
        for (std::size_t i = 0; i < presets.size(); ++i) {
            if (i % std::size_t(columns_) != 0) ImGui::SameLine();
            if (tile(presets[i])) looked_at = &presets[i];
        }
        ImGui::PopStyleVar();
        return looked_at;
    }

  private:
    bool tile(const PresetNote& preset) {
        const std::string name(preset.name);
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const float line = ImGui::GetTextLineHeight();
        if (ImGui::InvisibleButton(name.c_str(), {side_, side_ + line}))
            context_.session.open_recipe(name);
        context_.items.note("preset:" + name);
        const bool looked_at = ImGui::IsItemHovered() || ImGui::IsItemFocused();
        enlarged(preset);
        frame(low, plus(low, side_, side_ + line), name == context_.session.recipe_path(),
              looked_at);
        ball(name, plus(low, margin, margin), side_ - 2.0f * margin);
        const std::string shown = shortened(name, side_);
        const float space = 0.5f * (side_ - ImGui::CalcTextSize(shown.c_str()).x);
        ImGui::GetWindowDrawList()->AddText(plus(low, space, side_ - 2.0f),
                                            ImGui::GetColorU32(ImGuiCol_Text), shown.c_str());
        return looked_at;
    }

    /// Draws a tooltip with a large ball and the description after the pointer has rested on a
    /// tile, except for the open preset, which the object shows.
    void enlarged(const PresetNote& preset) const {
        if (!ImGui::IsItemHovered(ImGuiHoveredFlags_None) || ImGui::GetIO().MouseDown[0] ||
            GImGui->HoveredIdTimer < rest_seconds || preset.name == context_.session.recipe_path())
            return;
        const float width = large_side * float(interface_scale());
        ImGui::BeginTooltip();
        const ImVec2 low = ImGui::GetCursorScreenPos();
        ImGui::Dummy({width, width});
        context_.items.note("preset enlarged");
        ball(std::string(preset.name), low, width);
        ImGui::PushTextWrapPos(width + ImGui::GetStyle().WindowPadding.x);
        ImGui::TextUnformatted(fmt::format("{}: {}", preset.name, preset.about).c_str());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }

    static void frame(const ImVec2& low, const ImVec2& high, bool current, bool looked_at) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 from = plus(low, 1.0f, 1.0f), to = plus(high, -1.0f, -1.0f);
        if (looked_at)
            list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_HeaderHovered, 0.5f), 4.0f);
        if (current) list.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_CheckMark), 4.0f, 0, 2.0f);
    }

    void ball(const std::string& name, const ImVec2& low, float width) const {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 high = plus(low, width, width);
        const bool seen = ImGui::IsItemVisible();
        const int side = picture_side(width), tile_side = picture_side(side_ - 2.0f * margin);
        ImTextureID picture = seen ? picture_(name, side) : nullptr;
        // A smaller thumbnail until the large one is ready.
        if (picture == nullptr && seen && side != tile_side) picture = picture_(name, tile_side);
        if (picture != nullptr)
            list.AddImageRounded(picture, low, high, {0.0f, 0.0f}, {1.0f, 1.0f}, IM_COL32_WHITE,
                                 0.5f * width);
        else
            list.AddCircleFilled(plus(low, 0.5f * width, 0.5f * width), 0.5f * width,
                                 ImGui::GetColorU32(ImGuiCol_FrameBg), 48);
    }

    const PanelContext& context_;
    const PresetPicture& picture_;
    int columns_ = 2;
    float side_ = least_side;
};

/// Draws the description of the preset under the pointer, at a fixed place.
void about(const PresetNote* preset) {
    const std::string text = preset != nullptr
                                 ? fmt::format("{}: {}", preset->name, preset->about)
                                 : std::string("A click opens a preset; Ctrl+Z takes you back.");
    ImGui::TextWrapped("%s", text.c_str());
}

}  // namespace

void presets_panel(const PanelContext& context, std::string& search, const PresetPicture& picture) {
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::InputTextWithHint("##search", "search", &search);
    context.items.note("preset search");
    const std::vector<PresetNote> presets = presets_with(search);
    const float below = 2.0f * ImGui::GetTextLineHeightWithSpacing();
    const PresetNote* looked_at = nullptr;
    if (ImGui::BeginChild("tiles", {0.0f, -below})) {
        looked_at = Gallery(context, picture).show(presets);
        if (presets.empty()) ImGui::TextUnformatted("No preset is called so.");
    }
    ImGui::EndChild();
    about(looked_at);
}

}  // namespace burl
