#include "app/editor/graph/search.h"

#include <algorithm>
#include <utility>

#include <imgui_stdlib.h>

#include "app/edit/node_kinds.h"
#include "app/editor/widgets/keys.h"
#include "app/editor/widgets/widgets.h"

namespace burl {

namespace {

constexpr float box_width = 420.0f, box_height = 300.0f;  // at interface scale 1

/// The text behind the first word, which has the settings of a new node.
std::string settings_of(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return "";
    const std::size_t blank = text.rfind(' ', equals);
    return blank == std::string::npos ? "" : text.substr(blank);
}

}  // namespace

void GraphSearch::open(Wish wish, std::string title, const ImVec2& at) {
    wish_ = std::move(wish);
    title_ = std::move(title);
    at_ = at;
    text_.clear();
    marked_ = 0;
    open_ = begins_ = true;
}

std::vector<GraphSearch::Row> GraphSearch::rows() const {
    std::vector<Row> found;
    for (const std::string& name : wish_.names)
        if (spoken(name).find(text_) != std::string::npos || name.find(text_) != std::string::npos)
            found.push_back({name, "connect this name", true});
    const std::size_t names = text_.empty() ? 0 : found.size();
    std::vector<Row> nodes;
    for (const NodeType* type : nodes_with(text_)) {
        if (wish_.purpose == Purpose::after && type->inputs().empty()) continue;
        nodes.push_back({std::string(type->name), std::string(type->text)});
    }
    // A search finds names first; the whole table has them last.
    found.insert(found.begin() + std::ptrdiff_t(names), nodes.begin(), nodes.end());
    return found;
}

GraphSearch::Choice GraphSearch::choice(const Row& row) const {
    return {wish_, row.is_name ? row.name : row.name + settings_of(text_), row.is_name};
}

std::optional<GraphSearch::Choice> GraphSearch::list(EditItems& items,
                                                     const std::vector<Row>& found, bool entered) {
    std::optional<Choice> chosen;
    for (std::size_t i = 0; i < found.size(); ++i) {
        ImGui::PushID(int(i));
        const bool clicked = ImGui::Selectable("##row", i == marked_);
        items.note("graph found:" + found[i].name);
        if (i == marked_ && (pressed("Up") || pressed("Down"))) ImGui::SetScrollHereY(0.5f);
        ImGui::SameLine(0.0f, 0.0f);
        ImGui::TextUnformatted(spoken(found[i].name).c_str());
        ImGui::SameLine(9.0f * ImGui::GetFontSize());
        ImGui::TextDisabled("%s", found[i].about.c_str());
        ImGui::PopID();
        if (clicked || (entered && i == marked_)) chosen = choice(found[i]);
    }
    if (found.empty()) ImGui::TextDisabled("No node is called so.");
    return chosen;
}

std::optional<GraphSearch::Choice> GraphSearch::show(EditItems& items) {
    if (!open_) return {};
    const float scale = float(interface_scale());
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImVec2 size{std::min(box_width * scale, display.x),
                      std::min(box_height * scale, display.y)};
    ImGui::SetNextWindowPos(
        {std::clamp(at_.x, 0.0f, display.x - size.x), std::clamp(at_.y, 0.0f, display.y - size.y)});
    ImGui::SetNextWindowSize(size);
    ImGui::SetNextWindowBgAlpha(1.0f);
    if (begins_) ImGui::SetNextWindowFocus();
    std::optional<Choice> chosen;
    if (ImGui::Begin("##search", nullptr, fixed_window & ~ImGuiWindowFlags_NoBringToFrontOnFocus)) {
        ImGui::TextUnformatted(title_.c_str());
        if (begins_) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(-1.0f);
        const std::string before = text_;
        const bool entered = ImGui::InputTextWithHint("##text", "name, settings (octaves=2)",
                                                      &text_, ImGuiInputTextFlags_EnterReturnsTrue);
        items.note("graph search");
        const std::vector<Row> found = rows();
        if (text_ != before) marked_ = 0;
        if (pressed("Down")) ++marked_;
        if (pressed("Up") && marked_ > 0) --marked_;
        marked_ = std::min(marked_, found.empty() ? 0 : found.size() - 1);
        if (ImGui::BeginChild("found")) chosen = list(items, found, entered);
        ImGui::EndChild();
        if (!begins_ && !ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows))
            open_ = false;
    }
    ImGui::End();
    begins_ = false;
    if (chosen || pressed("Escape")) open_ = false;
    return chosen;
}

}  // namespace burl
