#pragma once
// The editor's view of the atlas beside the object: the texture, or its texels' solid points,
// charts, scales or errors. The surface point under the pointer in one view is marked in the other.
// Nothing is made while the view is hidden.
#include <cstdint>
#include <memory>
#include <optional>

#include "app/editor/jobs/view_maker.h"
#include "app/editor/panels/atlas.h"
#include "app/editor/tools/view.h"
#include "app/editor/window/object.h"
#include "app/gl/device/target.h"
#include "app/scene/sheet_frame.h"

namespace burl {

/// The inputs that decide the rendered view.
struct SheetViewOptions {
    GlSize size{0};  ///< size of the view in pixels
    SheetFrame frame{};
    int level = 0;  ///< the finest MIP level shown; negative values count as 0
    bool operator==(const SheetViewOptions&) const = default;
};

/// Renders a texture in its atlas when something has changed; the OpenGL context must be current in
/// every call.
class GlEditSheet {
  public:
    explicit GlEditSheet(const GladGLContext& gl);

    /// Renders a picture of the atlas, uploading a new one. Row 0 of the texture returned is the
    /// top row. Null without a picture or with a size of 0.
    const GlTexture* draw(const std::shared_ptr<const SheetPicture>& picture,
                          const SheetViewOptions& options);
    /// Renders an OpenGL texture with MIP levels whose level 0 is `side` texels wide. `number` must
    /// change whenever its texels change. Null with a size of 0.
    const GlTexture* draw(const GlTexture& texture, std::uint32_t side, std::uint64_t number,
                          const SheetViewOptions& options);
    /// Frees the uploaded picture.
    void release();

  private:
    struct Drawn {
        GLuint texture = 0;
        std::uint64_t number = 0;
        SheetViewOptions options{};
        bool operator==(const Drawn&) const = default;
    };

    const GladGLContext* gl_;
    GlProgram program_;
    GlFullScreen pass_;
    std::shared_ptr<const SheetPicture> picture_;  ///< picture in `texture_`
    std::uint64_t uploads_ = 0;
    GlTexture texture_;
    std::optional<GlTarget> shown_;
    std::optional<Drawn> drawn_;
};

/// The atlas view and the line overlays of the object. All functions are called by the user
/// interface's thread.
class GlEditAtlas {
  public:
    /// `wake` is called by another thread whenever there is something new to show.
    GlEditAtlas(const GladGLContext& gl, std::function<void()> wake);

    AtlasViewState state{};
    /// Whether edges of triangles and borders of charts are drawn over the object.
    bool edges = false, borders = false;

    /// Handles the keys V, W and B, and F where the pointer is over the atlas; true only for F.
    bool shortcuts();
    /// Takes over the pipeline's newest results, once a frame. `request` is the number of the last
    /// request, and `recipe` its recipe.
    void follow(const FrontBuffer& baked, std::uint64_t request, const Recipe& recipe);
    /// Picks the surface point under the pointer; ImGui's last item must be the object's view.
    void look_at_object(const ObjectView& view);
    /// Marks the point under the pointer in the atlas on the object, in the current ImGui window.
    void mark_object(const ObjectView& view) const;
    /// Draws the atlas and its controls in the current ImGui window. `pick`: the object's picking
    /// structure; null: not ready.
    void panel(const PanelContext& context, const FrontBuffer& baked, const GlEditObject& object,
               const SurfacePick* pick);

    /// The lines of the newest surface; null: not wanted, or not ready.
    std::shared_ptr<const SurfaceLines> lines() const { return maker_.lines(); }
    std::shared_ptr<const SheetPicture> picture() const;
    bool idle() const { return maker_.idle(); }
    void wait() const { maker_.wait(); }
    std::optional<std::string> take_problem() { return maker_.take_problem(); }

    /// The surface point under a pointer over the object, and that under a pointer over the atlas.
    const std::optional<SurfaceHit>& on_object() const { return on_object_; }
    const std::optional<SurfaceHit>& on_atlas() const { return on_atlas_; }

  private:
    void input(const Vec2d& low, const Vec2d& size, const SurfacePick* pick, std::uint32_t side);
    const GlTexture* draw(const GlEditObject& object, const Vec2d& size);
    void mark_atlas(const Vec2d& low, const Vec2d& size) const;
    std::optional<TexelView> texel(const FrontBuffer& baked, const GlEditObject& object,
                                   std::uint32_t side) const;
    std::span<const BorderLine> outline(const SurfaceHit& hit) const;

    EditViewMaker maker_;
    GlEditSheet sheet_;
    std::optional<Vec2d> pointer_;  ///< pointer over the atlas, in texture coordinates
    std::optional<SurfaceHit> on_atlas_, on_object_;
    bool late_ = false;  ///< whether the error picture belongs to an earlier texture
};

}  // namespace burl
