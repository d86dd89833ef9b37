#pragma once
// The editor's view of the object: the scene with the newest texture, rendered into an OpenGL
// texture, and only when something has changed.
#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/editor/jobs/front_buffer.h"
#include "app/editor/tools/view.h"
#include "app/editor/window/layers.h"
#include "app/editor/window/lines.h"
#include "app/editor/window/places.h"
#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "app/gl/draw/scene.h"

namespace burl {

/// The baked texture in OpenGL, in storage that is reused: a new texture of the same size is a copy
/// of its MIP levels. The OpenGL context must be current in every call.
class GlEditTexture {
  public:
    /// `texture` is owned by the caller; its codes are sRGB if it `is_color`.
    GlEditTexture(const GladGLContext& gl, GLuint texture, bool is_color)
        : gl_(&gl), texture_(texture), is_color_(is_color) {}

    /// Uploads MIP levels and sets trilinear filtering, clamped to the edges. Where only level 0 is
    /// given, OpenGL generates the others. Throws Error(unsupported) where the texture is larger
    /// than this OpenGL supports.
    void show(const std::vector<Image<Rgba8>>& levels);

  private:
    void make_storage(const std::vector<Image<Rgba8>>& levels);

    const GladGLContext* gl_;
    GLuint texture_;
    bool is_color_;
    std::size_t width_ = 0, height_ = 0, count_ = 0;  ///< size of level 0, and number of levels
};

/// The inputs that decide the rendered view.
struct ObjectViewOptions {
    PictureSize size{};  ///< size of the view in pixels
    EditCamera camera{};
    bool lit = true;
    std::shared_ptr<const GlLight> light{};  ///< an environment's light; null: the headlight
    double share = 0.0;                      ///< share of the way to the pose, 0 to 1
    /// Whether edges of triangles and borders of charts are drawn, once available.
    bool edges = false, borders = false;
    int supersample = 1;       ///< samples per side of a pixel: 1 while anything moves, 2 at rest
    bool every_layer = false;  ///< of what blends, or back faces and front faces alone
    bool operator==(const ObjectViewOptions&) const = default;
};

/// Renders the object; the OpenGL context must be current in every call.
class GlEditObject {
  public:
    explicit GlEditObject(const GladGLContext& gl);

    /// Sets the surface (null: none) and its texture. Uploads what is new, a large surface in
    /// slices of a few milliseconds per call, and shows the old surface until the upload is
    /// complete. `coming` (null: none) is uploaded ahead and shown by a later call.
    void show(const std::shared_ptr<const EditSurface>& surface,
              const std::shared_ptr<const EditPicture>& picture,
              const std::shared_ptr<const EditSurface>& coming = nullptr);
    /// Uploads for a few more milliseconds.
    void upload();
    /// Whether an upload is incomplete: show() or upload() must be called again.
    bool uploading() const { return next_scene_ && !uploaded_; }
    /// The surface shown; null: none.
    const std::shared_ptr<const EditSurface>& surface() const { return surface_; }
    /// Sets the lines drawn over the object; null: none.
    void show_lines(const std::shared_ptr<const SurfaceLines>& lines);
    /// The OpenGL texture of picture(); null: none.
    const GlTexture* texture() const;
    /// Renders if anything has changed. Row 0 of the texture is the top row. Null without a surface
    /// or with a size of 0.
    const GlTexture* draw(const ObjectViewOptions& options);
    /// The target that the last draw() rendered into; null: none.
    const GlTarget* target() const { return shown_ ? &shown_->colors : nullptr; }
    /// Whether the last draw() rendered anew.
    bool drew() const { return drew_; }
    /// The picture shown on the present surface; null: none yet.
    const EditPicture* picture() const { return picture_.get(); }
    /// Samples per side of a pixel of the last draw(); 0: nothing was drawn.
    int drawn_samples() const { return drawn_ ? drawn_->supersample : 0; }

  private:
    void begin(const std::shared_ptr<const EditSurface>& surface);
    void take_over();
    void upload(const std::shared_ptr<const EditPicture>& picture);
    void upload(int number, const std::vector<Image<Rgba8>>& levels);
    void upload_normals(std::shared_ptr<const Image<Rgb8>> normals);
    void make_target(std::optional<GlDepthTarget>& target, const PictureSize& size, GLenum format);
    void make_targets(const ObjectViewOptions& options);
    void draw_view(const ObjectViewOptions& options);
    bool draw_places(const ObjectViewOptions& options);
    void draw_pixels(const ObjectViewOptions& options);
    void draw_samples(const ObjectViewOptions& options);
    void encode(const ObjectViewOptions& options) const;
    bool is_direct(const ObjectViewOptions& options) const;

    const GladGLContext* gl_;
    GlProgram encode_, develop_;  ///< samples to the screen, as they are and by the tone curve
    GlFullScreen pass_;
    std::shared_ptr<GlScenePrograms> programs_;
    /// The surface shown, and the one being uploaded.
    std::shared_ptr<const EditSurface> surface_, next_;
    std::unique_ptr<GlScene> scene_, next_scene_;  ///< scenes of `surface_` and `next_`
    bool uploaded_ = false;                        ///< whether `next_scene_` is complete
    std::map<int, GlEditTexture> textures_;        ///< of the scene, by their numbers
    std::shared_ptr<const EditPicture> picture_;
    GlEditLines lines_;
    std::optional<GlEditLayers> layers_;          ///< made when they are first drawn
    std::shared_ptr<const Image<Rgb8>> normals_;  ///< normal map on the graphics processor
    /// The samples, for views that need a downsampling pass, and the view's pixels.
    std::optional<GlDepthTarget> samples_, shown_;
    GlEditPlaces places_;
    std::optional<ObjectViewOptions> drawn_;
    /// Options with which this surface was drawn last, whatever its texture, and options of the
    /// G-buffer.
    std::optional<ObjectViewOptions> seen_, placed_;
    bool drew_ = false;
    std::future<void> dropping_;  ///< destruction of the surface shown before, in the background
};

}  // namespace burl
