#include "app/gl/device/source.h"

namespace burl {

bool has_float64(const GladGLContext& gl) {
    GLint major = 0, count = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    if (major >= 4) return true;
    gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* name = reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, GLuint(i)));
        if (std::string_view(name) == "GL_ARB_gpu_shader_fp64") return true;
    }
    return false;
}

GlProgram make_program(const GladGLContext& gl, const std::string& name, const ShaderSource& vertex,
                       const ShaderSource& fragment) {
    return GlProgram::from_source(
        gl, name, vertex.text(), fragment.text(), [&](GLenum kind, std::string_view log) {
            return (kind == GL_VERTEX_SHADER ? vertex : fragment).with_names(log);
        });
}

GlProgram make_full_screen_program(const GladGLContext& gl, const std::string& name,
                                   const ShaderSource& fragment) {
    return make_program(gl, name, ShaderSource().add("maps/full_screen.vert"), fragment);
}

}  // namespace burl
