#pragma once
// The editor's view of a texture as it lies in its atlas, drawn anew only when something about it
// has changed.
#include <cstdint>
#include <memory>
#include <optional>

#include "app/editor/work/view_maker.h"
#include "app/gl/device/target.h"
#include "app/scene/sheet_frame.h"

namespace burl {

struct SheetViewOptions {
    GlSize size{0};  ///< in pixels
    SheetFrame frame{};
    int level = 0;  ///< the finest that is shown; finer ones than there are count as the finest
    bool operator==(const SheetViewOptions&) const = default;
};

class GlEditSheet {
  public:
    explicit GlEditSheet(const GladGLContext& gl);

    /// A picture, uploaded when it is new. Row 0 of the texture that comes back is the picture's
    /// top row. Null with a size of 0.
    const GlTexture* draw(const std::shared_ptr<const SheetPicture>& picture,
                          const SheetViewOptions& options);
    /// A texture with levels that is on the graphics processor already, level 0 `side` texels wide;
    /// `number`: another one whenever its texels are others.
    const GlTexture* draw(const GlTexture& texture, std::uint32_t side, std::uint64_t number,
                          const SheetViewOptions& options);
    /// Gives back what was uploaded.
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
    std::shared_ptr<const SheetPicture> picture_;  ///< uploaded
    std::uint64_t uploads_ = 0;
    GlTexture texture_;
    std::optional<GlTarget> shown_;
    std::optional<Drawn> drawn_;
};

}  // namespace burl
