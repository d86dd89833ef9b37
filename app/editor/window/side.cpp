#include "app/editor/window/side.h"

#include <fmt/format.h>

#include "app/editor/window/imgui.h"
#include "procedural/numbers/simd_level.h"

namespace burl {

namespace {

GlTexture upload(const GladGLContext& gl, const Image<Rgb8>& image) {
    GlTexture texture = make_texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.get());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const std::vector<Image<Rgb8>> levels = picture_levels(image);
    for (std::size_t level = 0; level < levels.size(); ++level)
        gl.TexImage2D(GL_TEXTURE_2D, GLint(level), GL_RGB8, GLsizei(levels[level].width()),
                      GLsizei(levels[level].height()), 0, GL_RGB, GL_UNSIGNED_BYTE,
                      levels[level].pixels().data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    check_gl(gl, "uploading a preset's picture");
    return texture;
}

}  // namespace

ImTextureID GlEditGallery::picture(const std::string& preset, int side) {
    const std::pair key(preset, side);
    if (const auto found = textures_.find(key); found != textures_.end())
        return imgui_texture(found->second);
    const auto image = thumbnails_.picture(preset, side);
    if (!image) return nullptr;
    return imgui_texture(textures_.emplace(key, upload(*gl_, *image)).first->second);
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

void SidePanels::window(const PanelContext& context, const EditBaker& baker, bool posed) {
    const auto tab = [&](const char* name, auto panel) {
        const bool open = ImGui::BeginTabItem(name);
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
        tab("Presets", [&] { presets_panel(context, preset_search_, picture); });
        tab("Parameters", [&] { parameters_panel(context, posed); });
        tab("Colours", [&] { color_maps_panel(context, stop_); });
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
