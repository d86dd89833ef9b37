// The tree beside the graph's canvas, for keyboards: what the canvas shows, line by line (graph.h).
#include <algorithm>

#include <fmt/format.h>

#include "app/edit/node_kinds.h"
#include "app/editor/graph/graph.h"
#include "app/editor/widgets/widgets.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

std::string constant_words(const Json& value) {
    return value.is_number() ? fmt::format("{:.4g}", value.get<double>())
                             : value.get<std::string>();
}

/// The name or kind of a node, behind what it is an input of.
std::string kind_words(const GraphNodeView& node) {
    return node.name.empty() ? spoken(node.type) : spoken(node.name);
}

}  // namespace

/// Draws a row and, unless it is folded, those of the inputs below it.
void EditGraph::tree_row(EditItems& items, const std::string& place, const std::string& words,
                         int depth) {
    rows_.push_back(place);
    const NodeGraph& graph = model_.graph();
    const auto node = graph.find(place);
    const bool folded = std::ranges::count(folded_, place) > 0;
    const bool has_rows = node && !graph.nodes[*node].inputs.empty();
    const float indent = 0.9f * ImGui::GetFontSize() * float(depth);
    ImGui::PushID(place.c_str());
    const ImVec2 low = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable("##row", model_.is_chosen(place))) {
        const float arrow = low.x + indent + ImGui::GetFontSize();
        if (has_rows && ImGui::GetIO().MousePos.x < arrow)
            folded ? (void)std::erase(folded_, place) : folded_.push_back(place);
        if (ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl)
            model_.toggle(place);
        else
            model_.choose(place);
        show_chosen_ = true;
    }
    items.note("tree:" + place);
    if (model_.current() == place && scroll_to_row_) ImGui::SetScrollHereY(0.5f);
    ImGui::PopID();
    const char* arrow = !has_rows ? "" : folded ? "+" : "-";
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText({low.x + 4.0f + indent, low.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled), arrow);
    list.AddText({low.x + 4.0f + indent + ImGui::GetFontSize(), low.y},
                 ImGui::GetColorU32(node ? ImGuiCol_Text : ImGuiCol_TextDisabled), words.c_str());
    if (!node || folded) return;
    for (const GraphInput& input : graph.nodes[*node].inputs) input_row(items, input, depth + 1);
}

void EditGraph::input_row(EditItems& items, const GraphInput& input, int depth) {
    const NodeGraph& graph = model_.graph();
    std::string words = input.words + ": ";
    if (input.from)
        words += (input.by_name ? "> " : "") + kind_words(graph.nodes[*input.from]);
    else if (!input.constant.is_null())
        words += constant_words(input.constant);
    tree_row(items, input.place, words, depth);
}

void EditGraph::tree(EditItems& items) {
    const NodeGraph& graph = model_.graph();
    rows_.clear();
    if (graph.nodes.empty()) return;
    for (const GraphInput& input : graph.nodes[0].inputs) input_row(items, input, 0);
    for (const GraphNodeView& node : graph.nodes)
        if (!node.name.empty())
            tree_row(items, node.place, fmt::format("{}: {}", spoken(node.name), spoken(node.type)),
                     0);
    scroll_to_row_ = false;
}

/// Chooses the row `by` rows below the one chosen last.
void EditGraph::step_tree(int by) {
    if (rows_.empty()) return;
    const auto found = std::ranges::find(rows_, model_.current());
    auto row = found == rows_.end() ? (by > 0 ? 0 : int(rows_.size()) - 1)
                                    : int(found - rows_.begin()) + by;
    row = std::clamp(row, 0, int(rows_.size()) - 1);
    model_.choose(rows_[std::size_t(row)]);
    show_chosen_ = scroll_to_row_ = true;
}

/// Unfolds the row chosen last, or goes to its first input; or folds it, or goes to its owner.
void EditGraph::fold(bool open) {
    const std::string place = model_.current();
    const auto node = model_.graph().find(place);
    const bool folded = std::ranges::count(folded_, place) > 0;
    const bool has_rows = node && !model_.graph().nodes[*node].inputs.empty();
    if (open && folded)
        std::erase(folded_, place);
    else if (open && has_rows)
        step_tree(1);
    else if (!open && has_rows && !folded)
        folded_.push_back(place);
    else if (const auto owner = model_.owner_of(place); !open && owner && *owner > 0)
        model_.choose(model_.graph().nodes[*owner].place);
    show_chosen_ = scroll_to_row_ = true;
}

}  // namespace burl
