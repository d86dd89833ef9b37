#pragma once
// Emitted shaders drawn by OpenGL into an image.
#include <string>
#include <vector>

#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "procedural/batch/point_map.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {

class EmittedShaderTest : public GlTest {
  protected:
    /// The values that the shader's main function draws from the solid map, four per texel.
    std::vector<float> draw(const std::string& shader, const SolidMap& map, const Vec3d& base) {
        const GladGLContext& gl = context->gl();
        const GlProgram program = make_full_screen_program(gl, "an emitted shader",
                                                           ShaderSource().add("emitted", shader));
        const GlSize size(int(map.local.width()), int(map.local.height()));
        const GlTexture texture = make_texture(gl, GL_RGBA32F, size, map.local.pixels());
        const GlTarget target(gl, size, {GL_RGBA32F});
        target.bind();
        program.use();
        program.set("solid_map", 0);
        program.set("solid_base", Vec3f(base));
        bind_texture(gl, 0, texture);
        GlFullScreen(gl).draw();
        return target.read<float>();
    }
};

}  // namespace burl
