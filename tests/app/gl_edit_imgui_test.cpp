// The user interface's triangles, drawn by our own renderer on OSMesa: colours, blending, clipping
// and textures land on the pixels that ImGui means.
#include "app/gl_edit_imgui.h"

#include <gtest/gtest.h>

#include "app/gl_edit_window.h"
#include "tests/app/gl_fixture.h"

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

    /// What `paint` draws over black.
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
    const GlTexture texture = make_texture(gl);
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

}  // namespace
}  // namespace burl
