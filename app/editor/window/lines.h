#pragma once
// Lines over the editor's view of the object: its triangles' edges and its charts' borders, hidden
// where the surface hides them, and uploaded when they are first asked for.
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/gl/draw/surface.h"
#include "app/scene/surface_lines.h"

namespace burl {

class GlEditLines {
  public:
    explicit GlEditLines(const GladGLContext& gl);

    /// What is drawn from now on, around a sphere that holds it all; null: nothing.
    void show(std::shared_ptr<const SurfaceLines> lines, const Sphere& sphere);
    bool shows(const std::shared_ptr<const SurfaceLines>& lines) const { return lines_ == lines; }

    enum class Kind { edges, borders };
    /// Into the bound framebuffer, of `samples` with rows top first, in front of the depths it
    /// holds; `pixel`: samples that a pixel is wide; `share`: of the way to their targets.
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
