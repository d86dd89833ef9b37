#include "app/editor/panels/leaf_widget.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>
#include <nlohmann/json.hpp>

#include "app/editor/panels/widgets.h"
#include "procedural/model/texture_json.h"

namespace burl {

namespace {

constexpr double narrow = 64.0;  // width of the widest range shown as a whole
// Reach of a wider range's slider to both sides of the default, in the parameter's steps.
constexpr double steps_about = 40;

void merge(ValueEdit& into, const ValueEdit& more) {
    if (more.began || more.value) into.item = more.item;
    into.began |= more.began;
    into.ended |= more.ended;
    if (more.value) into.value = more.value;
}

/// Returns whether a gesture on ImGui's last item begins or ends in this frame.
ValueEdit gesture() {
    ValueEdit edit;
    edit.began = ImGui::IsItemActivated();
    edit.ended = ImGui::IsItemDeactivated();
    return edit;
}

/// Shows the parameter's description while the pointer rests on ImGui's last item, its label: over
/// the slider it would cover the sliders below.
void tip(const RecipeLeaf& leaf) {
    if (!ImGui::IsItemHovered() || ImGui::IsItemActive()) return;
    const Parameter& parameter = *leaf.parameter;
    const auto named = [](const char* name, std::string_view value) {
        return value.empty() ? std::string() : fmt::format("{}{}", name, value);
    };
    const bool slides = parameter.type == ParameterType::number ||
                        parameter.type == ParameterType::integer ||
                        parameter.type == ParameterType::numbers;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(28.0f * ImGui::GetFontSize());
    ImGui::TextWrapped("%s",
                       fmt::format("{}{}", parameter.tip, named(", in ", parameter.unit)).c_str());
    ImGui::TextDisabled("%s",
                        (leaf.path + named(", by default ", parameter.default_value)).c_str());
    if (slides)
        ImGui::TextDisabled(
            "The slider: double-click for the default, Ctrl-click to type, Shift to drag finely.");
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/// Returns the default of the `item`-th number of a parameter; empty where it has none.
std::optional<double> default_of(const Parameter& parameter, std::size_t item) {
    const Json json = Json::parse(parameter.default_value, nullptr, false);
    if (json.is_number()) return json.get<double>();
    if (json.is_array() && item < json.size() && json[item].is_number())
        return json[item].get<double>();
    return {};
}

double snapped(const Parameter& parameter, double value) {
    const double inside = std::clamp(value, parameter.low, parameter.high);
    return parameter.type == ParameterType::integer ? std::round(inside) : inside;
}

ImGuiID left_id(const char* shown) {
    return ImGui::GetID(fmt::format("{} left", shown).c_str());
}

/// Returns the slider's range, which follows the value, except while the slider is dragged, when it
/// would run away from the pointer, and at the value last dragged to, when the handle would jump.
SliderRange held_range(const char* shown, const SliderRange& range, double value) {
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImGuiID low = ImGui::GetID(fmt::format("{} low", shown).c_str());
    const ImGuiID high = ImGui::GetID(fmt::format("{} high", shown).c_str());
    const float left = kept.GetFloat(left_id(shown), std::numeric_limits<float>::quiet_NaN());
    if (ImGui::GetActiveID() == ImGui::GetID(shown) || left == float(value))
        return {double(kept.GetFloat(low)), double(kept.GetFloat(high))};
    kept.SetFloat(low, float(range.low));
    kept.SetFloat(high, float(range.high));
    return range;
}

/// Returns a value moved by a share of its range.
double moved_by(double value, double share, const SliderRange& range, SliderScale scale) {
    if (scale == SliderScale::linear) return value + share * (range.high - range.low);
    return value * std::pow(range.high / range.low, share);
}

/// Draws a slider for one number, named `shown` for ImGui.
ValueEdit edit_number(const Parameter& parameter, std::size_t item, double value, const char* shown,
                      SliderScale scale) {
    const SliderRange range = held_range(shown, slider_range(parameter, value), value);
    const bool whole = parameter.type == ParameterType::integer;
    double moved = value;
    ImGui::SliderScalar(
        shown, ImGuiDataType_Double, &moved, &range.low, &range.high, whole ? "%.0f" : "%.4g",
        scale == SliderScale::linear ? ImGuiSliderFlags_None : ImGuiSliderFlags_Logarithmic);
    ValueEdit edit = gesture();
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive() && io.KeyShift && !io.KeyCtrl)
        moved = moved_by(value, 0.1 * double(io.MouseDelta.x) / double(ImGui::CalcItemWidth()),
                         range, scale);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
        moved = default_of(parameter, item).value_or(value);
        ImGui::ClearActiveID();  // keeps the slider from following the pointer again
        edit.began = edit.ended = true;
    }
    moved = snapped(parameter, moved);
    if (ImGui::IsItemActive() && moved >= range.low && moved <= range.high)
        ImGui::GetStateStorage()->SetFloat(left_id(shown), float(moved));
    if (moved != value) edit.value = whole ? Json(std::int64_t(moved)) : Json(moved);
    return edit;
}

ValueEdit edit_numbers(const RecipeLeaf& leaf, EditItems& items) {
    ValueEdit edit;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const std::size_t across = std::min<std::size_t>(leaf.value.size(), 4);
    const float width = (ImGui::CalcItemWidth() - gap * float(across - 1)) /
                        float(std::max<std::size_t>(across, 1));
    for (std::size_t i = 0; i < leaf.value.size(); ++i) {
        if (i % across != 0) ImGui::SameLine(0.0f, gap);
        ImGui::SetNextItemWidth(width);
        const std::string id = fmt::format("##{}.{}", leaf.path, i);
        const ValueEdit one = edit_number(*leaf.parameter, i, leaf.value[i].get<double>(),
                                          id.c_str(), SliderScale::linear);
        items.note(fmt::format("{}.{}", leaf.path, i));
        ValueEdit all = one;
        all.item = i;
        if (one.value) {
            all.value = leaf.value;
            (*all.value)[i] = *one.value;
        }
        merge(edit, all);
    }
    return edit;
}

ValueEdit edit_choice(const RecipeLeaf& leaf, EditItems& items, const char* id) {
    ValueEdit edit;
    const std::string now = leaf.value.is_string() ? leaf.value.get<std::string>() : "";
    const bool open = ImGui::BeginCombo(id, now.c_str());
    items.note(leaf.path);
    if (!open) return edit;
    for (const std::string_view choice : split_choices(leaf.parameter->choices)) {
        const std::string word(choice);
        if (ImGui::Selectable(word.c_str(), word == now) && word != now) edit.value = word;
        items.note(fmt::format("{}={}", leaf.path, word));
    }
    ImGui::EndCombo();
    return edit;
}

ValueEdit edit_hex(const RecipeLeaf& leaf, const char* id) {
    const std::string hex = leaf.value.get<std::string>();
    Rgb8 color = color_from_hex(hex);
    std::uint8_t alpha = alpha_from_hex(hex);
    const bool changed =
        leaf.parameter->alpha ? edit_color(id, color, alpha) : edit_color(id, color);
    ValueEdit edit = gesture();
    if (changed) edit.value = color_to_hex(color, alpha);
    return edit;
}

ValueEdit edit_text(const RecipeLeaf& leaf, const char* id) {
    std::string text = leaf.value.get<std::string>();
    const bool changed = ImGui::InputText(id, &text);
    ValueEdit edit = gesture();
    if (changed) edit.value = text;
    return edit;
}

}  // namespace

