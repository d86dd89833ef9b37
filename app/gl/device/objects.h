#pragma once
// OpenGL objects that free themselves, programs from sources of app/base/shader_source.h, and
// OpenGL errors as burl::Error. An object belongs to one context, which must outlive it and be
// current wherever the object is created, used or destroyed.
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glad/gl.h>

#include "app/base/shader_source.h"
#include "app/gl/device/context.h"
#include "atlas/base/vec.h"

namespace burl {

/// Throws Error(runtime) naming `action` where OpenGL has recorded an error since the last check.
void check_gl(const GladGLContext& gl, std::string_view action);

/// The name of an OpenGL object, with the functions that generate and delete such names.
template <PFNGLGENTEXTURESPROC GladGLContext::*Generate,
          PFNGLDELETETEXTURESPROC GladGLContext::*Delete>
class GlName {
  public:
    /// No object.
    GlName() = default;
    /// A new object.
    explicit GlName(const GladGLContext& gl) : gl_(&gl) { (gl.*Generate)(1, &name_); }
    GlName(GlName&& other) noexcept
        : gl_(std::exchange(other.gl_, nullptr)), name_(std::exchange(other.name_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlName() {
        if (gl_ != nullptr) (gl_->*Delete)(1, &name_);
    }
    GLuint get() const { return name_; }

  private:
    const GladGLContext* gl_ = nullptr;
    GLuint name_ = 0;
};

using GlTexture = GlName<&GladGLContext::GenTextures, &GladGLContext::DeleteTextures>;
using GlBuffer = GlName<&GladGLContext::GenBuffers, &GladGLContext::DeleteBuffers>;
using GlVertexArray = GlName<&GladGLContext::GenVertexArrays, &GladGLContext::DeleteVertexArrays>;
using GlRenderbuffer =
    GlName<&GladGLContext::GenRenderbuffers, &GladGLContext::DeleteRenderbuffers>;
using GlFramebufferName =
    GlName<&GladGLContext::GenFramebuffers, &GladGLContext::DeleteFramebuffers>;
using GlQuery = GlName<&GladGLContext::GenQueries, &GladGLContext::DeleteQueries>;

/// A linked program of one vertex and one fragment shader.
class GlProgram {
  public:
    /// Compiles and links; messages call the program `name`. Throws Error(runtime) with the
    /// compiler's log, which names parts and their lines.
    GlProgram(const GladGLContext& gl, const std::string& name, const ShaderSource& vertex,
              const ShaderSource& fragment);
    /// Compiles and links two files of shaders/. Throws Error(runtime) with the compiler's log.
    GlProgram(const GladGLContext& gl, std::string_view vertex_shader,
              std::string_view fragment_shader);
    GlProgram(GlProgram&& other) noexcept;
    GlProgram& operator=(GlProgram&&) = delete;
    ~GlProgram();

    GLuint get() const { return program_; }
    /// Makes this the program of the following draws.
    void use() const { gl_->UseProgram(program_); }
    /// Sets a uniform of the program in use; names that the program does not have are ignored.
    void set(const char* name, int value) const { gl_->Uniform1i(uniform(name), value); }
    void set(const char* name, const glm::ivec2& v) const {
        gl_->Uniform2i(uniform(name), v.x, v.y);
    }
    void set(const char* name, const glm::ivec3& v) const {
        gl_->Uniform3i(uniform(name), v.x, v.y, v.z);
    }
    void set(const char* name, std::uint32_t value) const { gl_->Uniform1ui(uniform(name), value); }
    void set(const char* name, const glm::uvec3& v) const {
        gl_->Uniform3ui(uniform(name), v.x, v.y, v.z);
    }
    void set(const char* name, float value) const { gl_->Uniform1f(uniform(name), value); }
    void set(const char* name, const glm::vec2& v) const {
        gl_->Uniform2f(uniform(name), v.x, v.y);
    }
    void set(const char* name, const Vec3f& v) const {
        gl_->Uniform3f(uniform(name), v.x, v.y, v.z);
    }
    void set(const char* name, const Vec4f& v) const {
        gl_->Uniform4f(uniform(name), v.x, v.y, v.z, v.w);
    }
    void set(const char* name, std::span<const Vec4f> values) const {
        gl_->Uniform4fv(uniform(name), GLsizei(values.size()), &values[0].x);
    }
    void set(const char* name, const glm::mat3& m) const {
        gl_->UniformMatrix3fv(uniform(name), 1, GL_FALSE, &m[0][0]);
    }
    void set(const char* name, const glm::mat4& m) const {
        gl_->UniformMatrix4fv(uniform(name), 1, GL_FALSE, &m[0][0]);
    }
    /// Sets a float64 uniform of the program in use. Throws Error(unsupported) below OpenGL 4.0.
    void set(const char* name, double value) const;
    void set(const char* name, const Vec3d& v) const;
    void set(const char* name, const Vec4d& v) const;
    void set(const char* name, const Mat3d& m) const;
    void set(const char* name, const Mat4d& m) const;
    /// The location of a uniform; -1, which set() ignores, where the program has none of that name.
    GLint uniform(const char* name) const;

    /// Sets an array of the shader type `real` or `real3` (shaders/numbers/real.glsl) of the
    /// program in use: float64 where the shader was compiled with it, else float32. Names that the
    /// program does not have, and empty arrays, are ignored.
    void set_reals(const char* name, std::span<const double> values, bool float64) const;
    void set_reals(const char* name, std::span<const Vec3d> values, bool float64) const;

  private:
    const GladGLContext* gl_;
    GLuint program_ = 0;
};

/// Compiles and links a fragment shader with full_screen.vert, for GlFullScreen
/// (app/gl/device/target.h). Throws Error as GlProgram does.
GlProgram make_full_screen_program(const GladGLContext& gl, const std::string& name,
                                   const ShaderSource& fragment);

/// An off-screen framebuffer: linear RGBA float32 colour and 32-bit float depth.
class GlFramebuffer {
  public:
    /// Throws Error(runtime) where the size is more than OpenGL can hold.
    GlFramebuffer(const GladGLContext& gl, int width, int height);
    void bind() const;

  private:
    const GladGLContext& gl_;
    GlRenderbuffer color_, depth_;
    GlFramebufferName framebuffer_;
};

}  // namespace burl
