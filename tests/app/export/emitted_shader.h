#pragma once
// Emitted shaders drawn by OpenGL into an image.
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "procedural/batch/point_map.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {

/// The emitted shader with a main function that shows `color`, an expression of `solid` and of its
/// material `m`.
inline std::string showing(std::string shader, const std::string& color) {
    const std::string main = "void main() {";
    shader.replace(shader.find(main), main.size(), "void emitted_main() {");
    return shader + fmt::format(R"(
void main() {{
    vec3 solid = solid_base + texelFetch(solid_map, ivec2(gl_FragCoord.xy), 0).xyz;
    TextureMaterial m = texture_material(solid);
    color = {};
}}
)",
                                color);
}

class EmittedShaderTest : public GlTest {
  protected:
    /// Names of uniforms with one or three numbers.
    using Uniforms = std::vector<std::pair<std::string, std::vector<float>>>;

    /// The values that the shader's main function draws from the solid map, four per texel.
    std::vector<float> draw(const std::string& shader, const SolidMap& map, const Vec3d& base,
                            const Uniforms& uniforms = {}) {
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
        for (const auto& [name, numbers] : uniforms)
            if (numbers.size() == 1)
                program.set(name.c_str(), numbers[0]);
            else
                program.set(name.c_str(), Vec3f(numbers[0], numbers[1], numbers[2]));
        bind_texture(gl, 0, texture);
        GlFullScreen(gl).draw();
        return target.read<float>();
    }
};

}  // namespace burl
