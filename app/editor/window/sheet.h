#pragma once
// The editor's view of a texture in its atlas, rendered only when something has changed.
#include <cstdint>
#include <memory>
#include <optional>

#include "app/editor/jobs/view_maker.h"
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

/// Renders the atlas; the OpenGL context must be current in every call.
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
    void upload(const SheetPicture& picture);

    const GladGLContext* gl_;
    GlProgram program_;
    GlFullScreen pass_;
    std::shared_ptr<const SheetPicture> picture_;  ///< picture in `texture_`
    std::uint64_t uploads_ = 0;
    GlTexture texture_;
    std::optional<GlTarget> shown_;
    std::optional<Drawn> drawn_;
};

}  // namespace burl
