#include "app/gl_context.h"

#include <glad/gl.h>

#include "atlas/error.h"

namespace burl {

GlContext::GlContext() : functions_(std::make_unique<GladGLContext>()) {}
GlContext::~GlContext() = default;

void GlContext::load_functions(const std::string& origin) {
    const auto load = [](void* context, const char* name) -> GLADapiproc {
        return static_cast<GlContext*>(context)->get_proc(name);
    };
    const int version = gladLoadGLContextUserPtr(functions_.get(), load, this);
    if (version < GLAD_MAKE_VERSION(3, 3)) {
        throw Error(ExitCode::unsupported,
                    fmt::format("{} gives OpenGL {}.{}, but drawing needs 3.3 or later", origin,
                                GLAD_VERSION_MAJOR(version), GLAD_VERSION_MINOR(version)));
    }
}

}  // namespace burl
