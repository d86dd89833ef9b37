#include "app/gl_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace burl {

namespace {

struct Vertex {
    Vec3f position, normal;
    glm::vec2 uv;
    Vec4f color, block, tangent;
};

Mat4d unit_frame(const Surface& surface) {
    const Sphere sphere = sphere_around([&](auto visit) {
        for (const Vec3d& p : surface.positions) visit(p);
    });
    Mat4d frame(sphere.radius > 0.0 ? sphere.radius : 1.0);
    frame[3] = Vec4d(sphere.centre, 1.0);
    return frame;
}

std::vector<Vertex> pack_vertices(const Surface& surface, const Mat4d& frame) {
    std::vector<Vertex> vertices(surface.positions.size());
    const Vec3d centre(frame[3]);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        vertices[i].position = Vec3f((surface.positions[i] - centre) / frame[0][0]);
        vertices[i].normal = surface.normals[i];
        vertices[i].uv = surface.uvs.empty() ? glm::vec2(0.0f) : glm::vec2(surface.uvs[i]);
        vertices[i].color = surface.colors.empty() ? Vec4f(1.0f) : surface.colors[i];
        vertices[i].tangent = surface.tangents.empty() ? Vec4f(0.0f) : surface.tangents[i];
        vertices[i].block = surface.blocks.empty() ? Vec4f(0, 0, 1, 1) : surface.blocks[i];
    }
    return vertices;
}

void set_attribute(const GladGLContext& gl, GLuint index, GLint components, std::size_t offset) {
    gl.EnableVertexAttribArray(index);
    gl.VertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                           reinterpret_cast<const void*>(offset));
}

/// Takes the whole picture's clip space to the tile's, turned over so that rows come top first.
Mat4d tile_from_clip(const SampleTile& tile, const PictureSize& samples) {
    Mat4d m(1.0);
    m[0][0] = double(samples.width) / tile.width;
    m[3][0] = double(samples.width - 2 * tile.x) / tile.width - 1.0;
    m[1][1] = -double(samples.height) / tile.height;
    m[3][1] = double(samples.height - 2 * tile.y) / tile.height - 1.0;
    return m;
}

/// Cofactors of the linear part, scaled to entries of at most one: they take normals along, and
/// the shader does not mind their length.
glm::mat3 normal_matrix(const Mat4d& transform) {
    const Mat3d m(transform);
    const Mat3d cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    double largest = 0.0;
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(cofactors[c][r]));
    }
    return glm::mat3(largest > 0.0 ? cofactors / largest : Mat3d(0.0));
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

GlSurface::GlSurface(const GladGLContext& gl, const Surface& surface)
    : vertex_array_(make_vertex_array(gl)),
      vertices_(make_buffer(gl)),
      indices_(make_buffer(gl)),
      index_count_(GLsizei(3 * surface.triangles.size())),
      local_from_unit_(unit_frame(surface)),
      material_(surface.material),
      in_blocks_(!surface.blocks.empty()),
      bumped_(surface.material.normals >= 0 && !surface.tangents.empty()),
      placements_(surface.placements) {
    const std::vector<Vertex> vertices = pack_vertices(surface, local_from_unit_);
    gl.BindVertexArray(vertex_array_.get());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.get());
    gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(Vertex)), vertices.data(),
                  GL_STATIC_DRAW);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(surface.triangles.size() * sizeof(Triangle)),
                  surface.triangles.data(), GL_STATIC_DRAW);
    set_attribute(gl, 0, 3, offsetof(Vertex, position));
    set_attribute(gl, 1, 3, offsetof(Vertex, normal));
    set_attribute(gl, 2, 2, offsetof(Vertex, uv));
    set_attribute(gl, 3, 4, offsetof(Vertex, color));
    set_attribute(gl, 4, 4, offsetof(Vertex, block));
    set_attribute(gl, 5, 4, offsetof(Vertex, tangent));
    check_gl(gl, "uploading a surface");
}

void GlSurface::draw(const GladGLContext& gl, const GlProgram& program,
                     const TileView& view) const {
    gl.BindVertexArray(vertex_array_.get());
    for (const Mat4d& placement : placements_) {
        const Mat4d eye_from_local = view.eye_from_scene * placement * local_from_unit_;
        program.set("clip_from_local", glm::mat4(view.clip_from_eye * eye_from_local));
        program.set("eye_from_local", glm::mat4(eye_from_local));
        program.set("normal_from_local", normal_matrix(eye_from_local));
        gl.DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    }
}

}  // namespace burl
