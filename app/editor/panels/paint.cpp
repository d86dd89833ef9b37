#include "app/editor/panels/paint.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "app/editor/panels/keys.h"
#include "app/editor/panels/scale.h"
#include "app/editor/panels/tool_window.h"

namespace burl {

namespace {

constexpr float slider_width = 150.0f;

void slide(const PanelContext& context, const char* label, double& value, double low, double high,
           ImGuiSliderFlags flags = 0) {
    ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &low, &high, "%.3f",
                        flags | ImGuiSliderFlags_AlwaysClamp);
    context.items.note(fmt::format("paint.{}", label));
}

void modes(const PanelContext& context, PaintMode& mode) {
    if (ImGui::RadioButton("paint", mode == PaintMode::paint)) mode = PaintMode::paint;
    context.items.note("paint.paint");
    ImGui::SameLine();
    if (ImGui::RadioButton("erase", mode == PaintMode::erase)) mode = PaintMode::erase;
    context.items.note("paint.erase");
}

void color(const PanelContext& context, Rgb8& color) {
    std::array<float, 3> shown{float(color.r) / 255.0f, float(color.g) / 255.0f,
                               float(color.b) / 255.0f};
    if (ImGui::ColorEdit3("colour", shown.data())) {
        const auto code = [](float v) { return std::uint8_t(std::lround(255.0f * v)); };
        color = {code(shown[0]), code(shown[1]), code(shown[2])};
    }
    context.items.note("paint.colour");
}

}  // namespace

void clear_paint(EditSession& session) {
    Recipe recipe = session.recipe();
    recipe.paint.clear();
    session.history().end_gesture();
    session.history().change(std::move(recipe));
}

void paint_shortcuts(PaintTool& tool) {
    if (!tool.on) return;
    if (pressed("Comma")) tool = resized(tool, -1);
    if (pressed("Period")) tool = resized(tool, 1);
    if (pressed("X"))
        tool.brush.mode = tool.brush.mode == PaintMode::erase ? PaintMode::paint : PaintMode::erase;
}

void paint_panel(const PanelContext& context, PaintTool& tool, const ImVec2& low) {
    if (!tool.on) return;
    if (begin_tool_window("Paint (P)", tool.on, low)) {
        ImGui::PushItemWidth(slider_width * float(interface_scale()));
        modes(context, tool.brush.mode);
        slide(context, "radius", tool.brush.radius, least_brush_radius, largest_brush_radius,
              ImGuiSliderFlags_Logarithmic);
        slide(context, "hardness", tool.brush.hardness, 0.0, 1.0);
        slide(context, "opacity", tool.brush.opacity, 0.0, 1.0);
        color(context, tool.brush.color);
        ImGui::PopItemWidth();
        const std::size_t strokes = context.session.recipe().paint.size();
        ImGui::Text("%zu stroke%s", strokes, strokes == 1 ? "" : "s");
        ImGui::SameLine();
        if (ImGui::Button("Clear") && strokes > 0) clear_paint(context.session);
        context.items.note("paint.clear");
    }
    ImGui::End();
}

}  // namespace burl
