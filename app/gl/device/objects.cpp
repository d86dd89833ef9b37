#include "app/gl/device/objects.h"

#include <algorithm>

#include "app/gl/device/literals.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

std::string_view error_name(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "invalid enumerant";
        case GL_INVALID_VALUE:
            return "invalid value";
        case GL_INVALID_OPERATION:
            return "invalid operation";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "invalid framebuffer operation";
        case GL_OUT_OF_MEMORY:
            return "out of memory";
        default:
            return "unknown error";
    }
}

template <class Get, class GetLog>
std::string info_log(GLuint object, Get get, GetLog get_log) {
    GLint length = 0;
    get(object, GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(std::max(length, 1)), '\0');
    get_log(object, GLsizei(log.size()), &length, log.data());
    log.resize(std::size_t(length));
    return log;
}

/// The beginning of a compiler's log as one line of a message, its lines separated by semicolons:
/// a compiler that is out of registers may name thousands of variables.
std::string in_one_line(const std::string& log) {
    constexpr std::size_t most = 400;
    std::string line;
    for (const char c : log.substr(0, log.find_last_not_of(" \n\r\t") + 1))
        line += c == '\n' ? std::string("; ") : std::string(1, c);
    return line.size() <= most ? line : line.substr(0, most) + " ...";
}

/// A compiled shader, deleted at the end of the scope that links it.
class Shader {
  public:
    Shader(const GladGLContext& gl, GLenum kind, const std::string& name,
           const ShaderSource& source)
        : gl_(gl), shader_(gl.CreateShader(kind)) {
        const std::string whole = with_exact_literals(source.text());
        const char* text = whole.data();
        const auto length = GLint(whole.size());
        gl_.ShaderSource(shader_, 1, &text, &length);
        gl_.CompileShader(shader_);
        GLint compiled = GL_FALSE;
        gl_.GetShaderiv(shader_, GL_COMPILE_STATUS, &compiled);
        if (compiled == GL_TRUE) return;
        const std::string log = info_log(shader_, gl_.GetShaderiv, gl_.GetShaderInfoLog);
        gl_.DeleteShader(shader_);
        throw Error(ExitCode::runtime, fmt::format("the {} shader of {} does not compile: {}",
                                                   kind == GL_VERTEX_SHADER ? "vertex" : "fragment",
                                                   name, in_one_line(source.with_names(log))));
    }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    ~Shader() { gl_.DeleteShader(shader_); }
    GLuint get() const { return shader_; }

  private:
    const GladGLContext& gl_;
    GLuint shader_;
};

template <class Function>
Function float64_uniform(Function function) {
    if (function == nullptr)
        throw Error(ExitCode::unsupported, "this OpenGL has no float64 uniforms (4.0 brings them)");
    return function;
}

}  // namespace

void check_gl(const GladGLContext& gl, std::string_view action) {
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) return;
    for (int more = 0; more < 8 && gl.GetError() != GL_NO_ERROR; ++more) {
    }
    throw Error(ExitCode::runtime,
                fmt::format("OpenGL failed while {}: {}", action, error_name(error)));
}

GlProgram::GlProgram(const GladGLContext& gl, const std::string& name, const ShaderSource& vertex,
                     const ShaderSource& fragment)
    : gl_(&gl) {
    const Shader vertices(gl, GL_VERTEX_SHADER, name, vertex);
    const Shader fragments(gl, GL_FRAGMENT_SHADER, name, fragment);
    program_ = gl_->CreateProgram();
    gl_->AttachShader(program_, vertices.get());
    gl_->AttachShader(program_, fragments.get());
    gl_->LinkProgram(program_);
    gl_->DetachShader(program_, vertices.get());
    gl_->DetachShader(program_, fragments.get());
    GLint linked = GL_FALSE;
    gl_->GetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return;
    const std::string log = info_log(program_, gl_->GetProgramiv, gl_->GetProgramInfoLog);
    gl_->DeleteProgram(program_);
    throw Error(ExitCode::unsupported,
                fmt::format("the shaders of {} do not link: {}", name, in_one_line(log)));
}

GlProgram::GlProgram(const GladGLContext& gl, std::string_view vertex_shader,
                     std::string_view fragment_shader)
    : GlProgram(gl, fmt::format("{} + {}", vertex_shader, fragment_shader),
                ShaderSource().add(vertex_shader), ShaderSource().add(fragment_shader)) {}

GlProgram::GlProgram(GlProgram&& other) noexcept
    : gl_(other.gl_), program_(std::exchange(other.program_, 0)) {}

GlProgram::~GlProgram() {
    if (program_ != 0) gl_->DeleteProgram(program_);
}

GLint GlProgram::uniform(const char* name) const {
    return gl_->GetUniformLocation(program_, name);
}

void GlProgram::set(const char* name, double value) const {
    float64_uniform(gl_->Uniform1d)(uniform(name), value);
}
void GlProgram::set(const char* name, const Vec3d& v) const {
    float64_uniform(gl_->Uniform3d)(uniform(name), v.x, v.y, v.z);
}
void GlProgram::set(const char* name, const Vec4d& v) const {
    float64_uniform(gl_->Uniform4d)(uniform(name), v.x, v.y, v.z, v.w);
}
void GlProgram::set(const char* name, const Mat3d& m) const {
    float64_uniform(gl_->UniformMatrix3dv)(uniform(name), 1, GL_FALSE, &m[0][0]);
}
void GlProgram::set(const char* name, const Mat4d& m) const {
    float64_uniform(gl_->UniformMatrix4dv)(uniform(name), 1, GL_FALSE, &m[0][0]);
}

void GlProgram::set_reals(const char* name, std::span<const double> values, bool float64) const {
    const std::vector<float> floats(values.begin(), values.end());
    if (float64)
        gl_->Uniform1dv(uniform(name), GLsizei(values.size()), values.data());
    else
        gl_->Uniform1fv(uniform(name), GLsizei(values.size()), floats.data());
}

void GlProgram::set_reals(const char* name, std::span<const Vec3d> values, bool float64) const {
    if (values.empty()) return;
    const std::vector<Vec3f> floats(values.begin(), values.end());
    if (float64)
        gl_->Uniform3dv(uniform(name), GLsizei(values.size()), &values[0].x);
    else
        gl_->Uniform3fv(uniform(name), GLsizei(values.size()), &floats[0].x);
}

GlProgram make_full_screen_program(const GladGLContext& gl, const std::string& name,
                                   const ShaderSource& fragment) {
    return {gl, name, ShaderSource().add("maps/full_screen.vert"), fragment};
}

GlFramebuffer::GlFramebuffer(const GladGLContext& gl, int width, int height)
    : gl_(gl), color_(gl), depth_(gl), framebuffer_(gl) {
    gl_.BindRenderbuffer(GL_RENDERBUFFER, color_.get());
    gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, width, height);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, depth_.get());
    gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
    bind();
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                color_.get());
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.get());
    const GLenum status = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER);
    check_gl(gl_, fmt::format("making a {}x{} picture", width, height));
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw Error(ExitCode::runtime,
                    fmt::format("OpenGL cannot draw into a {}x{} picture (status {:#x})", width,
                                height, status));
    }
}

void GlFramebuffer::bind() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
}

}  // namespace burl
