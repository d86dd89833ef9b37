// Textures that are drawn to and read back, tiles of them, timers, and what does not fit.
#include "app/gl/device/target.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <numeric>

#include "app/gl/device/objects.h"
#include "app/gl/device/timer.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

using testing::Each;

class GlTargetTest : public GlTest {
  protected:
    const GladGLContext& gl() const { return context->gl(); }
    /// A full-screen pass of this text.
    GlProgram pass(const char* text) const {
        return make_full_screen_program(gl(), "test", ShaderSource().add("test.frag", text));
    }
    static ExitCode code_of(const std::function<void()>& run) {
        try {
            run();
        } catch (const Error& error) {
            return error.code();
        }
        return ExitCode::ok;
    }
};

TEST_F(GlTargetTest, PassesDrawEveryTexelOnce) {
    // Every draw adds one, so a texel on a seam between two triangles would show two.
    const GlProgram program = pass("out vec4 color; void main() { color = vec4(1.0); }");
    const GlTarget target(gl(), {37, 23}, {GL_RGBA32F});
    target.clear(0, Vec4f(0.0f));
    gl().Enable(GL_BLEND);
    gl().BlendFunc(GL_ONE, GL_ONE);
    program.use();
    GlFullScreen(gl()).draw();
    gl().Disable(GL_BLEND);
    EXPECT_THAT(target.read<float>(), Each(1.0f));
}

TEST_F(GlTargetTest, SeveralTexturesAreDrawnTogetherAndReadBackExactly) {
    const GlProgram program = pass(
        "layout(location = 0) out vec4 a; layout(location = 1) out uvec2 b;\n"
        "void main() {\n"
        "    uvec2 p = uvec2(gl_FragCoord.xy);\n"
        "    a = vec4(gl_FragCoord.xy, -1.5, 1.0 / 3.0);\n"
        "    b = uvec2(0xfffffff0u + p.x, 65536u * p.y);\n"
        "}");
    const GlTarget target(gl(), {5, 3}, {GL_RGBA32F, GL_RG32UI});
    target.bind();
    program.use();
    GlFullScreen(gl()).draw();
    const std::vector<float> a = target.read<float>();
    const auto b = target.read<std::uint32_t>(1);
    for (std::size_t y = 0; y < 3; ++y)
        for (std::size_t x = 0; x < 5; ++x) {
            const std::size_t i = 5 * y + x;
            EXPECT_EQ(a[4 * i], float(x) + 0.5f);
            EXPECT_EQ(a[4 * i + 1], float(y) + 0.5f);
            EXPECT_EQ(a[4 * i + 3], 1.0f / 3.0f);
            EXPECT_EQ(b[2 * i], 0xfffffff0u + x);
            EXPECT_EQ(b[2 * i + 1], 65536u * y);
        }
}

TEST_F(GlTargetTest, RowsOfOddLengthsHaveNoGaps) {
    const GlProgram program = pass(
        "out vec4 color; void main() { color = vec4(gl_FragCoord.xy - 0.5, 7.0, 0.0) / 255.0; }");
    const GlTarget target(gl(), {5, 4}, {GL_RGBA8});
    target.bind();
    program.use();
    GlFullScreen(gl()).draw();
    std::vector<std::uint8_t> texels(3 * 3 * 2);
    target.read(std::span(texels), {{1, 2}, {3, 2}}, 0, 3);
    EXPECT_THAT(texels, testing::ElementsAre(1, 2, 7, 2, 2, 7, 3, 2, 7, 1, 3, 7, 2, 3, 7, 3, 3, 7));
}

TEST_F(GlTargetTest, OnePassReadsWhatAnotherDrewAndAnArray) {
    const GlTarget first(gl(), {8, 8}, {GL_R32F});
    first.clear(0, Vec4f(0.25f));
    const std::array<float, 3> values{1.0f, 2.0f, 4.0f};
    const GlBufferTexture array(gl(), GL_R32F, std::span<const float>(values));
    const GlProgram program = pass(
        "uniform sampler2D before; uniform samplerBuffer values; uniform ivec2 origin; out vec4 "
        "c;\n"
        "void main() {\n"
        "    ivec2 p = ivec2(gl_FragCoord.xy) - origin;\n"
        "    c = texelFetch(before, p, 0) + texelFetch(values, p.x % 3);\n"
        "}");
    const GlTarget second(gl(), {16, 8}, {GL_R32F});
    second.clear(0, Vec4f(9.0f));
    second.bind({{8, 0}, {8, 8}});  // only its right half
    program.use();
    program.set("origin", glm::ivec2(8, 0));
    bind_texture(gl(), program, "before", 0, first.texture());
    array.bind(program, "values", 1);
    GlFullScreen(gl()).draw();
    check_gl(gl(), "testing");
    const std::vector<float> texels = second.read<float>();
    for (std::size_t y = 0; y < 8; ++y)
        for (std::size_t x = 0; x < 16; ++x)
            EXPECT_EQ(texels[16 * y + x], x < 8 ? 9.0f : 0.25f + values[(x - 8) % 3]);
}

