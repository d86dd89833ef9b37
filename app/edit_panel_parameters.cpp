#include <imgui.h>

#include "app/edit_groups.h"
#include "app/edit_panels.h"
#include "app/edit_seed.h"
#include "app/edit_sliders.h"

namespace burl {

namespace {

void hand_over(const PanelContext& context, const RecipeLeaf& leaf, const ValueEdit& edit) {
    EditHistory& history = context.session.history();
    if (edit.began) history.begin_gesture();
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

void show(const PanelContext& context, const std::vector<RecipeLeaf>& leaves) {
    for (const RecipeLeaf& leaf : leaves) {
        hand_over(context, leaf, edit_leaf(leaf, context.items));
        if (leaf.label == "seed") seed_button(context, leaf);
    }
}

void show(const PanelContext& context, const ParameterGroup& group) {
    const std::string id = "##" + group.first.front().path;
    const ImGuiTreeNodeFlags flags =
        group.open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None;
    const bool open = ImGui::CollapsingHeader((group.title + id).c_str(), flags);
    context.items.note("group:" + group.name);
    if (!open) return;
    show(context, group.first);
    if (group.more.empty()) return;
    const bool more = ImGui::TreeNode(("more" + id).c_str());
    context.items.note("more:" + group.name);
    if (!more) return;
    show(context, group.more);
    ImGui::TreePop();
}

}  // namespace

void parameters_panel(const PanelContext& context) {
    const auto leaves = recipe_leaves(slider_json(context.session.recipe()));
    for (const ParameterGroup& group : parameter_groups(leaves)) show(context, group);
}

}  // namespace burl
