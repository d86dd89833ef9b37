#pragma once
// Textures in the formats of synthesis, arrays that shaders index, render targets (textures with a
// framebuffer, so that one pass's result is the next one's input) and the draw call of a
// full-screen pass. All lookups are texelFetch, so nothing is filtered or wrapped. Targets larger
// than a few thousand texels a side do not fit every OpenGL's memory, so passes over whole textures
// are drawn in tiles.
#include <algorithm>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "app/gl/device/objects.h"
#include "atlas/base/error.h"
#include "atlas/base/vec.h"

namespace burl {

/// An internal format and the layout of its texels in host memory.
struct GlFormat {
    GLenum internal = 0;
    std::string_view name{};
    GLenum layout = 0;        ///< GL_RGBA, GL_RED_INTEGER, ...
    GLenum type = 0;          ///< the type of a component in host memory
    int components = 0;       ///< the number of components per texel
    int component_bytes = 0;  ///< the size of a component in host memory
};

/// The properties of a format that synthesis uses: R, RG and RGBA of 8 bits, 16F, 32F and 32UI,
/// RGB8, SRGB8, RGB32F, SRGB8_ALPHA8 and RGBA16. Half floats are floats in host memory. Throws
/// Error(runtime) for others.
const GlFormat& format_of(GLenum internal);

/// A width and height in texels.
using GlSize = glm::ivec2;

/// Creates a texture of one level with nearest filtering. `texels` are row 0 first without gaps, in
/// the format's own type; an empty span leaves them undefined. Throws Error: unsupported where a
/// side is beyond this OpenGL, runtime when memory runs out or the number of bytes is wrong.
GlTexture make_texture(const GladGLContext& gl, GLenum internal, GlSize size,
                       std::span<const std::byte> texels = {});

template <class T>
GlTexture make_texture(const GladGLContext& gl, GLenum internal, GlSize size,
                       std::span<const T> texels) {
    return make_texture(gl, internal, size, std::as_bytes(texels));
}

/// Binds the texture as the 2-D texture of a unit (0, 1, ...).
void bind_texture(const GladGLContext& gl, int unit, const GlTexture& texture);
/// Binds the texture to a unit, from which the program in use reads it as `name`.
void bind_texture(const GladGLContext& gl, const GlProgram& program, const char* name, int unit,
                  const GlTexture& texture);

/// An array that shaders read with texelFetch of a samplerBuffer, isamplerBuffer or usamplerBuffer.
class GlBufferTexture {
  public:
    /// Creates an array from at least one texel in the format's own type; formats are R, RG or RGBA
    /// of 8 bits, 32F or 32UI. Throws Error: unsupported for more texels than this OpenGL allows,
    /// runtime when memory runs out.
    GlBufferTexture(const GladGLContext& gl, GLenum internal, std::span<const std::byte> texels);
    template <class T>
    GlBufferTexture(const GladGLContext& gl, GLenum internal, std::span<const T> texels)
        : GlBufferTexture(gl, internal, std::as_bytes(texels)) {}
    /// Binds the array to a unit (0, 1, ...), from which the program in use reads it as `name`.
    void bind(const GlProgram& program, const char* name, int unit) const;

  private:
    const GladGLContext* gl_;
    GlBuffer buffer_;
    GlTexture texture_;
};

/// A rectangle of texels, row 0 first.
struct GlTile {
    glm::ivec2 origin{0};
    GlSize size{0};

    bool operator==(const GlTile&) const = default;
    std::size_t texels() const { return std::size_t(size.x) * std::size_t(size.y); }
};

/// The largest side of a tile, in texels: 256 MiB of RGBA32F.
constexpr int largest_tile = 4096;

/// Calls visit(GlTile) for tiles of at most `side` texels a side that cover `size`, row by row.
template <class Visit>
void for_tiles(GlSize size, int side, Visit visit) {
    for (int y = 0; y < size.y; y += side)
        for (int x = 0; x < size.x; x += side)
            visit(GlTile{{x, y}, {std::min(side, size.x - x), std::min(side, size.y - y)}});
}

/// One or more colour textures of equal size, drawn into together (the fragment shader's outputs 0,
/// 1, ...).
class GlTarget {
  public:
    /// Creates one texture per internal format. Throws Error: unsupported where the size, the
    /// number of textures or a format is beyond this OpenGL, runtime when memory runs out.
    GlTarget(const GladGLContext& gl, GlSize size, std::span<const GLenum> internals);
    GlTarget(const GladGLContext& gl, GlSize size, std::initializer_list<GLenum> internals)
        : GlTarget(gl, size, std::span(internals.begin(), internals.size())) {}

    GlSize size() const { return size_; }
    const GlTexture& texture(std::size_t number = 0) const { return textures_[number]; }
    const GlFormat& format(std::size_t number = 0) const { return *formats_[number]; }
    std::size_t count() const { return textures_.size(); }
    GLuint framebuffer() const { return framebuffer_.get(); }

    /// Binds the whole target for the following draws. None of its textures may be read by the same
    /// pass.
    void bind() const { bind({{0, 0}, size_}); }
    /// Binds a part of the target for the following draws: clip space -1 to 1 is `part`.
    void bind(const GlTile& part) const;
    /// Sets every texel of a texture of a fixed-point or float format; binds the target.
    void clear(std::size_t number, const Vec4f& value) const;
    /// Sets every texel of a texture of an integer format; binds the target.
    void clear(std::size_t number, const glm::uvec4& value) const;

    /// Reads the texels of `part`, rows without gaps, `components` (1, 3 or 4; 0: the format's own)
    /// per texel. T is the format's type in host memory (float for half floats). Waits for the
    /// draws before and binds the target. Throws Error(runtime) when `texels` has another size or
    /// type.
    template <class T>
    void read(std::span<T> texels, const GlTile& part, std::size_t number = 0,
              int components = 0) const {
        read_bytes(std::as_writable_bytes(texels), sizeof(T), part, number, components);
    }
    /// Reads all texels of a texture, with the format's own components.
    template <class T>
    std::vector<T> read(std::size_t number = 0) const {
        std::vector<T> texels(std::size_t(size_.x) * std::size_t(size_.y) *
                              std::size_t(format(number).components));
        read(std::span<T>(texels), {{0, 0}, size_}, number);
        return texels;
    }

  private:
    void read_bytes(std::span<std::byte> texels, std::size_t component_bytes, const GlTile& part,
                    std::size_t number, int components) const;

    const GladGLContext* gl_;
    GlSize size_;
    std::vector<const GlFormat*> formats_;
    std::vector<GlTexture> textures_;
    GlFramebufferName framebuffer_;
};

/// Runs a fragment shader once per texel of the bound target: one triangle larger than the target,
/// so that no texel is drawn twice. The vertex shader is full_screen.vert; gl_FragCoord.xy - 0.5 is
/// the texel in the target.
class GlFullScreen {
  public:
    explicit GlFullScreen(const GladGLContext& gl) : gl_(&gl), vertices_(gl) {}
    /// Draws the triangle; the program must be in use and the target bound.
    void draw() const {
        gl_->BindVertexArray(vertices_.get());
        gl_->DrawArrays(GL_TRIANGLES, 0, 3);
    }

  private:
    const GladGLContext* gl_;
    GlVertexArray vertices_;
};

}  // namespace burl
