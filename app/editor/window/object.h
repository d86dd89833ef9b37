#pragma once
// The editor's view of the object: the scene with the newest texture, rendered into an OpenGL
// texture, and only when something has changed.
#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/editor/jobs/coarse.h"
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
    int supersample = 1;  ///< samples per side of a pixel: 1 while anything moves, 2 at rest
    /// Whether coarse surfaces are drawn in the place of a large one, where there are any.
    bool coarse = false;
    bool half = false;         ///< whether half as many pixels a side are drawn
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
    /// Sets the coarse surfaces of the surface shown; null: none.
    void show_coarse(const std::shared_ptr<const CoarseSurfaces>& coarse);
    /// Whether the surface has coarse ones that can be drawn.
    bool has_coarse() const { return scene_ && scene_->has_coarse(); }
    /// Sets the lines drawn over the object; null: none.
    void show_lines(const std::shared_ptr<const SurfaceLines>& lines);
    /// The OpenGL texture of picture(); null: none.
    const GlTexture* texture() const;
    /// Renders if anything has changed. Row 0 of the texture is the top row. Null without a surface
    /// or with a size of 0. A software OpenGL draws several samples a pixel in as many calls as
    /// keep each short; the texture shows what was drawn before until then.
    const GlTexture* draw(const ObjectViewOptions& options);
    /// Makes ready what draw() needs for `moving` options of the view that it has drawn last, so
    /// that the first frame of a movement is no longer than the others; a part a call.
    void prepare(const ObjectViewOptions& moving);
    /// Whether the last draw() is not done yet: it must be called again.
    bool drawing() const { return part_ > 0; }
    /// The target that the last draw() rendered into; null: none.
    const GlTarget* target() const { return image_ ? &image_->colors : nullptr; }
    /// Whether a texture that changes alone is drawn from a G-buffer: no triangle is drawn then.
    bool keeps_places(const ObjectViewOptions& options) const;
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
    void borrow(const ResidentPicture& resident);
    void upload(int number, const std::vector<Image<Rgba8>>& levels);
    void upload_normals(std::shared_ptr<const Image<Rgb8>> normals);
    void make_target(std::optional<GlDepthTarget>& target, const PictureSize& size, GLenum format);
    void make_targets(const ObjectViewOptions& options);
    GlDepthTarget& target_of(const ObjectViewOptions& options);
    void draw_view(const ObjectViewOptions& options);
    bool draw_places(const ObjectViewOptions& options);
    void find_places(const ObjectViewOptions& options, const DrawPart& part);
    void draw_pixels(const ObjectViewOptions& options);
    void draw_samples(const ObjectViewOptions& options);
    void draw_layers(const ObjectViewOptions& options);
    void draw_lines(const ObjectViewOptions& options);
    void draw_coarse(const ObjectViewOptions& options);
    void encode(const ObjectViewOptions& options);
    bool is_direct(const ObjectViewOptions& options) const;
    bool is_coarse(const ObjectViewOptions& options) const;
    DrawPart part_of(const ObjectViewOptions& options, int number) const;
    int row_parts(const ObjectViewOptions& options) const;
    void try_programs(const ObjectViewOptions& moving);

    const GladGLContext* gl_;
    bool is_software_;
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
    /// The samples, for views that need a downsampling pass, and the view's pixels, all and half as
    /// many a side.
    std::optional<GlDepthTarget> samples_, shown_, small_;
    const GlDepthTarget* image_ = nullptr;  ///< what was drawn last, shown_ or small_; null: none
    GlEditPlaces places_;
    std::optional<ObjectViewOptions> drawn_;
    /// Options with which this surface was drawn last, whatever its texture, and options of the
    /// G-buffer.
    std::optional<ObjectViewOptions> seen_, placed_;
    std::shared_ptr<const CoarseSurfaces> coarse_;
    /// Options of samples that are drawn in parts, and the next part; 0: none was drawn.
    std::optional<ObjectViewOptions> parted_;
    int part_ = 0;
    /// Options whose G-buffer is drawn in parts, and the next part.
    std::optional<ObjectViewOptions> placing_;
    int place_part_ = 0;
    std::optional<ObjectViewOptions> tried_;  ///< options whose programs are compiled
    std::optional<GlDepthTarget> trial_;
    bool pictured_ = false;  ///< whether image_ is of the surface
    bool drew_ = false;
    std::future<void> dropping_;  ///< destruction of the surface shown before, in the background
};

}  // namespace burl
