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
    /// Where the context comes from, with renderer and version, for reports.
    virtual std::string description() const = 0;
    /// Functions of OpenGL 3.3 core at least; call them while the context is current.
    const GladGLContext& gl() const { return *functions_; }

  protected:
    GlContext();
    /// Fills the table; the context must be current. Throws Error(unsupported) below 3.3.
    void load_functions(const std::string& origin);

  private:
    std::unique_ptr<GladGLContext> functions_;
};

/// Names under which OSMesa is looked for, newest first.
std::span<const char* const> osmesa_library_names();

/// A software context without window or display, through OSMesa. The library is loaded here and
/// not linked, so that whatever needs no picture runs without it. The new context is current.
/// Throws Error(unsupported) when no library is found or it lacks OpenGL 3.3 core.
std::unique_ptr<GlContext> create_osmesa_context(
    std::span<const char* const> library_names = osmesa_library_names());

}  // namespace burl
