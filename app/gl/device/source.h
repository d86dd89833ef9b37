#pragma once
// Programs of OpenGL from the texts of app/base/shader_source.h.
#include <string>

#include "app/base/shader_source.h"
#include "app/gl/device/objects.h"

namespace burl {

/// Whether shaders can compute in float64: OpenGL 4.0, or the extension ARB_gpu_shader_fp64.
bool has_float64(const GladGLContext& gl);

/// Compiles and links; `name` stands in messages. Throws Error(runtime) with the compiler's log.
GlProgram make_program(const GladGLContext& gl, const std::string& name, const ShaderSource& vertex,
                       const ShaderSource& fragment);

/// With full_screen.vert, for GlFullScreen (app/gl/device/target.h).
GlProgram make_full_screen_program(const GladGLContext& gl, const std::string& name,
                                   const ShaderSource& fragment);

}  // namespace burl