TEST_F(GlTargetTest, TexturesKeepTheirTexels) {
    std::vector<std::uint32_t> texels(4 * 6 * 2);
    std::iota(texels.begin(), texels.end(), 0xfffffff0u);
    const GlTexture source =
        make_texture(gl(), GL_RGBA32UI, {6, 2}, std::span<const std::uint32_t>(texels));
    const GlProgram program = pass(
        "uniform usampler2D source; out uvec4 c;\n"
        "void main() { c = texelFetch(source, ivec2(gl_FragCoord.xy), 0); }");
    const GlTarget target(gl(), {6, 2}, {GL_RGBA32UI});
    target.bind();
    program.use();
    program.set("source", 0);
    bind_texture(gl(), 0, source);
    GlFullScreen(gl()).draw();
    EXPECT_EQ(target.read<std::uint32_t>(), texels);
}

TEST_F(GlTargetTest, WhatDoesNotFitIsAnError) {
    EXPECT_EQ(code_of([&] { GlTarget(gl(), {1 << 20, 4}, {GL_RGBA32F}); }), ExitCode::unsupported);
    EXPECT_EQ(code_of([&] {
                  GlTarget(gl(), {4, 4}, std::vector<GLenum>(64, GL_R8));
              }),
              ExitCode::unsupported);
    const std::array<float, 7> few{};
    EXPECT_EQ(code_of([&] {
                  make_texture(gl(), GL_R32F, {4, 2}, std::span<const float>(few));
              }),
              ExitCode::runtime);
    const GlTarget target(gl(), {4, 4}, {GL_RGBA8});
    EXPECT_EQ(code_of([&] { target.read<float>(); }), ExitCode::runtime);
    EXPECT_EQ(code_of([&] { format_of(GL_DEPTH_COMPONENT24); }), ExitCode::runtime);
    EXPECT_NO_THROW(check_gl(gl(), "testing"));
}

TEST_F(GlTargetTest, TimersMeasureWhatIsBetween) {
    // Long beside the clocks' steps, in 16 of llvmpipe's bins: all must count, not the last alone.
    const GlProgram program = pass(
        "out vec4 c; void main() {\n"
        "    float f = gl_FragCoord.x;\n"
        "    for (int i = 0; i < 500; ++i) f = sqrt(f + float(i));\n"
        "    c = vec4(f);\n"
        "}");
    const GlTarget target(gl(), {256, 256}, {GL_R32F});
    target.bind();
    program.use();
    GlFullScreen(gl()).draw();  // compiles
    GlTimer timer(gl());
    timer.start();
    GlFullScreen(gl()).draw();
    const GlSeconds long_pass = timer.stop();
    timer.start();
    const GlSeconds nothing = timer.stop();
    EXPECT_GT(long_pass.gpu, long_pass.wall / 4);
    EXPECT_LT(long_pass.gpu, long_pass.wall * 1.01);
    EXPECT_LT(nothing.wall, long_pass.wall);
}

TEST(GlTiles, CoverEveryTexelOnce) {
    std::vector<int> drawn(10 * 7, 0);
    int tiles = 0;
    for_tiles({10, 7}, 4, [&](const GlTile& tile) {
        ++tiles;
        EXPECT_LE(std::max(tile.size.x, tile.size.y), 4);
        for (int y = 0; y < tile.size.y; ++y)
            for (int x = 0; x < tile.size.x; ++x)
                ++drawn.at(std::size_t(10 * (tile.origin.y + y) + tile.origin.x + x));
    });
    EXPECT_EQ(tiles, 6);
    EXPECT_THAT(drawn, Each(1));
}

}  // namespace
}  // namespace burl
