#include "app/editor/panels/atlas.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/editor/widgets/flow.h"
#include "app/editor/widgets/slider.h"
#include "app/editor/widgets/widgets.h"
#include "app/image/image_diff.h"
#include "app/measure/metrics_pictures.h"
#include "procedural/color/srgb.h"

namespace burl {

namespace {

ImU32 color32(const Rgb8& c) {
    return IM_COL32(c.r, c.g, c.b, 255);
}

ImU32 color32(const Vec3d& linear) {
    const auto code = [](double v) {
        return std::uint8_t(std::lround(255.0 * srgb_encode(std::clamp(v, 0.0, 1.0))));
    };
    return color32(Rgb8{code(linear.x), code(linear.y), code(linear.z)});
}

/// Draws a colour ramp before the text that follows on the same line.
template <class Color>
void ramp(const Color& color) {
    constexpr int steps = 32;
    const float height = ImGui::GetTextLineHeight(), width = 5.0f * height;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    for (int k = 0; k < steps; ++k) {
        const float left = low.x + width * float(k) / steps;
        ImGui::GetWindowDrawList()->AddRectFilled(
            {left, low.y}, {low.x + width * float(k + 1) / steps, low.y + height},
            color((k + 0.5) / steps));
    }
    ImGui::Dummy({width, height});
    ImGui::SameLine();
}

/// Sentences about the atlas's modes, in the order of SheetMode.
constexpr std::array mode_sentences{
    "The texture that the object is drawn with.",
    "The texels' solid coordinates: x, y, z as red, green, blue.",
    "A colour for each chart, a piece of the surface that lies together.",
    "Each triangle's share of texels against the mean, blue fewer, red more.",
    "The difference from the recipe in float64, in 8-bit codes.",
};
static_assert(mode_sentences.size() == sheet_mode_names.size());

void scale_legend() {
    ImGui::TextUnformatted("1/2");
    ImGui::SameLine();
    ramp([](double t) { return color32(scale_color(std::exp2(2.0 * t - 1.0))); });
    ImGui::TextUnformatted("2 times the mean");
}

void error_legend(const SheetPicture& picture, bool late) {
    if (!picture.problem.empty()) {
        ImGui::TextUnformatted("no float64 reference of this recipe");
        return;
    }
    ramp([](double t) { return color32(false_color(t)); });
    ImGui::Text("0 to %g codes", error_scale(picture.largest));
    if (late)
        ImGui::TextDisabled("the slider moves ...");
    else
        ImGui::Text("max %.3f, RMS %.3f, rounding 0.5", picture.largest, picture.rms);
}

/// Chooses the mode by buttons in at most two lines, or from a list where they need more.
void mode_choice(const PanelContext& context, SheetMode& mode) {
    std::vector<float> widths;
    for (const std::string_view name : sheet_mode_names)
        widths.push_back(ImGui::CalcTextSize(std::string(name).c_str()).x +
                         ImGui::GetFrameHeight() + 2.0f * ImGui::GetStyle().ItemInnerSpacing.x);
    const bool listed = Flow::lines(widths, ImGui::GetContentRegionAvail().x) > 2;
    Flow flow(widths);
    if (listed) ImGui::SetNextItemWidth(-1.0f);
    const std::string now(sheet_mode_names[std::size_t(mode)]);
    const bool open = !listed || ImGui::BeginCombo("##mode", now.c_str());
    if (listed) context.items.note("atlas mode");
    for (std::size_t k = 0; open && k < sheet_mode_names.size(); ++k) {
        const std::string name(sheet_mode_names[k]), item = "atlas mode " + name;
        const bool on = mode == SheetMode(k);
        if (!listed) flow.next();
        if (listed ? ImGui::Selectable(name.c_str(), on)
                   : radio_button(context.items, name.c_str(), item, on))
            mode = SheetMode(k);
        if (listed) context.items.note(item);
        tip(mode_sentences[k]);
    }
    if (listed && open) ImGui::EndCombo();
}

/// Draws a quiet line, shortened where the panel is narrow; its tip has all of it.
void quiet_line(const char* text) {
    ImGui::TextDisabled("%s", shortened(text, ImGui::GetContentRegionAvail().x).c_str());
    tip(text);
}

}  // namespace

void atlas_controls(const PanelContext& context, AtlasViewState& state, int coarsest) {
    mode_choice(context, state.mode);
    state.level = std::clamp(state.level, 0, coarsest);
    begin_row("MIP level", "atlas");
    double level = state.level;
    slide("##MIP level", level, {0.0, double(std::max(coarsest, 1))}, SliderScale::linear, "%.0f");
    state.level = std::clamp(int(std::lround(level)), 0, coarsest);
    context.items.note("atlas level");
    tip("The finest MIP level that is shown; 0 is the texture itself.");
}

void atlas_legend(SheetMode mode, const SheetPicture* picture, bool late) {
    if (mode == SheetMode::texture)
        quiet_line("the texture as it lies in its atlas");
    else if (!picture)
        quiet_line("at work ...");
    else if (mode == SheetMode::solid)
        quiet_line("x, y, z of the solid as red, green, blue");
    else if (mode == SheetMode::charts)
        quiet_line("a colour for each chart");
    else if (mode == SheetMode::scale)
        scale_legend();
    else
        error_legend(*picture, late);
}

void atlas_readout(const std::optional<TexelView>& texel) {
    if (!texel) {
        quiet_line("point at the atlas or at the object");
        return;
    }
    std::string text = fmt::format("texel {}, {}", texel->x, texel->y);
    if (texel->color)
        text +=
            fmt::format("  #{:02x}{:02x}{:02x}", texel->color->r, texel->color->g, texel->color->b);
    if (texel->error) text += fmt::format("  off {:.2f}", *texel->error);
    if (const auto& facts = texel->facts)
        text += fmt::format("\nchart {}, scale {:.2f}\nsolid {:.3f} {:.3f} {:.3f}", facts->chart,
                            facts->scale, facts->point.x, facts->point.y, facts->point.z);
    ImGui::TextUnformatted(text.c_str());
}

float atlas_footer_height() {
    return 5.0f * ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
}

}  // namespace burl
