#include "app/gl/device/facts.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "app/gl/device/source.h"

namespace burl {

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

bool is_software(const GladGLContext& gl) {
    const auto* renderer = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    const std::string_view name(renderer ? renderer : "");
    return std::ranges::any_of(
        std::array{"llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SwiftShader"},
        [&](const char* software) { return name.find(software) != name.npos; });
}

}  // namespace burl
