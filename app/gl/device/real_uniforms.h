#pragma once
// Uniforms of the shader type `real` (shaders/numbers/real.glsl): float64 where the shader was
// compiled with it, else float32.
#include <span>
#include <vector>

#include "app/gl/device/objects.h"

namespace burl {

class GlRealUniforms {
  public:
    GlRealUniforms(const GladGLContext& gl, bool float64) : gl_(&gl), float64_(float64) {}

    /// Sets an array of `real` of the program in use; names that the program does not have, and
    /// empty arrays, are ignored.
    void set(const GlProgram& program, const char* name, std::span<const double> values) const {
        const std::vector<float> floats(values.begin(), values.end());
        const GLint at = program.uniform(name);
        if (float64_)
            gl_->Uniform1dv(at, GLsizei(values.size()), values.data());
        else
            gl_->Uniform1fv(at, GLsizei(values.size()), floats.data());
    }
    /// Sets an array of `real3` of the program in use; names that the program does not have, and
    /// empty arrays, are ignored.
    void set(const GlProgram& program, const char* name, std::span<const Vec3d> values) const {
        const std::vector<Vec3f> floats(values.begin(), values.end());
        const GLint at = program.uniform(name);
        if (values.empty()) return;
        if (float64_)
            gl_->Uniform3dv(at, GLsizei(values.size()), &values[0].x);
        else
            gl_->Uniform3fv(at, GLsizei(values.size()), &floats[0].x);
    }

  private:
    const GladGLContext* gl_;
    bool float64_;
};

}  // namespace burl
