#include <algorithm>

#include "app/edit_panels.h"
#include "app/edit_sliders.h"

namespace burl {

namespace {

/// Groups that few people want to see first.
bool begins_closed(const std::string& group) {
    return group == "recipe" || group == "atlas" || group == "filter" || group == "precision" ||
           group.ends_with("quadric");
}

void hand_over(const PanelContext& context, const RecipeLeaf& leaf, const ValueEdit& edit) {
    EditHistory& history = context.session.history();
    if (edit.began) history.begin_gesture();
    if (edit.value) context.session.set(leaf.path, *edit.value);
    if (edit.ended) history.end_gesture();
}

void seed_button(const PanelContext& context, const RecipeLeaf& leaf) {
    ImGui::SameLine();
    if (ImGui::SmallButton(("next##" + leaf.path).c_str()))
        context.session.set(leaf.path, (leaf.value.get<std::uint64_t>() + 1) % 4294967296U);
    context.items.note(leaf.path + ".next");
}

}  // namespace

void parameters_panel(const PanelContext& context) {
    const std::vector<RecipeLeaf> leaves = recipe_leaves(slider_json(context.session.recipe()));
    for (std::size_t first = 0; first < leaves.size();) {
        std::size_t last = first;
        while (last < leaves.size() && leaves[last].group == leaves[first].group) ++last;
        const std::string& group = leaves[first].group;
        const ImGuiTreeNodeFlags flags =
            begins_closed(group) ? ImGuiTreeNodeFlags_None : ImGuiTreeNodeFlags_DefaultOpen;
        const std::string title = group + "##" + leaves[first].path;
        const bool open = ImGui::CollapsingHeader(title.c_str(), flags);
        context.items.note("group:" + group);
        for (std::size_t i = first; open && i < last; ++i) {
            const RecipeLeaf& leaf = leaves[i];
            hand_over(context, leaf, edit_leaf(leaf, context.items));
            if (leaf.label == "seed") seed_button(context, leaf);
        }
        first = last;
    }
}

}  // namespace burl
