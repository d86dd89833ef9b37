#pragma once
// Textures in the formats of synthesis, and arrays that shaders index. All lookups are texelFetch,
// so nothing is filtered or wrapped.
#include <span>
#include <string_view>

#include "app/gl/device/objects.h"
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
    /// Binds the array as the buffer texture of a unit (0, 1, ...).
    void bind(int unit) const;

  private:
    const GladGLContext* gl_;
    GlBuffer buffer_;
    GlTexture texture_;
};

}  // namespace burl
