#pragma once
// A scene's surface on the GPU, and how it is placed in a tile of a picture. Positions are moved
// and scaled into [-1,1] so that float32 suffices wherever the surface lies.
#include <vector>

#include "app/camera.h"
#include "app/gl_objects.h"
#include "app/scene.h"

namespace burl {

/// A rectangle of samples of a picture, y down.
struct SampleTile {
    int x = 0, y = 0, width = 0, height = 0;
};

/// From scene to clip space of a tile whose rows come top first.
struct TileView {
    TileView(const Camera& camera, const PictureSize& samples, const SampleTile& tile);

    /// Eye space is in units of the far distance, so that float32 holds scenes of any size.
    Mat4d eye_from_scene, clip_from_eye;
};

class GlSurface {
  public:
    GlSurface(const GladGLContext& gl, const Surface& surface);

    /// All placements by a program in use with the uniforms of mesh.vert.
    void draw(const GladGLContext& gl, const GlProgram& program, const TileView& view) const;

    const SceneMaterial& material() const { return material_; }
    bool in_blocks() const { return in_blocks_; }
    bool bumped() const { return bumped_; }
    GLsizei triangles() const { return index_count_ / 3; }

  private:
    GlVertexArray vertex_array_;
    GlBuffer vertices_, indices_;
    GLsizei index_count_ = 0;
    Mat4d local_from_unit_{1.0};
    SceneMaterial material_;
    bool in_blocks_ = false;  ///< lookups are clamped to the vertices' blocks
    bool bumped_ = false;     ///< has a normal map and tangents for it
    std::vector<Mat4d> placements_;
};

}  // namespace burl
