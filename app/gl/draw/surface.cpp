#include "app/gl/draw/surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace burl {

namespace {

/// The change of a vertex at weight 1 of the morph target.
struct Change {
    Vec3f position, normal, tangent;
};

std::vector<Change> pack_changes(const SurfaceTarget& target, double scale) {
    std::vector<Change> changes(target.positions.size());
    for (std::size_t i = 0; i < changes.size(); ++i) {
        changes[i].position = Vec3f(target.positions[i] / scale);
        changes[i].normal = target.normals.empty() ? Vec3f(0.0f) : target.normals[i];
        changes[i].tangent = target.tangents.empty() ? Vec3f(0.0f) : target.tangents[i];
    }
    return changes;
}

/// The map from the picture's clip space to the tile's, with y reversed so that rows are read top
/// first.
Mat4d tile_from_clip(const SampleTile& tile, const PictureSize& samples) {
    Mat4d m(1.0);
    m[0][0] = double(samples.width) / tile.width;
    m[3][0] = double(samples.width - 2 * tile.x) / tile.width - 1.0;
    m[1][1] = -double(samples.height) / tile.height;
    m[3][1] = double(samples.height - 2 * tile.y) / tile.height - 1.0;
    return m;
}

/// The cofactors of the linear part, scaled to entries of at most one. They transform normals up to
/// a length, which the shader normalises.
glm::mat3 normal_matrix(const Mat4d& transform) {
    const Mat3d m(transform);
    const Mat3d cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    double largest = 0.0;
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(cofactors[c][r]));
    }
    return glm::mat3(largest > 0.0 ? cofactors / largest : Mat3d(0.0));
}

/// The rotation from eye to scene space; the map from scene to eye space is a rotation, scaled and
/// moved.
glm::mat3 scene_rotation(const Mat4d& eye_from_scene) {
    const Mat3d turn(eye_from_scene);
    return glm::mat3(glm::transpose(turn) / glm::length(turn[0]));
}

}  // namespace

TileView::TileView(const Camera& camera, const PictureSize& samples, const SampleTile& tile)
    : eye_from_scene(1.0 / camera.far_distance) {
    Camera unit = camera;
    unit.near_distance /= camera.far_distance;
    unit.far_distance = 1.0;
    eye_from_scene[3][3] = 1.0;
    eye_from_scene = eye_from_scene * camera.eye_from_scene();
    clip_from_eye = tile_from_clip(tile, samples) * unit.clip_from_eye();
}

GlSurface::GlSurface(const GladGLContext& gl, const Surface& surface, const Mat4d& frame)
    : vertex_array_(gl),
      local_from_unit_(frame),
      material_(surface.material),
      target_share_(surface.target_share),
      placements_(surface.placements) {
    const auto set = [&](Stream stream, std::size_t count, std::size_t stride) {
        streams_[std::size_t(stream)] = {{}, count, stride};
    };
    set(Stream::position, surface.positions.size(), sizeof(Vec3f));
    set(Stream::normal, surface.normals.size(), sizeof(Vec3f));
    set(Stream::uv, surface.uvs.size(), sizeof(glm::vec2));
    set(Stream::color, surface.colors.size(), sizeof(Vec4f));
    set(Stream::block, surface.blocks.size(), sizeof(Vec4f));
    set(Stream::tangent, surface.tangents.size(), sizeof(Vec4f));
    set(Stream::index, surface.triangles.size(), sizeof(Triangle));
}

/// Creates the buffer of one array; an attribute without elements has one constant value
/// (set_constants). Buffers are created one at a time, since a software OpenGL clears them.
void GlSurface::make_room(const GladGLContext& gl, Stream stream) {
    Buffer& buffer = streams_[std::size_t(stream)];
    buffer.buffer = GlBuffer(gl);
    const GLenum target = stream == Stream::index ? GL_ELEMENT_ARRAY_BUFFER : GL_ARRAY_BUFFER;
    gl.BindVertexArray(vertex_array_.get());
    gl.BindBuffer(target, buffer.buffer.get());
    gl.BufferData(target, GLsizeiptr(buffer.count * buffer.stride), nullptr, GL_STATIC_DRAW);
    if (stream == Stream::index) return;
    gl.EnableVertexAttribArray(GLuint(stream));
    gl.VertexAttribPointer(GLuint(stream), GLint(buffer.stride / sizeof(float)), GL_FLOAT, GL_FALSE,
                           0, nullptr);
}

