#pragma once
// What an OpenGL context is and can do, for `burl list gl`.
#include <string>
#include <vector>

#include "app/gl_context.h"

namespace burl {

struct GlFact {
    std::string name, value;
};

/// Renderer, vendor, versions, float64 and the limits that synthesis meets. The context becomes
/// current. Throws Error(runtime) when OpenGL fails.
std::vector<GlFact> gl_facts(GlContext& context);

}  // namespace burl
