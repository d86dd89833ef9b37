#pragma once
// An OpenGL context whatever it comes from, with the functions of that context. A program may hold
// several; each has its own table of functions.
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

    /// Makes this the calling thread's context. Throws Error(runtime).
    virtual void make_current() = 0;
    /// Address of a GL function, null when the context has none of that name.
    virtual GlProcedure get_proc(const char* name) = 0;
    /// Where the context comes from, as "OSMesa".
    virtual std::string origin() const = 0;
    /// The origin with renderer and version, for reports; the context must be current.
    std::string description() const;
    /// Functions of OpenGL 3.3 core at least; call them while the context is current.
    const GladGLContext& gl() const { return *functions_; }

  protected:
    GlContext();
    /// Fills the table; the context must be current. Throws Error(unsupported) below 3.3.
    void load_functions(const std::string& library);

  private:
    std::unique_ptr<GladGLContext> functions_;
};

/// Names under which the libraries are looked for, newest first.
std::span<const char* const> osmesa_library_names();
std::span<const char* const> egl_library_names();

/// A software context without window or display, through OSMesa, of the highest version it gives.
/// The library is loaded here and not linked, so that whatever needs no picture runs without it.
/// The new context is current. Throws Error(unsupported) when no library is found or it lacks
/// OpenGL 3.3 core.
std::unique_ptr<GlContext> create_osmesa_context(
    std::span<const char* const> library_names = osmesa_library_names());

/// A context without window or display of a graphics processor, through EGL, of the highest
/// version it gives: the first of EGL's devices that works, else Mesa's surfaceless platform, else
/// EGL's software devices. Loaded and made current as OSMesa is. Throws Error(unsupported) when no
/// library is found or nothing of it gives OpenGL 3.3 core.
std::unique_ptr<GlContext> create_egl_context(
    std::span<const char* const> library_names = egl_library_names());

/// By name: "osmesa" or "egl". Throws Error: usage for others, and as the two above.
std::unique_ptr<GlContext> create_gl_context(const std::string& platform);

/// The names create_gl_context knows; the first is the default.
std::span<const char* const> gl_platforms();

}  // namespace burl
