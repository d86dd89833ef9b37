#include "app/editor/panels/parameters.h"

#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>
#include <nlohmann/json.hpp>

#include "app/editor/session/groups.h"

namespace burl {

namespace {

const ImVec4 keyed_color(0.45f, 0.36f, 0.10f, 1.0f);  // background of animated numbers

/// Returns the path of the leaf's number that is being edited; empty where the leaf is no number.
std::string number_path(const RecipeLeaf& leaf, const ValueEdit& edit) {
    const ParameterType type = leaf.parameter->type;
    if (type == ParameterType::numbers) return fmt::format("{}.{}", leaf.path, edit.item);
    const bool number = type == ParameterType::number || type == ParameterType::integer;
    return number ? leaf.path : std::string();
}

bool is_keyed(const EditSession& session, const RecipeLeaf& leaf) {
    return std::ranges::any_of(session.recipe().animation.tracks, [&](const KeyTrack& track) {
        return track.path == leaf.path || track.path.starts_with(leaf.path + ".");
    });
}

void hand_over(const PanelContext& context, const RecipeLeaf& leaf, const ValueEdit& edit) {
    EditHistory& history = context.session.history();
    if (edit.began) history.begin_gesture();
    const std::string number = number_path(leaf, edit);
    if ((edit.began || edit.value) && !number.empty()) context.session.touch(number);
    if (edit.value) context.session.set(leaf.path, *edit.value);
    if (edit.ended) history.end_gesture();
}

void seed_button(const PanelContext& context, const RecipeLeaf& leaf) {
    ImGui::SameLine();
    if (ImGui::SmallButton(("new##" + leaf.path).c_str()))
        context.session.set(leaf.path, next_seed(leaf.value.get<std::uint64_t>()));
    context.items.note(leaf.path + ".new");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Another pattern of the same kind");
}

void show(const PanelContext& context, const ParameterGroup& group) {
    const std::string id = "##" + group.first.front().path;
    const ImGuiTreeNodeFlags flags =
        group.open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None;
    const bool open = ImGui::CollapsingHeader((group.title + id).c_str(), flags);
    context.items.note("group:" + group.name);
    if (!open) return;
    parameter_rows(context, group.first);
    if (group.more.empty()) return;
    const bool more = ImGui::TreeNode(("more" + id).c_str());
    context.items.note("more:" + group.name);
    if (!more) return;
    parameter_rows(context, group.more);
    ImGui::TreePop();
}

}  // namespace

void parameter_rows(const PanelContext& context, const std::vector<RecipeLeaf>& leaves) {
    for (const RecipeLeaf& leaf : leaves) {
        const bool keyed = is_keyed(context.session, leaf);
        if (keyed) ImGui::PushStyleColor(ImGuiCol_FrameBg, keyed_color);
        const ValueEdit edit = edit_leaf(leaf, parameter_label(leaf.label), context.items);
        if (keyed) ImGui::PopStyleColor();
        hand_over(context, leaf, edit);
        if (leaf.label == "seed") seed_button(context, leaf);
    }
}

void parameters_panel(const PanelContext& context, bool posed) {
    const Json recipe = slider_json(context.session.still());
    for (const ParameterGroup& group : parameter_groups(recipe_leaves(recipe), node_words(recipe)))
        if (posed || group.name != "pose") show(context, group);
}

}  // namespace burl
