#pragma once
// What an OpenGL context is and can do, for `burl list gl` and for who chooses between it and the
// host.
#include <string>
#include <vector>

#include "app/gl/device/context.h"

namespace burl {

struct GlFact {
    std::string name, value;
};

/// Renderer, vendor, versions, float64 and the limits that synthesis meets. The context becomes
/// current. Throws Error(runtime) when OpenGL fails.
std::vector<GlFact> gl_facts(GlContext& context);

/// Whether its work is done by the machine's ordinary processors. The context must be current.
bool is_software(const GladGLContext& gl);

}  // namespace burl
