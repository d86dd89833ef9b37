// The samplers of `burl metrics --levels` against those of OpenGL: the same places and steps from
// pixel to pixel, looked up in the same levels, on meshes with atlases of ours and of the file's.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/gl/device/fixture.h"
#include "tests/app/support/gl_lookups.h"

namespace burl {
namespace {

class GlSamplerTest : public GlTest {
  protected:
    void SetUp() override {
        ask_for_exact_lookups();
        GlTest::SetUp();
    }

    std::vector<Vec3d> drawn(const MipChain<Vec3f>& chain, const std::vector<Lookup>& lookups,
                             int most) const {
        return gl_lookups(context->gl(), chain, lookups, most);
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
    const ViewedMesh viewed = viewed_sample(GetParam().first, GetParam().second, 400);
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
