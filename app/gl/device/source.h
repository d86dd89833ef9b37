#pragma once
// OpenGL programs from sources of app/base/shader_source.h.
#include <string>

#include "app/base/shader_source.h"
#include "app/gl/device/objects.h"

namespace burl {

/// Whether shaders can compute in float64: OpenGL 4.0, or the extension ARB_gpu_shader_fp64.
bool has_float64(const GladGLContext& gl);

/// Compiles and links; messages call the program `name`. Throws Error(runtime) with the compiler's
/// log, which names parts and their lines.
GlProgram make_program(const GladGLContext& gl, const std::string& name, const ShaderSource& vertex,
                       const ShaderSource& fragment);

/// Compiles and links a fragment shader with full_screen.vert, for GlFullScreen
/// (app/gl/device/target.h). Throws Error as make_program does.
GlProgram make_full_screen_program(const GladGLContext& gl, const std::string& name,
                                   const ShaderSource& fragment);

}  // namespace burl
