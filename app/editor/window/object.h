#pragma once
// The editor's view of the object: a scene drawn into a texture that the panels show, with the
// newest picture of its colours, drawn anew only when something about it has changed.
#include <cstdint>
#include <future>
#include <memory>
#include <optional>

#include "app/editor/tools/camera.h"
#include "app/editor/window/lines.h"
#include "app/editor/window/places.h"
#include "app/editor/window/texture.h"
#include "app/editor/work/baker.h"
#include "app/gl/device/target.h"
#include "app/gl/draw/scene.h"

namespace burl {

struct ObjectViewOptions {
    PictureSize size{};  ///< in pixels
    EditCamera camera{};
    bool lit = true;
    double share = 0.0;                   ///< of the way to its pose
    bool edges = false, borders = false;  ///< of triangles and charts, as far as there are lines
    int supersample = 1;  ///< samples a side of a pixel: 1 while things move, 2 at rest
    bool operator==(const ObjectViewOptions&) const = default;
};

class GlEditObject {
  public:
    explicit GlEditObject(const GladGLContext& gl);

    /// What is shown from now on; null: nothing. Uploads only what is new, and of a large surface a
    /// few milliseconds' worth: until the last of several calls the one before is shown. `coming`
    /// (null: none) is what will be shown next and is uploaded already.
    void show(const std::shared_ptr<const EditSurface>& surface,
              const std::shared_ptr<const EditPicture>& picture,
              const std::shared_ptr<const EditSurface>& coming = nullptr);
    /// A few milliseconds' worth more.
    void upload();
    /// A surface is not there yet: show() or upload() is to be called again.
    bool uploading() const { return next_scene_ && !uploaded_; }
    /// What is shown; null: nothing.
    const std::shared_ptr<const EditSurface>& surface() const { return surface_; }
    /// The lines over it; null: none.
    void show_lines(const std::shared_ptr<const SurfaceLines>& lines);
    /// That of picture(); null: none yet.
    const GlTexture* texture() const;
    /// Draws if need be. Row 0 of the texture is the picture's top row. Null without a surface or
    /// with a size of 0.
    const GlTexture* draw(const ObjectViewOptions& options);
    /// What the last draw() drew into.
    const GlTarget* target() const { return shown_ ? &shown_->colors : nullptr; }
    /// Whether the last draw() had to.
    bool drew() const { return drew_; }
    /// What was shown last; null: nothing of this surface.
    const EditPicture* picture() const { return picture_.get(); }
    /// Samples a side of a pixel that the last draw() had; 0: it drew nothing.
    int drawn_samples() const { return drawn_ ? drawn_->supersample : 0; }

  private:
    void begin(const std::shared_ptr<const EditSurface>& surface);
    void take_over();
    void upload(const std::shared_ptr<const EditPicture>& picture);
    void upload_normals(std::shared_ptr<const Image<Rgb8>> normals);
    void make_target(std::optional<GlDepthTarget>& target, const PictureSize& size, GLenum format);
    void make_targets(const ObjectViewOptions& options);
    void draw_view(const ObjectViewOptions& options);
    bool draw_places(const ObjectViewOptions& options);
    void draw_pixels(const ObjectViewOptions& options);
    void draw_samples(const ObjectViewOptions& options);
    void encode(const ObjectViewOptions& options) const;

    const GladGLContext* gl_;
    GlProgram encode_;
    GlFullScreen pass_;
    std::shared_ptr<GlScenePrograms> programs_;
    std::shared_ptr<const EditSurface> surface_, next_;  ///< shown, and being uploaded
    std::unique_ptr<GlScene> scene_, next_scene_;        ///< of these
    bool uploaded_ = false;                              ///< the latter is there
    std::optional<GlEditTexture> texture_;               ///< that the scene's surfaces show
    std::shared_ptr<const EditPicture> picture_;
    GlEditLines lines_;
    std::shared_ptr<const Image<Rgb8>> normals_;  ///< that are shown
    std::optional<GlDepthTarget> samples_,
        shown_;  ///< the former where there are lines or many samples a pixel
    GlEditPlaces places_;
    std::optional<ObjectViewOptions> drawn_;
    /// Of this surface, with whatever texture: what was drawn last, and whose places are known.
    std::optional<ObjectViewOptions> seen_, placed_;
    bool drew_ = false;
    std::future<void> dropping_;  ///< of the surface that was shown before
};

}  // namespace burl
