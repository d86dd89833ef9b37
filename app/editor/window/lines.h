#pragma once
// Line overlays of the object: the edges of triangles and the borders of charts, hidden by the
// surface through a depth test, uploaded when they are first drawn.
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/gl/draw/surface.h"
#include "app/scene/surface_lines.h"

namespace burl {

/// Draws lines; the OpenGL context must be current in every call.
class GlEditLines {
  public:
    explicit GlEditLines(const GladGLContext& gl);

    /// Sets the lines, and a sphere that encloses them; null: no lines.
    void show(std::shared_ptr<const SurfaceLines> lines, const Sphere& sphere);
    bool shows(const std::shared_ptr<const SurfaceLines>& lines) const { return lines_ == lines; }

    enum class Kind { edges, borders };
    /// Draws into the bound framebuffer of size `samples`, rows top first, testing against its
    /// depth buffer. `pixel`: width of a pixel in samples. `share`: share of the way to the pose, 0
    /// to 1.
    void draw(Kind kind, const Camera& camera, const PictureSize& samples, int pixel,
              double share = 0.0);

  private:
    struct Uploaded {
        GlVertexArray vertex_array;
        GlBuffer ends, changes;
        GLsizei count = 0;
    };
    using Ends = std::vector<std::array<Vec3f, 2>>;
    void upload(const Uploaded& into, const GlBuffer& buffer, const Ends& ends, GLuint first) const;
    Uploaded upload(Kind kind) const;

    const GladGLContext* gl_;
    GlProgram program_;
    std::shared_ptr<const SurfaceLines> lines_;
    Sphere sphere_;
    std::optional<Uploaded> edges_, borders_;
};

}  // namespace burl