SliderRange slider_range(const Parameter& parameter, double value) {
    SliderRange range{parameter.low, parameter.high};
    if (range.high - range.low > narrow) {
        const double middle = default_of(parameter, 0).value_or(0.0);
        const double reach = steps_about * parameter.step;
        range = {std::max(parameter.low, middle - reach), std::min(parameter.high, middle + reach)};
    }
    // A value outside the range gets room on both sides, so that it can be moved either way.
    const double room = std::abs(value);
    if (value < range.low) range.low = std::max(parameter.low, value - room);
    if (value > range.high) range.high = std::min(parameter.high, value + room);
    return range;
}

ValueEdit edit_leaf(const RecipeLeaf& leaf, const std::string& label, EditItems& items,
                    SliderScale scale) {
    const std::string id = "##" + leaf.path;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.62f);
    ValueEdit edit;
    switch (leaf.parameter->type) {
        case ParameterType::number:
        case ParameterType::integer:
            edit = edit_number(*leaf.parameter, 0, leaf.value.get<double>(), id.c_str(), scale);
            items.note(leaf.path);
            break;
        case ParameterType::numbers:
            ImGui::BeginGroup();
            edit = edit_numbers(leaf, items);
            ImGui::EndGroup();
            break;
        case ParameterType::choice:
            edit = edit_choice(leaf, items, id.c_str());
            break;
        case ParameterType::color:
            edit = edit_hex(leaf, id.c_str());
            items.note(leaf.path);
            break;
        case ParameterType::text:
            edit = edit_text(leaf, id.c_str());
            items.note(leaf.path);
            break;
    }
    ImGui::SameLine();
    ImGui::TextUnformatted(label.c_str());
    tip(leaf);
    return edit;
}

}  // namespace burl
