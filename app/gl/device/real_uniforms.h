#pragma once
// Uniforms of a shader's type `real` (shaders/numbers/real.glsl): float64 where the shader was
// compiled so, else the same numbers as float32.
#include <span>
#include <vector>

#include "app/gl/device/objects.h"

namespace burl {

class GlRealUniforms {
  public:
    GlRealUniforms(const GladGLContext& gl, bool float64) : gl_(&gl), float64_(float64) {}

    /// An array of `real` of the program in use; nothing happens where it has none of that name or
    /// there are no values.
    void set(const GlProgram& program, const char* name, std::span<const double> values) const {
        const std::vector<float> floats(values.begin(), values.end());
        const GLint at = program.uniform(name);
        if (float64_)
            gl_->Uniform1dv(at, GLsizei(values.size()), values.data());
        else
            gl_->Uniform1fv(at, GLsizei(values.size()), floats.data());
    }
    /// The same of `real3`.
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