/// Elements of an array in the buffer's format. Positions and texture coordinates are converted to
/// float32 here.
const void* GlSurface::piece(const Surface& surface, Stream stream, std::size_t first,
                             std::size_t count) {
    const Vec3d centre(local_from_unit_[3]);
    switch (stream) {
        case Stream::position:
            points_.resize(count);
            for (std::size_t i = 0; i < count; ++i)
                points_[i] =
                    Vec3f((surface.positions[first + i] - centre) / local_from_unit_[0][0]);
            return points_.data();
        case Stream::uv:
            uvs_.resize(count);
            for (std::size_t i = 0; i < count; ++i) uvs_[i] = glm::vec2(surface.uvs[first + i]);
            return uvs_.data();
        case Stream::normal:
            return surface.normals.data() + first;
        case Stream::color:
            return surface.colors.data() + first;
        case Stream::block:
            return surface.blocks.data() + first;
        case Stream::tangent:
            return surface.tangents.data() + first;
        case Stream::index:
        case Stream::count:
            break;
    }
    return surface.triangles.data() + first;
}

bool GlSurface::upload(const GladGLContext& gl, const Surface& surface, std::size_t bytes) {
    // Indices are uploaded through GL_ARRAY_BUFFER, which leaves the bound vertex array unchanged.
    while (stream_ < streams_.size() && bytes > 0) {
        const Buffer& to = streams_[stream_];
        if (uploaded_ == to.count) {
            ++stream_;
            uploaded_ = 0;
            continue;
        }
        if (uploaded_ == 0) make_room(gl, Stream(stream_));
        const std::size_t count =
            std::clamp<std::size_t>(bytes / to.stride, 1, to.count - uploaded_);
        gl.BindBuffer(GL_ARRAY_BUFFER, to.buffer.get());
        gl.BufferSubData(GL_ARRAY_BUFFER, GLintptr(uploaded_ * to.stride),
                         GLsizeiptr(count * to.stride),
                         piece(surface, Stream(stream_), uploaded_, count));
        uploaded_ += count;
        bytes -= std::min(bytes, count * to.stride);
    }
    check_gl(gl, "uploading a surface");
    if (stream_ < streams_.size()) return false;
    if (!surface.target.positions.empty()) upload_target(gl, surface.target);
    points_ = {};
    uvs_ = {};
    return true;
}

void GlSurface::set_constants(const GladGLContext& gl) const {
    const auto set = [&](Stream stream, const Vec4f& value) {
        if (!has(stream)) gl.VertexAttrib4f(GLuint(stream), value.x, value.y, value.z, value.w);
    };
    set(Stream::uv, Vec4f(0.0f));
    set(Stream::color, Vec4f(1.0f));
    set(Stream::block, Vec4f(0, 0, 1, 1));
    set(Stream::tangent, Vec4f(0.0f));
}

/// Uploads the morph target into a buffer of its own, which surfaces without a target do not have.
void GlSurface::upload_target(const GladGLContext& gl, const SurfaceTarget& target) {
    const std::vector<Change> changes = pack_changes(target, local_from_unit_[0][0]);
    gl.BindVertexArray(vertex_array_.get());
    changes_ = GlBuffer(gl);
    gl.BindBuffer(GL_ARRAY_BUFFER, changes_->get());
    gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(changes.size() * sizeof(Change)), changes.data(),
                  GL_STATIC_DRAW);
    const auto set = [&](GLuint index, std::size_t offset) {
        gl.EnableVertexAttribArray(index);
        gl.VertexAttribPointer(index, 3, GL_FLOAT, GL_FALSE, sizeof(Change),
                               reinterpret_cast<const void*>(offset));
    };
    set(6, offsetof(Change, position));
    set(7, offsetof(Change, normal));
    set(8, offsetof(Change, tangent));
    check_gl(gl, "uploading a target");
}

void GlSurface::draw(const GladGLContext& gl, const GlProgram& program, const TileView& view,
                     const DrawPart& part) const {
    const auto before = [&](int number) {
        return GLsizei(std::int64_t(triangles()) * number / part.count);
    };
    const GLsizei first = before(part.number), end = before(part.number + 1);
    gl.BindVertexArray(vertex_array_.get());
    set_constants(gl);
    program.set("target_share", float(changes_ ? target_share_ : 0.0));
    program.set("scene_from_eye", scene_rotation(view.eye_from_scene));
    for (const Mat4d& placement : placements_) {
        const Mat4d eye_from_local = view.eye_from_scene * placement * local_from_unit_;
        program.set("clip_from_local", glm::mat4(view.clip_from_eye * eye_from_local));
        program.set("eye_from_local", glm::mat4(eye_from_local));
        program.set("normal_from_local", normal_matrix(eye_from_local));
        gl.DrawElements(GL_TRIANGLES, 3 * (end - first), GL_UNSIGNED_INT,
                        reinterpret_cast<const void*>(std::size_t(first) * sizeof(Triangle)));
    }
}

}  // namespace burl
