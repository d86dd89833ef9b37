#pragma once
// The editor's view of the object: a scene drawn into a texture that the panels show, with the
// newest picture of its colours, drawn anew only when something about it has changed.
#include <cstdint>
#include <memory>
#include <optional>

#include "app/edit_baker.h"
#include "app/edit_camera.h"
#include "app/gl_edit_lines.h"
#include "app/gl_scene.h"
#include "app/gl_target.h"

namespace burl {

struct ObjectViewOptions {
    PictureSize size{};  ///< in pixels
    EditCamera camera{};
    bool lit = true;
    bool edges = false, borders = false;  ///< of triangles and charts, as far as there are lines
    int supersample = 1;  ///< samples a side of a pixel: 1 while things move, 2 at rest
    bool operator==(const ObjectViewOptions&) const = default;
};

class GlEditObject {
  public:
    explicit GlEditObject(const GladGLContext& gl);

    /// What is shown from now on; null: nothing. Uploads only what is new.
    void show(std::shared_ptr<const EditSurface> surface,
              const std::shared_ptr<const EditPicture>& picture);
    /// The lines over it; null: none.
    void show_lines(const std::shared_ptr<const SurfaceLines>& lines);
    /// That of picture(); null: none yet.
    const GlTexture* texture() const;
    /// Draws if need be. Row 0 of the texture is the picture's top row. Null without a surface or
    /// with a size of 0.
    const GlTexture* draw(const ObjectViewOptions& options);
    /// What was shown last; null: nothing of this surface.
    const EditPicture* picture() const { return picture_.get(); }
    /// Samples a side of a pixel that the last draw() had; 0: it drew nothing.
    int drawn_samples() const { return drawn_ ? drawn_->supersample : 0; }

  private:
    void upload(const std::shared_ptr<const EditPicture>& picture);
    void upload_normals(std::shared_ptr<const Image<Rgb8>> normals);
    void make_targets(const ObjectViewOptions& options);
    void draw_samples(const ObjectViewOptions& options);
    void encode(const ObjectViewOptions& options) const;

    const GladGLContext* gl_;
    GlProgram encode_;
    GlFullScreen pass_;
    std::shared_ptr<const EditSurface> surface_;
    std::unique_ptr<GlScene> scene_;
    std::shared_ptr<const EditPicture> picture_;
    GlEditLines lines_;
    std::shared_ptr<const Image<Rgb8>> normals_;  ///< that are shown
    std::optional<GlTarget> samples_, shown_;
    GlRenderbuffer depth_;
    std::optional<ObjectViewOptions> drawn_;
};

}  // namespace burl
