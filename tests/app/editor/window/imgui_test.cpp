// The user interface's triangles, drawn by our own renderer on OSMesa: colours, blending, clipping
// and textures land on the pixels that ImGui means.
#include "app/editor/window/imgui.h"

#include <gtest/gtest.h>

#include <random>

#include "app/editor/widgets/theme.h"
#include "app/editor/window/window.h"
#include "app/gl/device/target.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

class GlImGuiTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (!context) return;
        window = create_unseen_window(std::move(context), {64, 48});
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().DisplaySize = {64, 48};
        ImGui::GetIO().DeltaTime = 0.1f;
    }
    void TearDown() override {
        if (window) ImGui::DestroyContext();
    }

    /// The picture that `paint` draws over black.
    template <class Paint>
    Image<Rgb8> drawn(const Paint& paint) {
        const GladGLContext& gl = window->context().gl();
        const GlImGui renderer(gl);
        ImGui::NewFrame();
        paint(*ImGui::GetBackgroundDrawList());
        ImGui::Render();
        window->bind_screen();
        gl.ClearColor(0, 0, 0, 1);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        renderer.draw(*ImGui::GetDrawData());
        window->bind_screen();
        return read_screen(*window, gl);
    }

    /// After an update the screen shows the picture that drawing all of it gives.
    void expect_update_draws(GlImGui& renderer, const GlImGui::OpaqueImage& image,
                             unsigned frame) const {
        const GladGLContext& gl = window->context().gl();
        window->bind_screen();
        renderer.update(*ImGui::GetDrawData(), Vec3f(0.0f), image);
        const Image<Rgb8> updated = read_screen(*window, gl);
        const GlTarget target(gl, {64, 48}, {GL_RGBA8});
        target.clear(0, Vec4f(0, 0, 0, 1));
        renderer.draw(*ImGui::GetDrawData());
        EXPECT_EQ(differing(updated, read_screen(*window, gl)), 0u) << frame;
    }

    std::unique_ptr<GlWindow> window;
};

TEST_F(GlImGuiTest, FillsJustTheRectangle) {
    const Image<Rgb8> picture = drawn([](ImDrawList& list) {
        list.AddRectFilled({8, 4}, {24, 20}, IM_COL32(200, 100, 50, 255));
    });
    for (std::size_t y = 0; y < 48; ++y)
        for (std::size_t x = 0; x < 64; ++x) {
            const bool inside = x >= 8 && x < 24 && y >= 4 && y < 20;
            ASSERT_EQ(picture(x, y), inside ? (Rgb8{200, 100, 50}) : (Rgb8{0, 0, 0}))
                << x << ' ' << y;
        }
}

TEST_F(GlImGuiTest, BlendsAndClips) {
    const Image<Rgb8> picture = drawn([](ImDrawList& list) {
        list.AddRectFilled({0, 0}, {64, 48}, IM_COL32(100, 100, 100, 255));
        list.PushClipRect({10, 10}, {20, 20});
        list.AddRectFilled({0, 0}, {64, 48}, IM_COL32(200, 0, 100, 51));  // a fifth
        list.PopClipRect();
    });
    EXPECT_EQ(picture(5, 5), (Rgb8{100, 100, 100}));
    EXPECT_EQ(picture(20, 15), (Rgb8{100, 100, 100}));
    EXPECT_NEAR(picture(15, 15).r, 120, 1);
    EXPECT_NEAR(picture(15, 15).g, 80, 1);
    EXPECT_NEAR(picture(15, 15).b, 100, 1);
}

TEST_F(GlImGuiTest, ShowsTexturesUpright) {
    const GladGLContext& gl = window->context().gl();
    const GlTexture texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.get());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const std::uint8_t texels[16] = {255, 0, 0,   255, 0,   255, 0,   255,
                                     0,   0, 255, 255, 255, 255, 255, 255};
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    const Image<Rgb8> picture = drawn([&](ImDrawList& list) {
        list.AddImage(imgui_texture(texture), {0, 0}, {64, 48});
    });
    EXPECT_EQ(picture(10, 10), (Rgb8{255, 0, 0}));  // row 0 of the texture on top
    EXPECT_EQ(picture(50, 10), (Rgb8{0, 255, 0}));
    EXPECT_EQ(picture(10, 40), (Rgb8{0, 0, 255}));
    EXPECT_EQ(picture(50, 40), (Rgb8{255, 255, 255}));
}

TEST_F(GlImGuiTest, WritesText) {
    const Image<Rgb8> picture = drawn([](ImDrawList& list) {
        list.AddText({4, 4}, IM_COL32(255, 255, 255, 255), "Burl");
    });
    std::size_t lit = 0;
    for (const Rgb8& pixel : picture.pixels()) lit += pixel.r > 128;
    EXPECT_GT(lit, 30u);
    EXPECT_LT(lit, 300u);
}

/// A frame of five rectangles that random numbers move about, and some text.
void paint_random(ImDrawList& list, std::mt19937& random) {
    for (int i = 0; i < 5; ++i) {
        const auto x = float(random() % 60U), y = float(random() % 40U);
        list.AddRectFilled({x, y}, {x + 9.5f, y + 7.25f}, IM_COL32(40 * i, 255 - 40 * i, 90, 128));
    }
    list.AddText({float(random() % 30U), 20.0f}, IM_COL32_WHITE, random() % 2U == 0 ? "a" : "bcd");
}

