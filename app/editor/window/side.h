#pragma once
// The panels at the window's side, in tabs: library, parameters, colour maps, metrics and the log.
#include <imgui.h>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "app/editor/graph/graph.h"
#include "app/editor/jobs/baker.h"
#include "app/editor/jobs/figures.h"
#include "app/editor/jobs/thumbnails.h"
#include "app/editor/panels/library.h"
#include "app/editor/panels/panels.h"
#include "app/gl/device/context.h"
#include "app/gl/device/objects.h"

namespace burl {

/// Thumbnails of the presets as OpenGL textures, uploaded as they become ready. All functions are
/// called by the user interface's thread.
class GlEditGallery {
  public:
    /// `wake` is called by another thread whenever a thumbnail is ready.
    GlEditGallery(const GladGLContext& gl, std::function<void()> wake)
        : gl_(&gl), thumbnails_(std::move(wake)) {}

    /// The thumbnail of a preset, side x side pixels, drawn in the background when first asked for
    /// (app/editor/jobs/thumbnails.h); null: not ready. The OpenGL context must be current.
    ImTextureID picture(const std::string& preset, int side);
    /// Sets the light of thumbnails that are asked for from now on.
    void set_light(const BallLight& light) { thumbnails_.set_light(light); }

    /// Whether the texture is a thumbnail's, whose texels never change.
    bool lasts(ImTextureID texture) const { return shown_.contains(texture); }
    /// While held, no thumbnail is begun.
    void hold(bool held) { thumbnails_.hold(held); }
    void wait() const { thumbnails_.wait(); }

  private:
    struct Shown {
        std::shared_ptr<const Image<Rgb8>> picture;
        GlTexture texture;
        std::optional<GlTexture> before{};  ///< of another light; the frame may show it already
    };

    const GladGLContext* gl_;
    std::map<std::pair<std::string, int>, Shown> textures_;
    std::set<ImTextureID> shown_;  ///< all of `textures_`
    EditThumbnails thumbnails_;
};

/// Parts of the rest of the program that the side panel shows.
struct SideParts {
    EditGraph& graph;
    GraphHooks hooks;
    std::set<std::string>& favourites;  ///< the library's
    BallLight light;                    ///< of the thumbnails
};

/// The labels of tabs: their names, icons with the name of the one in front, or icons alone.
enum class TabLabels { names, one_name, icons };

/// Draws the tabs. All functions are called by the user interface's thread.
class SidePanels {
  public:
    /// A tab: its name, its icon, and what it shows.
    struct Tab {
        const char* name;
        const char* icon;
        const char* tip;
    };

    /// `gallery`: whether presets have thumbnails. `wake` is called by other threads when there is
    /// something new to show.
    SidePanels(GlContext& context, bool gallery, const std::function<void()>& wake);

    /// Draws the window at the place set for ImGui's next window. `posed`: whether the mesh has a
    /// pose. A node that was just chosen in the graph brings its tab to the front.
    void window(const PanelContext& context, const EditBaker& baker, bool posed,
                const SideParts& parts);
    /// Drops the selection of a colour stop, for another document.
    void deselect() { stop_ = {}; }

    /// Whether the texture's texels never change.
    bool lasts(ImTextureID texture) const { return gallery_ && gallery_->lasts(texture); }
    /// While held, no thumbnail is begun.
    void hold(bool held);
    /// Blocks until nothing is being made for the panels.
    void wait() const;

  private:
    bool begin_tab(EditItems& items, const Tab& tab, bool front);
    MetricsView metrics(const FrontBuffer& front);

    GlContext& context_;
    StopSelection stop_;
    LibraryView library_;
    std::string node_shown_;
    std::string front_;  ///< the tab in front
    TabLabels labels_ = TabLabels::names;
    std::optional<GlEditGallery> gallery_;
    EditFigures figures_;
};

}  // namespace burl
