#include "app/editor/window/side.h"

#include <fmt/format.h>

#include "app/editor/widgets/widgets.h"
#include "app/editor/window/imgui.h"
#include "procedural/numbers/simd_target.h"

namespace burl {

ImTextureID GlEditGallery::picture(const std::string& preset, int side) {
    const auto image = thumbnails_.picture(preset, side);
    if (!image) return nullptr;
    const std::pair key(preset, side);
    auto found = textures_.find(key);
    if (found == textures_.end() || found->second.picture != image) {
        Shown shown{image, upload_levels(*gl_, picture_levels(*image), GL_RGB8)};
        if (found != textures_.end()) shown.before = std::move(found->second.texture);
        found = textures_.insert_or_assign(key, std::move(shown)).first;
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

void SidePanels::window(const PanelContext& context, const EditBaker& baker, bool posed,
                        const SideParts& parts) {
    const auto& [graph, hooks, favourites, light] = parts;
    if (gallery_) gallery_->set_light(light);
    const auto tab = [&](const char* name, auto panel, bool front = false) {
        const bool open = ImGui::BeginTabItem(
            name, nullptr, front ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None);
        context.items.note(fmt::format("tab:{}", name));
        if (!open) return;
        if (ImGui::BeginChild(name)) panel();
        ImGui::EndChild();
        ImGui::EndTabItem();
    };
    // The object's texture comes before thumbnails.
    const PresetPicture picture = [&](const std::string& preset, int side) -> ImTextureID {
        return gallery_ && baker.front().picture() ? gallery_->picture(preset, side) : nullptr;
    };
    if (ImGui::Begin("Side", nullptr, fixed_window) && ImGui::BeginTabBar("tabs")) {
        tab("Library", [&] { library_panel(context, library_, favourites, picture); });
        tab("Parameters", [&] {
            recipe_heading(context.session.recipe());
            controls_panel(context);
            parameters_panel(context, posed);
        });
        tab("Colours", [&] { color_maps_panel(context, stop_); });
        if (graph.shown) {
            const std::string chosen = graph.model().current();
            const bool front = std::exchange(node_shown_, chosen) != chosen && !chosen.empty();
            tab(
                "Node", [&] { node_panel(context, graph, hooks, stop_); }, front);
        }
        tab("Steps", [&] { steps_panel(context); });
        tab("Metrics", [&] { metrics_panel(metrics(baker.front())); });
        tab("Log", [&] { log_panel(context); });
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
        view.facts.emplace_back("made in", fmt::format("{:.1f} ms", 1e3 * picture->seconds));
    }
    view.facts.emplace_back("instructions", simd_level());
    view.facts.emplace_back("renderer", context_.description());
    view.records = front.records();
    return view;
}

}  // namespace burl