/// Rectangles a little wider than two pixels, whose corners' radius is what lies beyond them: ImGui
/// alone ends the program there.
TEST_F(GlImGuiTest, CornersOfAnyRadiusAreDrawn) {
    const Image<Rgb8> image = drawn([](ImDrawList& list) {
        allow_tiny_corners();
        for (float more : {0.0f, 2e-7f, 5e-7f, 1e-6f, 1e-4f, 0.5f})
            list.AddRectFilled({0, 10}, {2.0f + more, 40}, IM_COL32(255, 0, 0, 255), 5.0f);
    });
    EXPECT_EQ(image(0, 25), (Rgb8{255, 0, 0}));
    EXPECT_EQ(image(5, 25), (Rgb8{0, 0, 0}));
}

TEST_F(GlImGuiTest, WhatChangedIsWhatWouldBeDrawn) {
    const GladGLContext& gl = window->context().gl();
    GlImGui renderer(gl);
    for (unsigned frame = 0; frame < 40; ++frame) {
        ImGui::NewFrame();
        std::mt19937 fixed(frame / 8), moving(frame);
        for (int i = 0; i < 3; ++i)
            ImGui::GetBackgroundDrawList()->AddRectFilled({2, 2}, {50, 40}, IM_COL32(60, 0, 0, 99));
        paint_random(*ImGui::GetBackgroundDrawList(), fixed);
        if (frame % 3 == 0) paint_random(*ImGui::GetForegroundDrawList(), moving);
        ImGui::Render();
        expect_update_draws(renderer, {}, frame);
    }
}

/// An image is copied where nothing below it shows, and whatever lies over it is drawn again.
TEST_F(GlImGuiTest, AnImageThatHidesAllBelowItIsWhatWouldBeDrawn) {
    const GladGLContext& gl = window->context().gl();
    GlImGui renderer(gl);
    const GlTarget image(gl, {32, 24}, {GL_RGBA8});
    for (unsigned frame = 0; frame < 40; ++frame) {
        std::mt19937 random(frame), fixed(frame / 8);
        const bool still = frame % 5 == 4;
        std::vector<std::uint8_t> texels(std::size_t{32} * 24 * 4, 255);
        for (std::size_t i = 0; i < texels.size(); ++i)
            if (i % 4 != 3) texels[i] = std::uint8_t(random());
        gl.BindTexture(GL_TEXTURE_2D, image.texture().get());
        if (!still)
            gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 32, 24, GL_RGBA, GL_UNSIGNED_BYTE,
                             texels.data());
        ImGui::NewFrame();
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        paint_random(list, fixed);
        const ImVec2 low = frame < 30 ? ImVec2(9, 7) : ImVec2(9.5f, 7);  // not on pixels
        list.AddImage(imgui_texture(image.texture()), low, {low.x + 32, low.y + 24}, {0, 0}, {1, 1},
                      frame < 20 ? IM_COL32_WHITE : IM_COL32(255, 255, 255, 128));
        if (frame % 2 == 0) paint_random(*ImGui::GetForegroundDrawList(), random);
        ImGui::Render();
        expect_update_draws(renderer, {&image, still}, frame);
    }
}

TEST_F(GlImGuiTest, ChangesAreWhereSomethingDiffers) {
    GlTexture texture(window->context().gl());
    const GlImGui renderer(window->context().gl());  // makes the fonts
    ScreenChanges changes;
    const auto changed = [&](float x, bool still) {
        ImGui::NewFrame();
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        list.AddRectFilled({0, 0}, {64, 48}, IM_COL32(9, 9, 9, 255));
        list.AddImage(imgui_texture(texture), {40, 10}, {60, 20});
        list.AddRectFilled({x, 30}, {x + 4, 34}, IM_COL32_WHITE);
        ImGui::Render();
        return changes.update(*ImGui::GetDrawData(),
                              [&](ImTextureID t) { return still || t != imgui_texture(texture); });
    };
    const auto contains = [](const ScreenRect& r, float x, float y) {
        return r.low.x <= x && x < r.high.x && r.low.y <= y && y < r.high.y;
    };
    const std::vector<ScreenRect> first = changed(5, true);
    ASSERT_EQ(first.size(), 1u);
    EXPECT_TRUE(contains(first[0], 0, 0) && contains(first[0], 63, 47));
    changed(5, true);  // Dear ImGui needs a frame to know its screen
    EXPECT_TRUE(changed(5, true).empty());
    const std::vector<ScreenRect> moved = changed(8, true);
    ASSERT_EQ(moved.size(), 1u);
    EXPECT_TRUE(contains(moved[0], 5, 30) && contains(moved[0], 11.5f, 33.5f));
    EXPECT_FALSE(contains(moved[0], 20, 30) || contains(moved[0], 5, 20));
    const std::vector<ScreenRect> redrawn = changed(8, false);
    ASSERT_EQ(redrawn.size(), 1u);
    EXPECT_TRUE(contains(redrawn[0], 40, 10) && contains(redrawn[0], 59.5f, 19.5f));
    EXPECT_FALSE(contains(redrawn[0], 8, 30));
}

}  // namespace
}  // namespace burl
