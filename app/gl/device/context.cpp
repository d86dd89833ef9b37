#include "app/gl/device/context.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <glad/gl.h>

#include "app/gl/device/objects.h"
#include "atlas/base/error.h"

namespace burl {

GlContext::GlContext() : functions_(std::make_unique<GladGLContext>()) {}
GlContext::~GlContext() = default;

std::string GlContext::description() const {
    const auto text = [&](GLenum name) {
        return reinterpret_cast<const char*>(gl().GetString(name));
    };
    return fmt::format("{}, {}, OpenGL {}", origin(), text(GL_RENDERER), text(GL_VERSION));
}

void GlContext::load_functions(const std::string& library) {
    const auto load = [](void* context, const char* name) -> GLADapiproc {
        return static_cast<GlContext*>(context)->get_proc(name);
    };
    const int version = gladLoadGLContextUserPtr(functions_.get(), load, this);
    if (version < GLAD_MAKE_VERSION(3, 3)) {
        throw Error(ExitCode::unsupported,
                    fmt::format("{} gives OpenGL {}.{}, but drawing needs 3.3 or later", library,
                                GLAD_VERSION_MAJOR(version), GLAD_VERSION_MINOR(version)));
    }
}

std::span<const char* const> gl_platforms() {
    static constexpr std::array names{"osmesa", "egl"};
    return names;
}

std::unique_ptr<GlContext> create_gl_context(const std::string& platform) {
    if (platform == "osmesa") return create_osmesa_context();
    if (platform == "egl") return create_egl_context();
    throw Error(ExitCode::usage, fmt::format("--gl {}: it must be osmesa or egl", platform));
}

bool is_software(const GladGLContext& gl) {
    const auto* renderer = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    const std::string_view name(renderer ? renderer : "");
    return std::ranges::any_of(
        std::array{"llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SwiftShader"},
        [&](const char* software) { return name.find(software) != name.npos; });
}

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

std::vector<GlFact> gl_facts(GlContext& context) {
    context.make_current();
    const GladGLContext& gl = context.gl();
    std::vector<GlFact> facts{{"context", context.origin()}};
    const auto text = [&](const char* name, GLenum which) {
        facts.push_back({name, reinterpret_cast<const char*>(gl.GetString(which))});
    };
    const auto limit = [&](const char* name, GLenum which, const char* unit) {
        GLint value = 0;
        gl.GetIntegerv(which, &value);
        facts.push_back({name, fmt::format("{}{}", value, unit)});
    };
    text("renderer", GL_RENDERER);
    text("vendor", GL_VENDOR);
    text("version", GL_VERSION);
    text("shading language", GL_SHADING_LANGUAGE_VERSION);
    facts.push_back({"float64 in shaders", has_float64(gl) ? "yes" : "no"});
    limit("largest texture", GL_MAX_TEXTURE_SIZE, " texels a side");
    limit("largest buffer texture", GL_MAX_TEXTURE_BUFFER_SIZE, " texels");
    limit("textures per shader", GL_MAX_TEXTURE_IMAGE_UNITS, "");
    limit("textures drawn together", GL_MAX_DRAW_BUFFERS, "");
    limit("largest target", GL_MAX_RENDERBUFFER_SIZE, " texels a side");
    GLint bits = 0;
    gl.GetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    facts.push_back({"timer", fmt::format("{} bits", bits)});
    check_gl(gl, "asking for limits");
    return facts;
}

}  // namespace burl
