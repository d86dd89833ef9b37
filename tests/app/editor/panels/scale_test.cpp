// The sizes of the user interface: up and down again, and text that grows with them.
#include "app/editor/widgets/widgets.h"

#include <gtest/gtest.h>

#include "tests/app/editor/window/fixture.h"

namespace burl {
namespace {

TEST(InterfaceScale, GoesUpAndDownTheSameSteps) {
    EXPECT_EQ(larger_scale(1.0), 1.25);
    EXPECT_EQ(smaller_scale(1.0), 0.75);
    EXPECT_EQ(larger_scale(1.1), 1.25);
    EXPECT_EQ(smaller_scale(1.1), 1.0);
    for (double scale = 0.5; scale < 4.0; scale = larger_scale(scale)) {
        EXPECT_GT(larger_scale(scale), scale);
        EXPECT_EQ(smaller_scale(larger_scale(scale)), scale);
    }
    EXPECT_EQ(larger_scale(4.0), 4.0);
    EXPECT_EQ(smaller_scale(0.5), 0.5);
}

TEST_F(GlEditProgramTest, KeysMakeTextLargerAndSmaller) {
    const auto editor = start();
    const auto height = [&] {
        play(*editor, R"({"wait": 3})");
        const ItemRect menu = editor->items().find("menu:File").value();
        return menu.high.y - menu.low.y;
    };
    const double normal = height();
    play(*editor, R"({"key": "Ctrl+Plus"}, {"key": "Ctrl+Plus"})");
    EXPECT_NEAR(height() / normal, 1.5, 0.1);
    play(*editor, R"({"key": "Ctrl+Minus"})");
    EXPECT_NEAR(height() / normal, 1.25, 0.1);
    play(*editor, R"({"key": "Ctrl+0"})");
    EXPECT_EQ(height(), normal);
}

}  // namespace
}  // namespace burl
