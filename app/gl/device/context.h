#pragma once
// An OpenGL context from any window-system library, with its function table. A program may hold
// several; each has a table of its own.
#include <memory>
#include <span>
#include <string>

struct GladGLContext;  // <glad/gl.h>, generated at build time

namespace burl {

using GlProcedure = void (*)();

class GlContext {
  public:
    virtual ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// Makes this the calling thread's current context. Throws Error(runtime).
    virtual void make_current() = 0;
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
std::span<const char* const> osmesa_library_names();
/// The file names of the EGL library, newest first.
std::span<const char* const> egl_library_names();

/// Creates a software context without window or display through OSMesa, with the highest version
/// that it gives, and makes it current. The library is loaded at run time, so that programs that
/// draw nothing run without it. Throws Error(unsupported) when no library is found or it lacks
/// OpenGL 3.3 core.
std::unique_ptr<GlContext> create_osmesa_context(
    std::span<const char* const> library_names = osmesa_library_names());

/// Creates a context without window or display through EGL, with the highest version that it gives,
/// and makes it current: on the first of EGL's hardware devices that works, else on Mesa's
/// surfaceless platform, else on EGL's software devices. The library is loaded at run time. Throws
/// Error(unsupported) when no library is found or none of them gives OpenGL 3.3 core.
std::unique_ptr<GlContext> create_egl_context(
    std::span<const char* const> library_names = egl_library_names());

/// Creates a context by platform name, "osmesa" or "egl". Throws Error: usage for other names, and
/// as create_osmesa_context and create_egl_context do.
std::unique_ptr<GlContext> create_gl_context(const std::string& platform);

/// The names that create_gl_context knows; the first is the default.
std::span<const char* const> gl_platforms();

}  // namespace burl
