#include "app/editor/window/side.h"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "app/editor/widgets/icons.h"
#include "app/editor/widgets/widgets.h"
#include "app/editor/window/imgui.h"
#include "procedural/numbers/simd_target.h"

namespace burl {

namespace {

using Tab = SidePanels::Tab;

constexpr Tab library_tab{"Library", icon::library, "Library: materials and recipes to begin with"};
constexpr Tab parameters_tab{"Parameters", icon::parameters,
                             "Parameters: the controls, and every number of the recipe"};
constexpr Tab colors_tab{"Colours", icon::colors, "Colours: the colour maps and their stops"};
constexpr Tab node_tab{"Node", icon::node, "Node: the node that is chosen in the graph"};
constexpr Tab steps_tab{"Steps", icon::steps, "Steps: what was done, to go back to; A and B"};
constexpr Tab metrics_tab{"Metrics", icon::metrics,
                          "Metrics: the mesh, its atlas, and what the texture cost"};
constexpr Tab log_tab{"Log", icon::log, "Log: files read and written, and what was refused"};

constexpr std::array all_tabs{library_tab, parameters_tab, colors_tab, node_tab,
                              steps_tab,   metrics_tab,    log_tab};

/// The text of a tab's label.
std::string label_of(const Tab& tab, TabLabels labels, bool front) {
    const std::string icon = icon_or(tab.icon, "");
    if (labels == TabLabels::names || icon.empty()) return tab.name;
    return labels == TabLabels::icons || !front ? icon : icon + " " + tab.name;
}

/// Pushes two variables of the style: icons alone stand closer.
void push_tab_style(TabLabels labels) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float share = labels == TabLabels::icons ? 0.4f : 1.0f;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        ImVec2(share * style.FramePadding.x, style.FramePadding.y));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing,
                        ImVec2(share * style.ItemInnerSpacing.x, style.ItemInnerSpacing.y));
}

/// The width of all tabs.
float tabs_width(TabLabels labels, const std::string& front, bool with_node) {
    const ImGuiStyle& style = ImGui::GetStyle();
    float width = 0.0f;
    for (const Tab& tab : all_tabs)
        if (with_node || tab.name != std::string_view(node_tab.name))
            width += ImGui::CalcTextSize(label_of(tab, labels, front == tab.name).c_str()).x +
                     2.0f * style.FramePadding.x + 1.0f + style.ItemInnerSpacing.x;
    return width;
}

/// The labels that have room: names, else icons with the name of the tab in front, else icons.
TabLabels labels_with_room(const std::string& front, bool with_node) {
    const float room = ImGui::GetContentRegionAvail().x;
    for (const TabLabels labels : {TabLabels::names, TabLabels::one_name})
        if (tabs_width(labels, front, with_node) <= room) return labels;
    return TabLabels::icons;
}

}  // namespace

ImTextureID GlEditGallery::picture(const std::string& preset, int side) {
    const auto image = thumbnails_.picture(preset, side);
    if (!image) return nullptr;
    const std::pair key(preset, side);
    auto found = textures_.find(key);
    if (found == textures_.end() || found->second.picture != image) {
        Shown shown{image, upload_levels(*gl_, picture_levels(*image), GL_RGB8)};
        if (found != textures_.end()) {
            shown_.erase(imgui_texture(found->second.texture));
            shown.before = std::move(found->second.texture);
        }
        found = textures_.insert_or_assign(key, std::move(shown)).first;
        shown_.insert(imgui_texture(found->second.texture));
    }
    return imgui_texture(found->second.texture);
}

SidePanels::SidePanels(GlContext& context, bool gallery, const std::function<void()>& wake)
    : context_(context), figures_(wake) {
    if (gallery) gallery_.emplace(context.gl(), wake);
}

void SidePanels::hold(bool held) {
    if (gallery_) gallery_->hold(held);
}

void SidePanels::wait() const {
    if (gallery_) gallery_->wait();
    figures_.wait();
}

bool SidePanels::begin_tab(EditItems& items, const Tab& tab, bool front) {
    const std::string label =
        fmt::format("{}###{}", label_of(tab, labels_, front_ == tab.name), tab.name);
    push_tab_style(labels_);
    const bool open =
        ImGui::BeginTabItem(label.c_str(), nullptr,
                            (front ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None) |
                                ImGuiTabItemFlags_NoTooltip);
    ImGui::PopStyleVar(2);
    items.note(fmt::format("tab:{}", tab.name));
    tip(tab.tip);
    if (open) front_ = tab.name;
    return open;
}

void SidePanels::window(const PanelContext& context, const EditBaker& baker, bool posed,
                        const SideParts& parts) {
    const auto& [graph, hooks, favourites, light] = parts;
    if (gallery_) gallery_->set_light(light);
    const auto tab = [&](const Tab& one, auto panel, bool front = false) {
        if (!begin_tab(context.items, one, front)) return;
        if (ImGui::BeginChild(one.name)) panel();
        ImGui::EndChild();
        ImGui::EndTabItem();
    };
    // The object's texture comes before thumbnails.
    const PresetPicture picture = [&](const std::string& preset, int side) -> ImTextureID {
        return gallery_ && baker.front().picture() ? gallery_->picture(preset, side) : nullptr;
    };
    const bool shown = ImGui::Begin("Side", nullptr, fixed_window);
    labels_ = labels_with_room(front_, graph.shown);
    push_tab_style(labels_);
    const bool begun = shown && ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_FittingPolicyScroll);
    ImGui::PopStyleVar(2);
    if (begun) {
        tab(library_tab, [&] { library_panel(context, library_, favourites, picture); });
        tab(parameters_tab, [&] {
            recipe_heading(context.session.recipe());
            controls_panel(context);
            parameters_panel(context, posed);
        });
        tab(colors_tab, [&] { color_maps_panel(context, stop_); });
        if (graph.shown) {
            const std::string chosen = graph.model().current();
            const bool front = std::exchange(node_shown_, chosen) != chosen && !chosen.empty();
            tab(
                node_tab, [&] { node_panel(context, graph, hooks, stop_); }, front);
        }
        tab(steps_tab, [&] { steps_panel(context); });
        tab(metrics_tab, [&] { metrics_panel(metrics(baker.front())); });
        tab(log_tab, [&] { log_panel(context); });
        ImGui::EndTabBar();
    }
    ImGui::End();
}

MetricsView SidePanels::metrics(const FrontBuffer& front) {
    MetricsView view;
    if (const auto surface = front.surface()) {
        view.facts.emplace_back("triangles", fmt::format("{}", surface->triangles));
        view.facts.emplace_back("atlas", fmt::format("{}, {} x {} texels", surface->atlas,
                                                     surface->size, surface->size));
        view.atlas = figures_.of(surface);
    }
    if (const auto picture = front.picture()) {
        view.facts.emplace_back("level shown", fmt::format("{}", picture->level));
        view.facts.emplace_back("texture by", picture->by);
        view.facts.emplace_back("made in", fmt::format("{:.1f} ms", 1e3 * picture->seconds));
    }
    view.facts.emplace_back("instructions", simd_level());
    view.facts.emplace_back("renderer", context_.description());
    view.records = front.records();
    return view;
}

}  // namespace burl
