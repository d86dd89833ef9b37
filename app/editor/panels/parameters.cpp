#include "app/editor/panels/parameters.h"

#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "app/editor/session/groups.h"
#include "app/editor/widgets/widgets.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

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

constexpr const char* seed_label = "another";

float seed_room() {
    const ImGuiStyle& style = ImGui::GetStyle();
    return ImGui::CalcTextSize(seed_label).x + 2.0f * style.FramePadding.x + style.ItemSpacing.x;
}

void seed_button(const PanelContext& context, const RecipeLeaf& leaf) {
    ImGui::SameLine();
    if (ImGui::Button(fmt::format("{}##{}", seed_label, leaf.path).c_str()))
        context.session.set(leaf.path, next_seed(leaf.value.get<std::uint64_t>()));
    context.items.note(leaf.path + ".new");
    tip("Another pattern of the same kind.");
}

/// The leaves of a panel, and what the recipe was opened with.
struct Shown {
    const PanelContext& context;
    std::vector<RecipeLeaf> opened{};

    void show(const std::vector<RecipeLeaf>& leaves) const {
        for (const RecipeLeaf& leaf : leaves) row(leaf);
    }

    void group(const ParameterGroup& group, bool begins_open) const {
        const std::string id = "##" + group.first.front().path;
        const bool open = begin_section(context.items, group.title + id, "group:" + group.name,
                                        begins_open && group.open);
        if (!open) return;
        show(group.first);
        if (group.more.empty()) return;
        const bool more = ImGui::TreeNode(("more" + id).c_str());
        context.items.note("more:" + group.name);
        if (!more) return;
        show(group.more);
        ImGui::TreePop();
    }

  private:
    void row(const RecipeLeaf& leaf) const {
        const bool keyed = is_keyed(context.session, leaf), seed = leaf.label == "seed";
        const auto same = std::ranges::find(opened, leaf.path, &RecipeLeaf::path);
        const LeafRow row{parameter_label(leaf.label), SliderScale::linear,
                          same == opened.end() ? nullptr : &same->value, seed ? seed_room() : 0.0f};
        if (keyed) ImGui::PushStyleColor(ImGuiCol_FrameBg, palette().keyed);
        const ValueEdit edit = edit_leaf(leaf, row, context.items);
        if (keyed) ImGui::PopStyleColor();
        hand_over(context, leaf, edit);
        if (seed) seed_button(context, leaf);
    }
};

/// Finds out what the recipe was opened with for the only gesture that asks for it.
Shown shown_in(const PanelContext& context) {
    Shown shown{context};
    if (ImGui::IsMouseDoubleClicked(0))
        shown.opened = recipe_leaves(slider_json(context.session.history().opened()));
    return shown;
}

}  // namespace

void parameter_rows(const PanelContext& context, const std::vector<RecipeLeaf>& leaves) {
    shown_in(context).show(leaves);
}

void parameters_panel(const PanelContext& context, bool posed) {
    const Shown shown = shown_in(context);
    // A material's controls are the knobs; what they set is there for those who want it.
    const bool knobs = !context.session.recipe().controls.empty();
    const Json recipe = slider_json(context.session.still());
    const auto groups = parameter_groups(recipe_leaves(recipe), node_words(recipe));
    // Whoever opens a pose wants its weight next.
    for (const ParameterGroup& group : groups)
        if (posed && group.name == "pose") shown.group(group, true);
    for (const ParameterGroup& group : groups)
        if (group.name != "pose") shown.group(group, !knobs || group.name == "solid");
}

}  // namespace burl
