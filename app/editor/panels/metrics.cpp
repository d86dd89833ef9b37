// The metrics panel: figures of the atlas with a histogram of its texel density, and the work,
// times and reuse of the pipeline's stages.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/editor/panels/panels.h"

namespace burl {

namespace {

std::string counted(std::uint64_t count) {
    if (count >= 100000000) return fmt::format("{:.0f} M", double(count) / 1e6);
    if (count >= 1000000) return fmt::format("{:.1f} M", double(count) / 1e6);
    if (count >= 10000) return fmt::format("{:.0f} k", double(count) / 1e3);
    return fmt::format("{}", count);
}

std::uint64_t sum(const auto& counts) {
    std::uint64_t all = 0;
    for (const std::uint64_t count : counts) all += count;
    return all;
}

void cell(const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

void row(const std::string& name, const std::string& value) {
    ImGui::TableNextRow();
    cell(name);
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", value.c_str());
}

void hint(const char* text) {
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

void atlas_rows(const AtlasFigures& figures) {
    row("coverage", fmt::format("{:.1f} % of the texture", 100.0 * figures.coverage));
    row("relative scale", fmt::format("{:.3f}", figures.relative_scale));
    row("density", fmt::format("{:.0f} texels per unit; 5 / 50 / 95 %: {:.2f} / {:.2f} / {:.2f}",
                               figures.texels_per_unit, figures.density[0], figures.density[1],
                               figures.density[2]));
}

/// Draws the histogram of the density on a logarithmic axis, the mean in the middle.
void histogram(const AtlasFigures& figures) {
    ImGui::TextUnformatted("share of the surface by texels per area");
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = 5.0f * ImGui::GetFontSize();
    ImGui::Dummy({width, height});
    hint("Narrow and in the middle: every part of the surface has its share of the texels.");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + width, low.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg));
    const double most = std::max(1e-9, *std::ranges::max_element(figures.histogram));
    const float step = width / float(figures.histogram.size());
    for (std::size_t i = 0; i < figures.histogram.size(); ++i) {
        const float left = low.x + step * float(i);
        const float top = low.y + height * float(1.0 - 0.95 * figures.histogram[i] / most);
        list.AddRectFilled({left + 0.5f, top}, {left + step - 0.5f, low.y + height},
                           ImGui::GetColorU32(ImGuiCol_PlotHistogram));
    }
    const ImU32 ink = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    list.AddLine({low.x + 0.5f * width, low.y}, {low.x + 0.5f * width, low.y + height}, ink);
    const std::array<std::string, 3> labels{fmt::format("1/{:.0f}", AtlasFigures::reach), "mean",
                                            fmt::format("{:.0f} x", AtlasFigures::reach)};
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const float share = 0.5f * float(i), wide = ImGui::CalcTextSize(labels[i].c_str()).x;
        list.AddText({low.x + share * (width - wide), low.y + height}, ink, labels[i].c_str());
    }
    ImGui::Dummy({width, ImGui::GetTextLineHeight()});
}

void stages(const StageRecords& records) {
    ImGui::TextUnformatted("what the stages did for this mesh, and were spared");
    if (!ImGui::BeginTable("stages", 6, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit))
        return;
    for (const char* title : {"stage", "ms", "texels", "spared", "octaves", "spared "})
        ImGui::TableSetupColumn(title);
    ImGui::TableHeadersRow();
    for (std::size_t k = 0; k < stage_names.size(); ++k) {
        const StageRecord& record = records[Stage(k)];
        if (record.runs == 0) continue;
        const SynthesisWork& work = record.done.work;
        ImGui::TableNextRow();
        cell(fmt::format("{} x{}", stage_names[k], record.runs));
        cell(fmt::format("{:.{}f}", 1e3 * record.seconds, record.seconds < 1.0 ? 1 : 0));
        cell(counted(work.texels));
        cell(counted(sum(work.texels_skipped)));
        cell(counted(work.octaves));
        cell(counted(sum(work.octaves_skipped)));
    }
    ImGui::EndTable();
}

}  // namespace

void metrics_panel(const MetricsView& view) {
    if (ImGui::BeginTable("facts", 2, ImGuiTableFlags_RowBg)) {
        ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed);
        ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
        for (const auto& [name, value] : view.facts) row(name, value);
        if (view.atlas) atlas_rows(*view.atlas);
        ImGui::EndTable();
    }
    ImGui::Spacing();
    if (view.atlas) histogram(*view.atlas);
    ImGui::Spacing();
    stages(view.records);
}

}  // namespace burl
