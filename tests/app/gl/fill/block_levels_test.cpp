// Levels drawn against the host's, bit for bit; those have tests of their own.
#include "app/gl/fill/block_levels.h"
#include "app/recipe/edit/recipe_json.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/bench/meshes.h"
#include "app/gl/fill/synthesizer.h"
#include "app/pipeline/pipeline.h"
#include "atlas/base/json.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

/// 0 to 1; with `outliers` some far outside.
Image<RgbF> noise(std::uint32_t size, bool outliers) {
    std::mt19937 random(7);
    const auto any = [&] {
        const float value = float(random() >> 8) * 0x1p-24f;
        return outliers && random() % 64 == 0 ? 1e6f * (value - 0.5f) : value;
    };
    Image<RgbF> image(size, size);
    for (std::uint32_t y = 0; y < size; ++y)
        for (RgbF& p : image.row(y)) p = {any(), any(), any()};
    return image;
}

MeshAtlas atlas_of(AtlasKind kind, std::uint32_t size) {
    const Mesh mesh = torus(120);
    return build_atlas(mesh, build_connectivity(mesh), {.kind = kind, .size = size});
}

class GlBlockLevelsTest : public GlTest {
  protected:
    void expect_host_levels(AtlasKind kind, std::uint32_t size, std::uint32_t levels, int tile) {
        const MeshAtlas atlas = atlas_of(kind, size);
        ASSERT_EQ(atlas.patches() != nullptr, kind == AtlasKind::patch);
        const Image<RgbF> texture = noise(size, true);
        const auto host = block_levels(atlas, texture, levels);
        ASSERT_FALSE(host.empty());
        EXPECT_TRUE(GlBlockLevels(*context, atlas)(texture, levels, tile) == host)
            << to_string(kind) << " " << size << " by " << tile;
    }
};

TEST_F(GlBlockLevelsTest, AreTheHostsWithGutters) {
    if (!has_float64(context->gl())) GTEST_SKIP() << "this OpenGL has no float64";
    expect_host_levels(AtlasKind::patch, 256, 99, largest_tile);
}

TEST_F(GlBlockLevelsTest, AreTheHostsOfOddSides) {
    if (!has_float64(context->gl())) GTEST_SKIP() << "this OpenGL has no float64";
    expect_host_levels(AtlasKind::patch, 203, 99, largest_tile);
    expect_host_levels(AtlasKind::area, 99, 2, largest_tile);
}

TEST_F(GlBlockLevelsTest, TilesDoNotShow) {
    if (!has_float64(context->gl())) GTEST_SKIP() << "this OpenGL has no float64";
    expect_host_levels(AtlasKind::patch, 256, 99, 128);  // four tiles down to 2 x 2
}

TEST_F(GlBlockLevelsTest, TilesOfUnequalSidesDoNotShow) {
    if (!has_float64(context->gl())) GTEST_SKIP() << "this OpenGL has no float64";
    expect_host_levels(AtlasKind::patch, 200, 99, 64);  // three halvings, tiles of 64 and 8
}

TEST_F(GlBlockLevelsTest, LevelsMayEndBeforeTilesDo) {
    if (!has_float64(context->gl())) GTEST_SKIP() << "this OpenGL has no float64";
    expect_host_levels(AtlasKind::quad, 256, 2, 128);
}

TEST_F(GlBlockLevelsTest, Float32IsWithinAMillionth) {
    const MeshAtlas atlas = atlas_of(AtlasKind::patch, 203);
    const Image<RgbF> texture = noise(203, false);
    const auto host = block_levels(atlas, texture, 99);
    const auto drawn = GlBlockLevels(*context, atlas, true)(texture, 99);
    ASSERT_EQ(drawn.size(), host.size());
    double largest = 0.0;
    for (std::size_t l = 0; l < host.size(); ++l)
        for (std::size_t i = 0; i < host[l].pixels().size(); ++i) {
            const RgbF a = drawn[l].pixels()[i], b = host[l].pixels()[i];
            for (const float d : {a.r - b.r, a.g - b.g, a.b - b.b})
                largest = std::max(largest, std::abs(double(d)));
        }
    EXPECT_LT(largest, 1e-6);
    EXPECT_GT(largest, 0.0);  // or it was not float32 at all
}

TEST_F(GlBlockLevelsTest, GuttersAreLeftOut) {
    // Gutters white, surface black: where the host shows no white above the last pure level, the
    // drawn levels must not, and plain means would.
    const MeshAtlas atlas = atlas_of(AtlasKind::patch, 256);
    const Image<float> inner = inner_texels(*atlas.patches());
    Image<RgbF> texture(256, 256);
    for (std::uint32_t y = 0; y < 256; ++y)
        for (std::uint32_t x = 0; x < 256; ++x)
            if (inner(x, y) == 0.0f) texture(x, y) = {1.0f, 1.0f, 1.0f};
    const auto levels = GlBlockLevels(*context, atlas)(texture, 8);
    ASSERT_EQ(levels.size(), 8u);
    EXPECT_EQ(levels[7](0, 0), RgbF{});
    float whitest = 0.0f;
    for (const RgbF& p : levels[0].pixels()) whitest = std::max(whitest, p.r);
    EXPECT_EQ(whitest, 1.0f);
}

TEST_F(GlBlockLevelsTest, BakesDrawThem) {
    if (!has_float64(context->gl())) GTEST_SKIP() << "this OpenGL has no float64";
    Pipeline pipeline(torus(120));
    const std::shared_ptr<TextureSynthesizer> gl = make_gl_synthesizer(std::move(context));
    pipeline.set_synthesizer(gl);
    for (const int size : {128, 64}) {  // another atlas the second time
        const int before = gl->report()["passes"];
        pipeline.set_recipe(load_recipe("marble", {fmt::format("atlas.size={}", size)}));
        const Image<RgbF> texture = noise(std::uint32_t(size), false);
        EXPECT_TRUE(pipeline.levels(texture, 4) == block_levels(pipeline.mesh_atlas(), texture, 4));
        EXPECT_EQ(gl->report()["passes"], before + 4);
    }
}

}  // namespace
}  // namespace burl
