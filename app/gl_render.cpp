// Everything is drawn into float32 linear light, tile by tile, and averaged and sRGB-encoded on the
// host, so that the result depends neither on the machine's blending nor on its encoder.
#include "app/gl_render.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/gl_objects.h"
#include "atlas/error.h"

namespace burl {

namespace {

constexpr int tile_samples = 2048;  // largest side of the float target: 64 MiB of colour

struct Vertex {
    Vec3f position, normal;
    glm::vec2 uv;
    Vec4f color, block, tangent;
};

/// A surface on the GPU. Positions are moved and scaled into [-1,1] so that float32 suffices
/// wherever the surface lies.
struct GpuSurface {
    GlVertexArray vertex_array;
    GlBuffer vertices, indices;
    GLsizei index_count = 0;
    Mat4d local_from_unit{1.0};
    SceneMaterial material;
    bool in_blocks = false;  ///< lookups are clamped to the vertices' blocks
    bool bumped = false;     ///< has a normal map and tangents for it
    std::vector<Mat4d> placements;
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

GpuSurface upload(const GladGLContext& gl, const Surface& surface) {
    GpuSurface gpu;
    gpu.material = surface.material;
    gpu.placements = surface.placements;
    gpu.in_blocks = !surface.blocks.empty();
    gpu.bumped = surface.material.normals >= 0 && !surface.tangents.empty();
    gpu.local_from_unit = unit_frame(surface);
    gpu.index_count = GLsizei(3 * surface.triangles.size());
    const std::vector<Vertex> vertices = pack_vertices(surface, gpu.local_from_unit);

    gpu.vertex_array = make_vertex_array(gl);
    gl.BindVertexArray(gpu.vertex_array.get());
    gpu.vertices = make_buffer(gl);
    gl.BindBuffer(GL_ARRAY_BUFFER, gpu.vertices.get());
    gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(Vertex)), vertices.data(),
                  GL_STATIC_DRAW);
    gpu.indices = make_buffer(gl);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, gpu.indices.get());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(surface.triangles.size() * sizeof(Triangle)),
                  surface.triangles.data(), GL_STATIC_DRAW);
    set_attribute(gl, 0, 3, offsetof(Vertex, position));
    set_attribute(gl, 1, 3, offsetof(Vertex, normal));
    set_attribute(gl, 2, 2, offsetof(Vertex, uv));
    set_attribute(gl, 3, 4, offsetof(Vertex, color));
    set_attribute(gl, 4, 4, offsetof(Vertex, block));
    set_attribute(gl, 5, 4, offsetof(Vertex, tangent));
    check_gl(gl, "uploading a surface");
    return gpu;
}

GLint wrap_mode(TextureWrap wrap) {
    switch (wrap) {
        case TextureWrap::repeat:
            return GL_REPEAT;
        case TextureWrap::mirror:
            return GL_MIRRORED_REPEAT;
        case TextureWrap::clamp:
            break;
    }
    return GL_CLAMP_TO_EDGE;
}

/// Rows lie without gaps.
void upload_level(const GladGLContext& gl, GLint level, const Image<Rgb8>& image, bool is_color) {
    gl.TexImage2D(GL_TEXTURE_2D, level, is_color ? GL_SRGB8 : GL_RGB8, GLsizei(image.width()),
                  GLsizei(image.height()), 0, GL_RGB, GL_UNSIGNED_BYTE, image.pixels().data());
}

/// Box means, and in their place the file's own levels as far as those go.
void upload_levels(const GladGLContext& gl, const SceneTexture& texture) {
    gl.GenerateMipmap(GL_TEXTURE_2D);
    for (std::size_t l = 1; l <= texture.levels.size(); ++l)
        upload_level(gl, GLint(l), texture.levels[l - 1], texture.is_color);
}

void set_filter(const GladGLContext& gl, TextureFilter filter, const SceneTexture& texture) {
    const bool nearest = filter == TextureFilter::nearest;
    const bool mip = filter == TextureFilter::mip;
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                     nearest ? GL_NEAREST : (mip ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR));
    if (mip) upload_levels(gl, texture);
}

/// Colours as an sRGB texture: lookups decode each texel to linear light before they filter.
GlTexture upload(const GladGLContext& gl, const SceneTexture& texture, TextureFilter filter) {
    const Image<Rgb8>& image = texture.image;
    GLint limit = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (std::max(image.width(), image.height()) > std::size_t(limit)) {
        throw Error(ExitCode::unsupported,
                    fmt::format("the texture of {}x{} texels is larger than this OpenGL draws "
                                "({}); bake it at --size {} or less",
                                image.width(), image.height(), limit, limit));
    }
    GlTexture result = make_texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, result.get());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    upload_level(gl, 0, image, texture.is_color);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_mode(texture.wrap_u));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_mode(texture.wrap_v));
    set_filter(gl, filter, texture);
    check_gl(gl, fmt::format("uploading a texture of {}x{} texels", image.width(), image.height()));
    return result;
}

