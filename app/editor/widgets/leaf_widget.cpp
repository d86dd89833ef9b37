#include "app/editor/widgets/leaf_widget.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "app/editor/widgets/widgets.h"
#include "atlas/base/json.h"
#include "procedural/model/texture_json.h"

namespace burl {

namespace {

constexpr double narrow = 64.0;  // width of the widest range shown as a whole
// Reach of a wider range's slider to both sides of the default, in the parameter's steps.
constexpr double steps_about = 40;
constexpr double most_widened = 4.0;  // of a range that stays where a slider was left

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

/// Tells what a parameter means while the pointer rests on ImGui's last item.
void leaf_tip(const RecipeLeaf& leaf) {
    if (!begin_tip()) return;
    const Parameter& parameter = *leaf.parameter;
    const auto named = [](const char* name, std::string_view value) {
        return value.empty() ? std::string() : fmt::format("{}{}", name, value);
    };
    const bool slides = parameter.type == ParameterType::number ||
                        parameter.type == ParameterType::integer ||
                        parameter.type == ParameterType::numbers;
    ImGui::TextUnformatted(
        fmt::format("{}{}", parameter.tip, named(", in ", parameter.unit)).c_str());
    ImGui::TextDisabled("%s",
                        (leaf.path + named(", by default ", parameter.default_value)).c_str());
    if (slides)
        ImGui::TextDisabled(
            "Double-click: as it was opened, again: the default. Ctrl-click: type. Shift: drag "
            "finely.");
    end_tip();
}

std::optional<double> number_in(const Json& json, std::size_t item) {
    if (json.is_number()) return json.get<double>();
    if (json.is_array() && item < json.size() && json[item].is_number())
        return json[item].get<double>();
    return {};
}

/// Returns the default of the `item`-th number of a parameter; empty where it has none.
std::optional<double> default_of(const Parameter& parameter, std::size_t item) {
    return number_in(Json::parse(parameter.default_value, nullptr, false), item);
}

/// Returns what a number goes back to: what it was opened as, and from there its default.
double resting_value(const Parameter& parameter, const Json* opened, std::size_t item,
                     double value) {
    const auto first = opened ? number_in(*opened, item) : std::nullopt;
    // Values are compared as they are kept between the clicks.
    const bool there = first && float(*first) == float(value);
    return first && !there ? *first : default_of(parameter, item).value_or(value);
}

SliderRange usual_range(const Parameter& parameter) {
    if (parameter.high - parameter.low <= narrow) return {parameter.low, parameter.high};
    const double middle = default_of(parameter, 0).value_or(0.0);
    const double reach = steps_about * parameter.step;
    return {std::max(parameter.low, middle - reach), std::min(parameter.high, middle + reach)};
}

double snapped(const Parameter& parameter, double value) {
    const double inside = std::clamp(value, parameter.low, parameter.high);
    return parameter.type == ParameterType::integer ? std::round(inside) : inside;
}

/// Returns the slider's range, which follows the value, except while the slider is dragged, when it
/// would run away from the pointer, and at a value that was dragged to, when the handle would jump;
/// but back at a usual value a range that a typed number made huge is the usual one again.
SliderRange held_range(const char* shown, const Parameter& parameter, double value) {
    const SliderRange range = slider_range(parameter, value), usual = usual_range(parameter);
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const auto id = [&](const char* what) {
        return ImGui::GetID(fmt::format("{} {}", shown, what).c_str());
    };
    const SliderRange held{double(kept.GetFloat(id("low"))), double(kept.GetFloat(id("high")))};
    const bool huge = held.high - held.low > most_widened * (usual.high - usual.low);
    const bool beyond = value < usual.low || value > usual.high;
    const float left = kept.GetFloat(id("left"), std::numeric_limits<float>::quiet_NaN());
    if (ImGui::GetActiveID() == ImGui::GetID(shown)) {
        kept.SetFloat(id("left"), float(value));
        return held;
    }
    if (left == float(value) && (beyond || !huge)) return held;
    kept.SetFloat(id("low"), float(range.low));
    kept.SetFloat(id("high"), float(range.high));
    return range;
}

/// Returns the value before the first click of a double click, which moves the slider itself.
double value_clicked(const char* shown, double value, bool began) {
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID(fmt::format("{} clicked", shown).c_str());
    if (began && !ImGui::IsMouseDoubleClicked(0)) kept.SetFloat(id, float(value));
    return double(kept.GetFloat(id));
}

/// Draws a slider for one number, named `shown` for ImGui.
ValueEdit edit_number(const Parameter& parameter, std::size_t item, double value, const char* shown,
                      const LeafRow& row) {
    const SliderRange range = held_range(shown, parameter, value);
    const bool whole = parameter.type == ParameterType::integer;
    double moved = value;
    slide(shown, moved, range, row.scale, whole ? "%.0f" : "%.4g");
    ValueEdit edit = gesture();
    const double clicked = value_clicked(shown, value, edit.began);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
        moved = resting_value(parameter, row.opened, item, clicked);
        ImGui::ClearActiveID();  // keeps the slider from following the pointer again
        edit.began = edit.ended = true;
    }
    moved = snapped(parameter, moved);
    if (moved != value) edit.value = whole ? Json(std::int64_t(moved)) : Json(moved);
    return edit;
}

ValueEdit edit_numbers(const RecipeLeaf& leaf, const LeafRow& row, EditItems& items) {
    ValueEdit edit;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const std::size_t across = std::min<std::size_t>(leaf.value.size(), 4);
    const float width = (ImGui::CalcItemWidth() - gap * float(across - 1)) /
                        float(std::max<std::size_t>(across, 1));
    for (std::size_t i = 0; i < leaf.value.size(); ++i) {
        if (i % across != 0) ImGui::SameLine(0.0f, gap);
        ImGui::SetNextItemWidth(width);
        const std::string id = fmt::format("##{}.{}", leaf.path, i);
        const ValueEdit one =
            edit_number(*leaf.parameter, i, leaf.value[i].get<double>(), id.c_str(), row);
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

/// Draws the widget of a leaf without its name.
ValueEdit edit_value(const RecipeLeaf& leaf, const LeafRow& row, EditItems& items) {
    const std::string id = "##" + leaf.path;
    ValueEdit edit;
    switch (leaf.parameter->type) {
        case ParameterType::number:
        case ParameterType::integer:
            edit = edit_number(*leaf.parameter, 0, leaf.value.get<double>(), id.c_str(), row);
            break;
        case ParameterType::numbers:
            ImGui::BeginGroup();
            edit = edit_numbers(leaf, row, items);
            ImGui::EndGroup();
            return edit;
        case ParameterType::choice:
            return edit_choice(leaf, items, id.c_str());
        case ParameterType::color:
            edit = edit_hex(leaf, id.c_str());
            break;
        case ParameterType::text:
            edit = edit_text(leaf, id.c_str());
            break;
    }
    items.note(leaf.path);
    return edit;
}

}  // namespace

SliderRange slider_range(const Parameter& parameter, double value) {
    SliderRange range = usual_range(parameter);
    // A value outside the range gets room on both sides, so that it can be moved either way.
    const double room = std::abs(value);
    if (value < range.low) range.low = std::max(parameter.low, value - room);
    if (value > range.high) range.high = std::min(parameter.high, value + room);
    return range;
}

ValueEdit edit_leaf(const RecipeLeaf& leaf, const LeafRow& row, EditItems& items) {
    begin_row(row.label, leaf.path, row.room);
    leaf_tip(leaf);
    ValueEdit edit = edit_value(leaf, row, items);
    leaf_tip(leaf);
    return edit;
}

}  // namespace burl
