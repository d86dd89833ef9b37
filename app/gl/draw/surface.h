#pragma once
// A surface uploaded to OpenGL, and the transformation of a picture's tile. Positions are
// normalised into [-1,1] so that float32 is precise wherever the surface lies. Large surfaces are
// uploaded in pieces, so that frames can be drawn meanwhile.
#include <array>
#include <optional>
#include <vector>

#include "app/gl/device/objects.h"
#include "app/scene/camera.h"
#include "app/scene/scene.h"

namespace burl {

/// A rectangle of samples of a picture, y down.
struct SampleTile {
    int x = 0, y = 0, width = 0, height = 0;
};

/// The maps from scene to clip space for a tile whose rows are read top first.
struct TileView {
    TileView(const Camera& camera, const PictureSize& samples, const SampleTile& tile);

    /// The maps from scene to eye space, in units of the far distance so that float32 holds scenes
    /// of any size, and on to clip space.
    Mat4d eye_from_scene, clip_from_eye;
};

/// One of so many parts of a surface's triangles, which are drawn one after the other.
struct DrawPart {
    int number = 0, count = 1;
};

/// The vertex arrays of a surface.
class GlSurface {
  public:
    /// Creates a surface without buffers, which upload() creates and fills. `frame` is its
    /// unit_frame (app/scene/scene.h).
    GlSurface(const GladGLContext& gl, const Surface& surface, const Mat4d& frame);

    /// Uploads the next piece, of about `bytes`, of the surface it was created for. Returns whether
    /// all is uploaded.
    bool upload(const GladGLContext& gl, const Surface& surface, std::size_t bytes);

    /// Draws a part of the triangles in all placements with the program in use, which has the
    /// uniforms of mesh.vert.
    void draw(const GladGLContext& gl, const GlProgram& program, const TileView& view,
              const DrawPart& part = {}) const;

    /// Sets the weight of the surface's morph target, if it has one.
    void set_target_share(double share) { target_share_ = share; }

    const SceneMaterial& material() const { return material_; }
    void set_material(const SceneMaterial& material) { material_ = material; }
    bool in_blocks() const { return has(Stream::block); }
    bool colored() const { return has(Stream::color); }
    bool bumped() const { return material_.normals >= 0 && has(Stream::tangent); }
    GLsizei triangles() const { return GLsizei(streams_[std::size_t(Stream::index)].count); }

  private:
    /// Vertex arrays, each in a buffer of its own, numbered as mesh.vert's attributes; and the
    /// indices.
    enum class Stream : std::size_t { position, normal, uv, color, block, tangent, index, count };
    struct Buffer {
        GlBuffer buffer{};
        /// The number of elements and their size in bytes; an empty array has no buffer.
        std::size_t count = 0, stride = 0;
    };

    bool has(Stream stream) const { return streams_[std::size_t(stream)].count > 0; }
    void make_room(const GladGLContext& gl, Stream stream);
    void set_constants(const GladGLContext& gl) const;
    void upload_target(const GladGLContext& gl, const SurfaceTarget& target);
    const void* piece(const Surface& surface, Stream stream, std::size_t first, std::size_t count);

    GlVertexArray vertex_array_;
    std::array<Buffer, std::size_t(Stream::count)> streams_;
    std::size_t stream_ = 0, uploaded_ = 0;  ///< the next element to upload, by array and index
    std::vector<Vec3f> points_;              ///< the positions of the last piece as float32
    std::vector<glm::vec2> uvs_;
    Mat4d local_from_unit_{1.0};
    SceneMaterial material_;
    std::optional<GlBuffer> changes_;  ///< the changes of the morph target
    double target_share_ = 0.0;
    std::vector<Mat4d> placements_;
};

}  // namespace burl
