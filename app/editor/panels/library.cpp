#include "app/editor/panels/library.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "app/editor/widgets/icons.h"
#include "app/editor/widgets/theme.h"
#include "app/editor/widgets/widgets.h"
#include "app/recipe/material_notes.h"
#include "app/recipe/preset_notes.h"

namespace burl {

namespace {

// Sizes at interface scale 1.
constexpr float least_side = 92.0f;   // least width of a tile
constexpr float margin = 7.0f;        // between a tile's edge and its ball
constexpr float large_side = 256.0f;  // side of the ball in a tip
constexpr int picture_step = 128;     // sides of thumbnails are multiples of this

ImVec2 plus(const ImVec2& a, float x, float y) {
    return {a.x + x, a.y + y};
}

int picture_side(float width) {
    const float pixels = width * ImGui::GetIO().DisplayFramebufferScale.x;
    return int(std::ceil(pixels / float(picture_step))) * picture_step;
}

/// Returns "charred-wood" as people write it, "Charred wood".
std::string capital(std::string word) {
    std::ranges::replace(word, '-', ' ');
    if (!word.empty() && word[0] >= 'a' && word[0] <= 'z') word[0] = char(word[0] - 'a' + 'A');
    return word;
}

/// Tiles of recipes in rows.
class Gallery {
  public:
    Gallery(const PanelContext& context, std::set<std::string>& favourites,
            const PresetPicture& picture)
        : context_(context),
          favourites_(favourites),
          picture_(picture),
          scale_(float(interface_scale())) {
        const float wide = ImGui::GetContentRegionAvail().x;
        columns_ = std::max(2, int(wide / (least_side * scale_)));
        side_ = std::max(2.0f * scaled(margin) + 1.0f, std::floor(wide / float(columns_)));
    }

    /// Draws entries, with a heading above each category where there are `headings`.
    void show(const std::vector<LibraryEntry>& entries, bool headings) {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, scaled(4.0f)));
        int column = 0;
        for (std::size_t i = 0; i < entries.size(); ++i) {
            const bool begins = i == 0 || entries[i].category != entries[i - 1].category;
            if (begins && headings) heading(entries[i].category);
            if (begins && headings) column = 0;
            if (column++ % columns_ != 0) ImGui::SameLine();
            tile(entries[i]);
        }
        ImGui::PopStyleVar();
    }

  private:
    float scaled(float length) const { return length * scale_; }

    void heading(const std::string& category) const {
        ImGui::Dummy({1.0f, scaled(4.0f)});
        ImGui::PushFont(heading_font());
        ImGui::TextUnformatted(capital(category).c_str());
        ImGui::PopFont();
    }

    void tile(const LibraryEntry& entry) {
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const float line = ImGui::GetTextLineHeight(), high = side_ + line;
        const bool clicked = ImGui::InvisibleButton(entry.name.c_str(), {side_, high});
        context_.items.note("preset:" + entry.name);
        const bool seen = ImGui::IsItemVisible(), focused = ImGui::IsItemFocused();
        const bool near = ImGui::IsMouseHoveringRect(low, plus(low, side_, high));
        if (seen) {
            enlarged(entry);
            frame(low, plus(low, side_, high), entry.name == context_.session.recipe_path(),
                  near || focused);
            ball(entry.name, plus(low, scaled(margin), scaled(margin)),
                 side_ - 2.0f * scaled(margin));
            const std::string shown = shortened(capital(entry.name), side_ - scaled(6.0f));
            const float space = 0.5f * (side_ - ImGui::CalcTextSize(shown.c_str()).x);
            ImGui::GetWindowDrawList()->AddText(plus(low, space, side_ - scaled(3.0f)),
                                                ImGui::GetColorU32(ImGuiCol_Text), shown.c_str());
        }
        const bool starred = star(entry.name, low, near, clicked);
        if (clicked && !starred) context_.session.open_recipe(entry.name);
    }

    /// Draws the star in a tile's corner; a click there is no click on the tile. Returns whether it
    /// has taken a click on the tile.
    bool star(const std::string& name, const ImVec2& low, bool near, bool clicked) {
        const bool favourite = favourites_.contains(name);
        const float width = 1.4f * ImGui::GetFontSize();
        const ImVec2 corner = plus(low, side_ - width, 0.0f), end = plus(corner, width, width);
        if (ImGui::IsItemVisible())
            context_.items.note("favourite:" + name, {{corner.x, corner.y}, {end.x, end.y}});
        if (!favourite && !near) return false;
        const bool over = ImGui::IsMouseHoveringRect(corner, end);
        const char* sign = icon_or(favourite ? icon::star : icon::no_star, favourite ? "*" : "+");
        const ImVec2 size = ImGui::CalcTextSize(sign);
        ImGui::GetWindowDrawList()->AddText(
            plus(corner, 0.5f * (width - size.x), 0.5f * (width - size.y)),
            favourite || over ? palette().star : palette().quiet, sign);
        if (!over || !clicked) return false;
        if (favourite)
            favourites_.erase(name);
        else
            favourites_.insert(name);
        return true;
    }

