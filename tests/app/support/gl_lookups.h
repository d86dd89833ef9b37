#pragma once
// Lookups of a texture by OpenGL's own samplers, at given places with given steps.
#include <cstdlib>
#include <span>
#include <vector>

#include "app/base/shader_source.h"
#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "tests/app/support/viewed_mesh.h"

namespace burl {

/// Turns the software driver's own shortcuts off: levels by the larger component of the steps, and
/// a blend that stays on levels. The driver reads them when it starts.
inline void ask_for_exact_lookups() {
    setenv("GALLIVM_PERF", "no_rho_approx,no_brilinear,no_quad_lod", 1);
}

/// The levels as a texture with trilinear filtering of at most `most` probes, clamped to its edge.
inline GlTexture uploaded_levels(const GladGLContext& gl, const MipChain<Vec3f>& chain, int most) {
    GlTexture texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.get());
    for (std::size_t l = 0; l < chain.levels.size(); ++l)
        gl.TexImage2D(GL_TEXTURE_2D, int(l), GL_RGB32F, int(chain.levels[l].width()),
                      int(chain.levels[l].height()), 0, GL_RGB, GL_FLOAT,
                      chain.levels[l].pixels().data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    constexpr GLenum max_anisotropy = 0x84FE;
    gl.TexParameterf(GL_TEXTURE_2D, max_anisotropy, float(most));
    check_gl(gl, "uploading levels");
    return texture;
}

/// The values of lookups in `chain` by OpenGL, each in a square of two by two pixels whose lower
/// left one lies at its place.
inline std::vector<Vec3d> gl_lookups(const GladGLContext& gl, const MipChain<Vec3f>& chain,
                                     const std::vector<Lookup>& lookups, int most) {
    const GlTexture texture = uploaded_levels(gl, chain, most);
    const auto count = std::uint32_t(lookups.size());
    std::vector<float> data;
    const double size = double(chain.levels[0].width());
    for (const Lookup& one : lookups)
        for (const double v : {one.at.x, one.at.y, one.steps.x.x, one.steps.x.y, one.steps.y.x,
                               one.steps.y.y, 0.0, 0.0})
            data.push_back(float(v / size));
    const GlTexture places =
        make_texture(gl, GL_RGBA32F, {2, int(count)}, std::span<const float>(data));
    const GlProgram program = make_full_screen_program(
        gl, "lookups",
        ShaderSource().add(
            "lookups.frag",
            "uniform sampler2D map; uniform sampler2D places; out vec4 color;\n"
            "void main() {\n"
            "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
            "    vec4 a = texelFetch(places, ivec2(0, pixel.y / 2), 0);\n"
            "    vec4 b = texelFetch(places, ivec2(1, pixel.y / 2), 0);\n"
            "    vec2 uv = a.xy + float(pixel.x % 2) * a.zw + float(pixel.y % 2) * b.xy;\n"
            "    color = texture(map, uv);\n"
            "}"));
    const GlTarget target(gl, {2, int(2 * count)}, {GL_RGBA32F});
    target.bind();
    program.use();
    bind_texture(gl, program, "map", 0, texture);
    bind_texture(gl, program, "places", 1, places);
    gl.ActiveTexture(GL_TEXTURE0);
    GlFullScreen(gl).draw();
    check_gl(gl, "looking up");
    const std::vector<float> read = target.read<float>();
    std::vector<Vec3d> values;
    for (std::size_t i = 0; i < count; ++i)
        values.emplace_back(read[16 * i], read[16 * i + 1], read[16 * i + 2]);
    return values;
}

}  // namespace burl
