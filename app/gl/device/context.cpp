#include "app/gl/device/context.h"

#include <glad/gl.h>

#include <array>

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

}  // namespace burl
