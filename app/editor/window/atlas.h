#pragma once
// The editor's second view: the texture and what its texels stand for, as it lies in the atlas,
// beside the object; a pointer over the one is marked in the other. Nothing of it is made while it
// is hidden.
#include "app/editor/panels/atlas.h"
#include "app/editor/tools/view.h"
#include "app/editor/window/object.h"
#include "app/editor/window/sheet.h"

namespace burl {

class GlEditAtlas {
  public:
    /// `wake` is called by another thread whenever there is something new.
    GlEditAtlas(const GladGLContext& gl, std::function<void()> wake);

    AtlasViewState state{};
    bool edges = false, borders = false;  ///< lines over the object

    /// V, W and B; F where the pointer is over the atlas, and only then is the answer true.
    bool shortcuts();
    /// Once a frame: what the pipeline has come to. `request` is the number of the last recipe that
    /// was asked for.
    void follow(const EditBaker& baker, std::uint64_t request, const Recipe& recipe);
    /// The last item is the object's view: notes where the pointer is on it.
    void look_at_object(const ObjectView& view);
    /// The marks on the object, in the window that shows it.
    void mark_object(const ObjectView& view) const;
    /// Inside a window of its own.
    /// `pick`: of the object's view; null: none yet.
    void panel(const PanelContext& context, const EditBaker& baker, const GlEditObject& object,
               const SurfacePick* pick);

    /// Of the newest surface; null: nobody wants them, or not yet.
    std::shared_ptr<const SurfaceLines> lines() const { return maker_.lines(); }
    std::shared_ptr<const SheetPicture> picture() const;
    bool idle() const { return maker_.idle(); }
    void wait() const { maker_.wait(); }
    std::optional<std::string> take_problem() { return maker_.take_problem(); }

    /// Of the object, under the pointer over it; of the atlas.
    const std::optional<SurfaceHit>& on_object() const { return on_object_; }
    const std::optional<SurfaceHit>& on_atlas() const { return on_atlas_; }

  private:
    void input(const Vec2d& low, const Vec2d& size, const SurfacePick* pick, std::uint32_t side);
    const GlTexture* draw(const GlEditObject& object, const Vec2d& size);
    void mark_atlas(const Vec2d& low, const Vec2d& size) const;
    std::optional<TexelView> texel(const EditBaker& baker, const GlEditObject& object,
                                   std::uint32_t side) const;
    std::span<const BorderLine> outline(const SurfaceHit& hit) const;

    EditViewMaker maker_;
    GlEditSheet sheet_;
    std::optional<Vec2d> pointer_;  ///< over the atlas, in texture coordinates
    std::optional<SurfaceHit> on_atlas_, on_object_;
    bool late_ = false;  ///< the picture is of an earlier texture
};

}  // namespace burl
