#pragma once
// An OpenGL context from any window-system library, with its function table and its properties. A
// program may hold several; each has a table of its own.
#include <array>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

struct GladGLContext;  // <glad/gl.h>, generated at build time

namespace burl {

using GlProcedure = void (*)();

/// The OpenGL core versions that contexts are requested with, in turn, since a library may give
/// exactly the version requested.
inline constexpr std::array<std::pair<int, int>, 8> gl_versions{
    {{4, 6}, {4, 5}, {4, 4}, {4, 3}, {4, 2}, {4, 1}, {4, 0}, {3, 3}}};

class GlContext {
  public:
    virtual ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// Makes this the calling thread's current context. Throws Error(runtime).
    virtual void make_current() = 0;
    /// Makes no context current in the calling thread, so that another thread may make this one so.
    virtual void release() = 0;
    /// A context for another thread, with which this one shares textures, buffers and programs; it
    /// is current nowhere. It must be made by the thread that made this one, which destroys both.
    /// Throws Error(unsupported) where the library gives none.
    virtual std::unique_ptr<GlContext> share() = 0;
    /// The address of an OpenGL function; null where the context has none of that name.
    virtual GlProcedure get_proc(const char* name) = 0;
    /// The library that the context comes from, such as "OSMesa".
    virtual std::string origin() const = 0;
    /// The origin with renderer and version, for reports; the context must be current.
    std::string description() const;
    /// The functions of OpenGL 3.3 core or later, for use while the context is current.
    const GladGLContext& gl() const { return *functions_; }

  protected:
    GlContext();
    /// Fills the function table; the context must be current. Throws Error(unsupported) below 3.3.
    void load_functions(const std::string& library);

  private:
    std::unique_ptr<GladGLContext> functions_;
};

/// The file names of the OSMesa library, newest first.
inline constexpr std::array osmesa_library_names{"libOSMesa.so.8", "libOSMesa.so.6",
                                                 "libOSMesa.so"};
/// The file names of the EGL library, newest first.
inline constexpr std::array egl_library_names{"libEGL.so.1", "libEGL.so"};

/// Creates a software context without window or display through OSMesa, with the highest version
/// that it gives, and makes it current. The library is loaded at run time, so that programs that
/// draw nothing run without it. Throws Error(unsupported) when no library is found or it lacks
/// OpenGL 3.3 core.
std::unique_ptr<GlContext> create_osmesa_context(
    std::span<const char* const> library_names = osmesa_library_names);

/// Creates a context without window or display through EGL, with the highest version that it gives,
/// and makes it current: on the first of EGL's hardware devices that works, else on Mesa's
/// surfaceless platform, else on EGL's software devices. The library is loaded at run time. Throws
/// Error(unsupported) when no library is found or none of them gives OpenGL 3.3 core.
std::unique_ptr<GlContext> create_egl_context(
    std::span<const char* const> library_names = egl_library_names);

/// Creates a context by platform name, "osmesa" or "egl". Throws Error: usage for other names, and
/// as create_osmesa_context and create_egl_context do.
std::unique_ptr<GlContext> create_gl_context(const std::string& platform);

/// The names that create_gl_context knows; the first is the default.
std::span<const char* const> gl_platforms();

/// Whether the renderer is software on the host's processor. The context must be current.
bool is_software(const GladGLContext& gl);
/// Whether shaders can compute in float64: OpenGL 4.0, or the extension ARB_gpu_shader_fp64. The
/// context must be current.
bool has_float64(const GladGLContext& gl);

struct GlFact {
    std::string name, value;
};

/// Renderer, vendor, versions, float64 support and the limits that matter to synthesis. Makes the
/// context current. Throws Error(runtime) when OpenGL fails.
std::vector<GlFact> gl_facts(GlContext& context);

/// A context that is current in the calling thread until the scope ends; then none is.
class CurrentContext {
  public:
    explicit CurrentContext(GlContext& context) : context_(context) { context.make_current(); }
    CurrentContext(const CurrentContext&) = delete;
    CurrentContext& operator=(const CurrentContext&) = delete;
    ~CurrentContext() { context_.release(); }

  private:
    GlContext& context_;
};

}  // namespace burl
