#pragma once
// A scene's surface on the GPU, and how it is placed in a tile of a picture. Positions are moved
// and scaled into [-1,1] so that float32 suffices wherever the surface lies. A large surface is
// uploaded piece by piece, so that who draws frames meanwhile goes on doing so.
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

/// From scene to clip space of a tile whose rows come top first.
struct TileView {
    TileView(const Camera& camera, const PictureSize& samples, const SampleTile& tile);

    /// Eye space is in units of the far distance, so that float32 holds scenes of any size.
    Mat4d eye_from_scene, clip_from_eye;
};

class GlSurface {
  public:
    /// What it shows, and room for that, comes with upload(). `frame` as of app/scene/unit_frame.h.
    GlSurface(const GladGLContext& gl, const Surface& surface, const Mat4d& frame);

    /// The next piece, of about `bytes`, of the surface it was made for. Whether all is there.
    bool upload(const GladGLContext& gl, const Surface& surface, std::size_t bytes);

    /// All placements by a program in use with the uniforms of mesh.vert.
    void draw(const GladGLContext& gl, const GlProgram& program, const TileView& view) const;

    /// How far it has gone to its target, if it has one.
    void set_target_share(double share) { target_share_ = share; }

    const SceneMaterial& material() const { return material_; }
    bool in_blocks() const { return has(Stream::block); }
    bool colored() const { return has(Stream::color); }
    bool bumped() const { return material_.normals >= 0 && has(Stream::tangent); }
    GLsizei triangles() const { return GLsizei(streams_[std::size_t(Stream::index)].count); }

  private:
    /// Arrays in buffers of their own, which are numbered as mesh.vert's attributes: positions and
    /// normals may change where nothing else does.
    enum class Stream : std::size_t { position, normal, uv, color, block, tangent, index, count };
    struct Buffer {
        GlBuffer buffer{};
        std::size_t count = 0, stride = 0;  ///< elements and their bytes; no elements: no buffer
    };

    bool has(Stream stream) const { return streams_[std::size_t(stream)].count > 0; }
    void make_room(const GladGLContext& gl, Stream stream);
    void set_constants(const GladGLContext& gl) const;
    void upload_target(const GladGLContext& gl, const SurfaceTarget& target);
    const void* piece(const Surface& surface, Stream stream, std::size_t first, std::size_t count);

    GlVertexArray vertex_array_;
    std::array<Buffer, std::size_t(Stream::count)> streams_;
    std::size_t stream_ = 0, uploaded_ = 0;  ///< where upload() goes on: elements of a stream
    std::vector<Vec3f> points_;              ///< of the last piece, as OpenGL takes them
    std::vector<glm::vec2> uvs_;
    Mat4d local_from_unit_{1.0};
    SceneMaterial material_;
    std::optional<GlBuffer> changes_;  ///< of vertices on their way to a target
    double target_share_ = 0.0;
    std::vector<Mat4d> placements_;
};

}  // namespace burl