/// A rectangle of samples of the picture, y down.
struct Tile {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Takes the whole picture's clip space to the tile's, turned over so that rows come top first.
Mat4d tile_from_clip(const Tile& tile, const PictureSize& samples) {
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

class Drawing {
  public:
    Drawing(const GladGLContext& gl, const Scene& scene, std::optional<TextureFilter> filter)
        : gl_(gl), program_(gl, "mesh.vert", "mesh.frag") {
        for (const SceneTexture& texture : scene.textures) {
            textures_.push_back(upload(gl, texture, filter.value_or(texture.filter)));
        }
        // Textures in blocks can be minified here, whatever the file asks other viewers to do.
        if (!filter) minify_blocks(scene);
        clamp_to_blocks_ = !filter || *filter == TextureFilter::mip;
        white_ = upload(gl, {Image<Rgb8>(1, 1, {255, 255, 255})}, TextureFilter::nearest);
        for (const Surface& surface : scene.surfaces) surfaces_.push_back(upload(gl, surface));
    }

    /// Draws one tile into the bound framebuffer.
    void draw(const Camera& camera, const PictureSize& samples, const Tile& tile, bool lit) const {
        const Vec3d back = background_linear();
        gl_.Viewport(0, 0, tile.width, tile.height);
        gl_.ClearColor(float(back.x), float(back.y), float(back.z), 1.0f);
        gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl_.Enable(GL_DEPTH_TEST);
        gl_.UseProgram(program_.get());
        gl_.Uniform1i(program_.uniform("lit"), lit ? 1 : 0);
        gl_.Uniform1f(program_.uniform("ambient"), float(ambient));
        gl_.Uniform1i(program_.uniform("base_color"), 0);
        gl_.Uniform1i(program_.uniform("normal_map"), 1);

        // Eye space in units of the far distance, so that float32 holds scenes of any size.
        Camera unit = camera;
        unit.near_distance /= camera.far_distance;
        unit.far_distance = 1.0;
        Mat4d eye_from_scene(1.0 / camera.far_distance);
        eye_from_scene[3][3] = 1.0;
        eye_from_scene = eye_from_scene * camera.eye_from_scene();
        const Mat4d clip_from_eye = tile_from_clip(tile, samples) * unit.clip_from_eye();
        for (const GpuSurface& surface : surfaces_) draw(surface, eye_from_scene, clip_from_eye);
        check_gl(gl_, "drawing");
    }

  private:
    void minify_blocks(const Scene& scene) {
        for (const Surface& surface : scene.surfaces) {
            if (surface.blocks.empty()) continue;
            for (const int number : {surface.material.texture, surface.material.normals}) {
                if (number < 0) continue;
                const SceneTexture& texture = scene.textures[std::size_t(number)];
                if (texture.filter != TextureFilter::linear) continue;
                textures_[std::size_t(number)] = upload(gl_, texture, TextureFilter::mip);
            }
        }
    }

    /// White where there is none.
    void bind(GLenum unit, int number) const {
        const GlTexture& texture = number < 0 ? white_ : textures_[std::size_t(number)];
        gl_.ActiveTexture(unit);
        gl_.BindTexture(GL_TEXTURE_2D, texture.get());
    }

    void draw(const GpuSurface& surface, const Mat4d& eye_from_scene,
              const Mat4d& clip_from_eye) const {
        const SceneMaterial& material = surface.material;
        bind(GL_TEXTURE0, material.texture);
        bind(GL_TEXTURE1, material.normals);
        gl_.Uniform1i(program_.uniform("bumped"), surface.bumped ? 1 : 0);
        gl_.Uniform1f(program_.uniform("normal_scale"), material.normal_scale);
        gl_.Uniform4fv(program_.uniform("base_color_factor"), 1, &material.factor[0]);
        gl_.Uniform1i(program_.uniform("in_blocks"), surface.in_blocks && clamp_to_blocks_ ? 1 : 0);
        gl_.BindVertexArray(surface.vertex_array.get());
        for (const Mat4d& placement : surface.placements) {
            const Mat4d eye_from_local = eye_from_scene * placement * surface.local_from_unit;
            set("clip_from_local", glm::mat4(clip_from_eye * eye_from_local));
            set("eye_from_local", glm::mat4(eye_from_local));
            const glm::mat3 normal = normal_matrix(eye_from_local);
            gl_.UniformMatrix3fv(program_.uniform("normal_from_local"), 1, GL_FALSE, &normal[0][0]);
            gl_.DrawElements(GL_TRIANGLES, surface.index_count, GL_UNSIGNED_INT, nullptr);
        }
    }

    void set(const char* uniform, const glm::mat4& matrix) const {
        gl_.UniformMatrix4fv(program_.uniform(uniform), 1, GL_FALSE, &matrix[0][0]);
    }

    const GladGLContext& gl_;
    GlProgram program_;
    GlTexture white_;
    std::vector<GlTexture> textures_;
    std::vector<GpuSurface> surfaces_;
    bool clamp_to_blocks_ = false;
};

}  // namespace

Image<Rgb8> render_scene(GlContext& context, const Scene& scene, const Camera& camera,
                         const PictureOptions& options, std::optional<TextureFilter> filter) {
    context.make_current();
    const GladGLContext& gl = context.gl();
    const Drawing drawing(gl, scene, filter);
    const int n = options.supersample;
    const PictureSize samples{options.size.width * n, options.size.height * n};
    const int side = tile_samples / n * n;
    const GlFramebuffer target(gl, std::min(side, samples.width), std::min(side, samples.height));
    const SrgbEncoder<std::uint8_t> encode;

    Image<Rgb8> picture(std::size_t(options.size.width), std::size_t(options.size.height));
    for (int y = 0; y < samples.height; y += side) {
        for (int x = 0; x < samples.width; x += side) {
            const Tile tile{x, y, std::min(side, samples.width - x),
                            std::min(side, samples.height - y)};
            drawing.draw(camera, samples, tile, options.lit);
            Image<RgbF> drawn(std::size_t(tile.width), std::size_t(tile.height));
            gl.ReadPixels(0, 0, tile.width, tile.height, GL_RGB, GL_FLOAT, drawn.row(0).data());
            check_gl(gl, "reading the picture back");
            resolve_samples(drawn, n, encode, picture, std::size_t(x / n), std::size_t(y / n));
        }
    }
    return picture;
}

}  // namespace burl
