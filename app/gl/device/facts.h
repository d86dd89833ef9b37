#pragma once
// Properties of an OpenGL context, for `burl list gl` and for the choice between OpenGL and the
// host.
#include <string>
#include <vector>

#include "app/gl/device/context.h"

namespace burl {

struct GlFact {
    std::string name, value;
};

/// Renderer, vendor, versions, float64 support and the limits that matter to synthesis. Makes the
/// context current. Throws Error(runtime) when OpenGL fails.
std::vector<GlFact> gl_facts(GlContext& context);

/// Whether the renderer is software on the host's processor. The context must be current.
bool is_software(const GladGLContext& gl);

}  // namespace burl