    /// Tells about a tile on which the pointer rests, with a large ball; the open recipe's is the
    /// object itself.
    void enlarged(const LibraryEntry& entry) const {
        if (!begin_tip()) return;
        const float width = scaled(large_side);
        if (entry.name != context_.session.recipe_path()) {
            const ImVec2 low = ImGui::GetCursorScreenPos();
            ImGui::Dummy({width, width});
            context_.items.note("preset enlarged");
            ball(entry.name, low, width);
        }
        ImGui::PushTextWrapPos(width + ImGui::GetStyle().WindowPadding.x);
        ImGui::PushFont(heading_font());
        ImGui::TextUnformatted(capital(entry.name).c_str());
        ImGui::PopFont();
        ImGui::TextUnformatted(entry.about.c_str());
        ImGui::PopTextWrapPos();
        end_tip();
    }

    void frame(const ImVec2& low, const ImVec2& high, bool current, bool looked_at) const {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 from = plus(low, 1.0f, 1.0f), to = plus(high, -1.0f, -1.0f);
        const float rounding = scaled(6.0f);
        if (looked_at) list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
        if (current) list.AddRect(from, to, palette().accent, rounding, 0, 2.0f);
    }

    void ball(const std::string& name, const ImVec2& low, float width) const {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const int side = picture_side(width), small = picture_side(side_ - 2.0f * scaled(margin));
        ImTextureID picture = picture_(name, side);
        // A smaller thumbnail until the large one is ready.
        if (picture == nullptr && side != small) picture = picture_(name, small);
        if (picture != nullptr)
            list.AddImageRounded(picture, low, plus(low, width, width), {0.0f, 0.0f}, {1.0f, 1.0f},
                                 IM_COL32_WHITE, 0.5f * width);
        else
            list.AddCircleFilled(plus(low, 0.5f * width, 0.5f * width), 0.5f * width,
                                 ImGui::GetColorU32(ImGuiCol_FrameBg), 48);
    }

    const PanelContext& context_;
    std::set<std::string>& favourites_;
    const PresetPicture& picture_;
    const float scale_;
    int columns_ = 2;
    float side_ = least_side;
};

void search_row(const PanelContext& context, LibraryView& view) {
    const float star = ImGui::GetFrameHeight() + 2.0f * ImGui::GetStyle().FramePadding.x;
    ImGui::SetNextItemWidth(
        std::max(1.0f, ImGui::GetContentRegionAvail().x - star - ImGui::GetStyle().ItemSpacing.x));
    ImGui::InputTextWithHint("##search", "Search the library", &view.search);
    context.items.note("preset search");
    tip("Words of a name, a category or a sentence.");
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, view.favourites ? palette().star : palette().quiet);
    const std::string label =
        std::string(icon_or(view.favourites ? icon::star : icon::no_star, "*")) + "##favourites";
    if (ImGui::Button(label.c_str(), {star, 0.0f})) view.favourites = !view.favourites;
    ImGui::PopStyleColor();
    context.items.note("library favourites");
    tip("Favourites alone. A star in a picture's corner makes it one.");
}

/// Draws the categories as buttons, in as many lines as they need.
void category_rows(const PanelContext& context, LibraryView& view) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        ImVec2(0.5f * style.ItemSpacing.x, 0.5f * style.ItemSpacing.y));
    bool first = true;
    const auto choice = [&](const std::string& category) {
        const std::string label = category.empty() ? "All" : capital(category);
        const float width = ImGui::CalcTextSize(label.c_str()).x + 2.0f * style.FramePadding.x;
        if (!std::exchange(first, false)) {
            const float after = ImGui::GetItemRectMax().x + style.ItemSpacing.x + width;
            if (after < right) ImGui::SameLine();
        }
        const bool chosen = view.category == category;
        ImGui::PushStyleColor(ImGuiCol_Button, chosen ? palette().fill : 0);
        if (ImGui::Button(label.c_str())) view.category = category;
        ImGui::PopStyleColor();
        context.items.note("category:" + (category.empty() ? std::string("all") : category));
    };
    choice("");
    for (const std::string& category : library_categories()) choice(category);
    ImGui::PopStyleVar();
}

const char* nothing_found(const LibraryView& view) {
    if (view.favourites && view.search.empty())
        return "No favourites here yet: point at a picture and click the star in its corner.";
    return "Nothing in the library is called so.";
}

}  // namespace

std::vector<std::string> library_categories() {
    std::vector<std::string> categories;
    for (const MaterialNote& note : material_notes())
        if (categories.empty() || categories.back() != note.group) categories.push_back(note.group);
    categories.emplace_back(classics);
    return categories;
}

std::vector<LibraryEntry> library_entries(const LibraryView& view,
                                          const std::set<std::string>& favourites) {
    std::vector<LibraryEntry> all;
    for (const MaterialNote& note : material_notes())
        all.push_back({note.name, note.about, note.group});
    for (const PresetNote& note : preset_notes())
        all.push_back({std::string(note.name), std::string(note.about), classics});
    std::erase_if(all, [&](const LibraryEntry& entry) {
        const bool other = !view.category.empty() && entry.category != view.category;
        const bool found = holds_text(entry.name, view.search) ||
                           holds_text(entry.about, view.search) ||
                           holds_text(entry.category, view.search);
        return other || !found || (view.favourites && !favourites.contains(entry.name));
    });
    return all;
}

void library_panel(const PanelContext& context, LibraryView& view,
                   std::set<std::string>& favourites, const PresetPicture& picture) {
    search_row(context, view);
    category_rows(context, view);
    if (ImGui::BeginChild("tiles")) {
        const std::vector<LibraryEntry> entries = library_entries(view, favourites);
        Gallery(context, favourites, picture).show(entries, view.category.empty());
        if (entries.empty()) ImGui::TextWrapped("%s", nothing_found(view));
    }
    ImGui::EndChild();
}

}  // namespace burl
