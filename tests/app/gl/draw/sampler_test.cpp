// The samplers of `burl metrics --levels` against those of OpenGL: the same places and steps from
// pixel to pixel, looked up in the same levels, on meshes with atlases of ours and of the file's.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "app/base/shader_source.h"
#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/app/support/viewed_mesh.h"

namespace burl {
namespace {

class GlSamplerTest : public GlTest {
  protected:
    void SetUp() override {
        // The software driver's own shortcuts: levels by the larger component of the steps, and a
        // blend that stays on levels. They are read when the driver starts.
        setenv("GALLIVM_PERF", "no_rho_approx,no_brilinear,no_quad_lod", 1);
        GlTest::SetUp();
    }

    /// The values of lookups in `chain` by OpenGL, each in a square of two by two pixels whose
    /// lower left one lies at its place.
    std::vector<Vec3d> drawn(const MipChain<Vec3f>& chain, const std::vector<Lookup>& lookups,
                             int most) const {
        const GlTexture texture = uploaded(chain, most);
        const auto count = std::uint32_t(lookups.size());
        std::vector<float> data;
        const double size = double(chain.levels[0].width());
        for (const Lookup& one : lookups)
            for (const double v : {one.at.x, one.at.y, one.steps.x.x, one.steps.x.y, one.steps.y.x,
                                   one.steps.y.y, 0.0, 0.0})
                data.push_back(float(v / size));
        const GlTexture places =
            make_texture(gl(), GL_RGBA32F, {2, int(count)}, std::span<const float>(data));
        const GlProgram program = make_full_screen_program(
            gl(), "lookups",
            ShaderSource().add("lookups.frag",
                               "uniform sampler2D map; uniform sampler2D places; out vec4 color;\n"
                               "void main() {\n"
                               "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
                               "    vec4 a = texelFetch(places, ivec2(0, pixel.y / 2), 0);\n"
                               "    vec4 b = texelFetch(places, ivec2(1, pixel.y / 2), 0);\n"
                               "    vec2 uv = a.xy + float(pixel.x % 2) * a.zw + float(pixel.y % "
                               "2) * b.xy;\n"
                               "    color = texture(map, uv);\n"
                               "}"));
        const GlTarget target(gl(), {2, int(2 * count)}, {GL_RGBA32F});
        target.bind();
        program.use();
        bind_texture(gl(), program, "map", 0, texture);
        bind_texture(gl(), program, "places", 1, places);
        gl().ActiveTexture(GL_TEXTURE0);
        GlFullScreen(gl()).draw();
        check_gl(gl(), "looking up");
        const std::vector<float> read = target.read<float>();
        std::vector<Vec3d> values;
        for (std::size_t i = 0; i < count; ++i)
            values.emplace_back(read[16 * i], read[16 * i + 1], read[16 * i + 2]);
        return values;
    }

    const GladGLContext& gl() const { return context->gl(); }

  private:
    GlTexture uploaded(const MipChain<Vec3f>& chain, int most) const {
        GlTexture texture(gl());
        gl().BindTexture(GL_TEXTURE_2D, texture.get());
        for (std::size_t l = 0; l < chain.levels.size(); ++l)
            gl().TexImage2D(GL_TEXTURE_2D, int(l), GL_RGB32F, int(chain.levels[l].width()),
                            int(chain.levels[l].height()), 0, GL_RGB, GL_FLOAT,
                            chain.levels[l].pixels().data());
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        constexpr GLenum max_anisotropy = 0x84FE;
        gl().TexParameterf(GL_TEXTURE_2D, max_anisotropy, float(most));
        check_gl(gl(), "uploading levels");
        return texture;
    }
};

TEST_F(GlSamplerTest, ChoosesTheLevel) {
    MipChain<Vec3f> chain;
    for (std::size_t side = 256; side > 0; side /= 2)
        chain.levels.emplace_back(side, side, Vec3f(float(chain.levels.size())));
    std::vector<Lookup> lookups;
    for (int i = 0; i < 60; ++i)
        lookups.push_back({{100.0 + i, 90.0},
                           {std::exp2(0.1 * i) * Vec2d(std::cos(i), std::sin(i)),
                            std::exp2(0.08 * i) * Vec2d(std::sin(2.0 * i), std::cos(2.0 * i))}});
    const std::vector<Vec3d> levels = drawn(chain, lookups, 1);
    for (std::size_t i = 0; i < lookups.size(); ++i)
        EXPECT_NEAR(levels[i].x, sampler_lookup(chain, lookups[i].at, lookups[i].steps, 1).x, 0.05)
            << i;
}

class GlSamplerMeshTest : public GlSamplerTest,
                          public testing::WithParamInterface<std::pair<const char*, AtlasKind>> {};

// Rows' errors by OpenGL's own lookups are those that are measured, but for the logarithm, which
// this driver takes from a polynomial, up to 0.043 too low.
TEST_P(GlSamplerMeshTest, ErrorsOfViewsAreOpenGls) {
    const ViewedMesh viewed(GetParam().first, GetParam().second, 400);
    ASSERT_EQ(viewed.rows.size(), 25u);
    for (std::size_t r = 0; r < viewed.rows.size(); ++r) {
        const ViewRow& row = viewed.views.rows[r];
        const auto ratio = [&](int most) {
            return viewed.error(r, drawn(viewed.chain, viewed.rows[r], most)) /
                   viewed.error(r, viewed.values(r, most));
        };
        EXPECT_NEAR(ratio(1), 1.0, 0.05) << row.minification << ":1 " << row.tilt;
        // Anisotropy is the driver's own affair; this one's probes reach farther and lie closer.
        if (row.tilt > 80.0) {
            EXPECT_NEAR(ratio(16), 1.1, 0.15) << row.minification << ":1 " << row.tilt;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Meshes, GlSamplerMeshTest,
                         testing::Values(std::pair{"teapot.obj", AtlasKind::patch},
                                         std::pair{"king.obj", AtlasKind::area},
                                         std::pair{"bust.obj", AtlasKind::patch}));

}  // namespace
}  // namespace burl
