#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "app/editor/panels/panels.h"
#include "app/editor/widgets/leaf_widget.h"
#include "app/editor/widgets/widgets.h"
#include "app/recipe/edit/controls.h"
#include "app/recipe/edit/leaves.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

constexpr double slider_steps = 40;  // as many to both sides of zero reach the whole range

/// The changes that a control makes, for the tip of its name.
std::string control_tip(const RecipeControl& control) {
    return fmt::format("{}{}sets {}", control.about, control.about.empty() ? "" : "; ",
                       fmt::join(control.sets, ", "));
}

/// The value that the control had when the recipe was opened, as a default; empty for a control
/// that the recipe did not have then.
std::string opened_value(const EditSession& session, const std::string& name) {
    const auto states = control_states(slider_json(session.history().opened()));
    const auto found = std::ranges::find(
        states, name, [](const ControlState& state) { return state.control.name; });
    return found == states.end() ? "" : found->value.dump();
}

/// The parameter that a slider of the control's range needs. Its texts must outlive it.
Parameter slider_of(const ControlState& state, const std::string& tip, const std::string& opened) {
    Parameter parameter;
    parameter.path = state.control.name;
    parameter.default_value = opened;
    parameter.tip = tip;
    parameter.type = state.value.is_string() ? ParameterType::color
                     : state.whole           ? ParameterType::integer
                                             : ParameterType::number;
    if (!state.control.range) return parameter;
    parameter.low = (*state.control.range)[0];
    parameter.high = (*state.control.range)[1];
    const double reach = std::max(std::abs(parameter.low), std::abs(parameter.high));
    parameter.step = 2.0 * reach / slider_steps;
    return parameter;
}

/// A range over orders of magnitude has a slider that reaches the small values, too.
SliderScale scale_of(const RecipeControl& control) {
    constexpr double wide = 30;
    const bool orders = control.range && (*control.range)[0] > 0.0 &&
                        (*control.range)[1] > wide * (*control.range)[0];
    return orders ? SliderScale::logarithmic : SliderScale::linear;
}

void show_control(const PanelContext& context, const ControlState& state) {
    EditHistory& history = context.session.history();
    const std::string tip = control_tip(state.control);
    const bool wanted = ImGui::IsMouseDoubleClicked(0);  // the only one who asks for the default
    const std::string opened = wanted ? opened_value(context.session, state.control.name) : "";
    const RecipeLeaf leaf{state.control.name, "controls", state.control.name,
                          std::make_shared<const Parameter>(slider_of(state, tip, opened)),
                          state.value};
    const ValueEdit edit =
        edit_leaf(leaf, {state.control.name, scale_of(state.control)}, context.items);
    if (edit.began) history.begin_gesture();
    if ((edit.began || edit.value) && !state.value.is_string()) context.session.touch(state.path);
    if (edit.value) context.session.set(state.control.name, *edit.value);
    if (edit.ended) history.end_gesture();
}

}  // namespace

void recipe_heading(const Recipe& recipe) {
    ImGui::PushFont(heading_font());
    ImGui::TextWrapped("%s", recipe.name.c_str());
    ImGui::PopFont();
    if (recipe.about.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, palette().quiet);
    ImGui::TextWrapped("%s", recipe.about.c_str());
    ImGui::PopStyleColor();
}

void controls_panel(const PanelContext& context) {
    if (context.session.recipe().controls.empty()) return;
    const std::vector<ControlState> states = control_states(slider_json(context.session.still()));
    if (!begin_section(context.items, "Controls", "group:controls", true)) return;
    for (const ControlState& state : states) show_control(context, state);
}

}  // namespace burl
