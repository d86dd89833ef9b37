// The texture moved on the object by pointer and keys, without a display: what was under the
// pointer must be under it again, elsewhere.
#include "app/editor/panels/move.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/editor/window/fixture.h"

namespace burl {
namespace {

class EditMoveTest : public GlEditProgramTest {
  protected:
    /// With the tool in hand and smooth marble.
    std::unique_ptr<EditorProgram> with_tool(bool gizmo = false) {
        auto editor = start();
        editor->session().set({"texture.input.noise.0.octaves=1", "solid.scale=1.5",
                               "solid.rotate=[20,-30,75]", "solid.translate=[0.3,-0.2,0.25]"});
        play(*editor, R"({"key": "G"}, {"wait": 2}, {"settle": true}, {"wait": 2})");
        if (!gizmo) play(*editor, R"({"click": "move.axes"}, {"wait": 2})");
        return editor;
    }

    static ObjectView view_of(EditorProgram& editor) {
        ObjectView view;
        view.pick = editor.baker().front().pick();
        view.camera = editor.camera();
        const auto surface = editor.baker().front().surface();
        view.sphere = surface->sphere;
        view.solid_from_mesh = view.unit_from_mesh = surface->unit_from_mesh;
        const ItemRect rect = *editor.items().find("object");
        view.low = rect.low;
        view.size = rect.high - rect.low;
        return view;
    }
    /// In whole units, as pointers are.
    static Vec2d middle(EditorProgram& editor) {
        return glm::floor(editor.items().find("object")->middle());
    }

    static std::string event(const Vec2d& at) {
        return R"({"events": [{"move": [)" + std::to_string(at.x) + "," + std::to_string(at.y) +
               "]}]}";
    }
    static std::string button(bool down) {
        return std::string(R"({"events": [{"button": 0, "down": )") + (down ? "true" : "false") +
               "}]}";
    }
    static std::string key(const std::string& name, bool down) {
        return R"({"events": [{"key": ")" + name + R"(", "down": )" + (down ? "true" : "false") +
               "}]}";
    }
    static void press(EditorProgram& editor, const Vec2d& from, const std::string& held) {
        if (!held.empty()) play(editor, key(held, true));
        play(editor, event(from) + "," + button(true));
    }
    static void release(EditorProgram& editor, const std::string& held) {
        play(editor, button(false) + R"(, {"wait": 1})");
        if (!held.empty()) play(editor, key(held, false));
    }
    static void drag(EditorProgram& editor, const Vec2d& from, const Vec2d& to,
                     const std::string& held = "") {
        press(editor, from, held);
        play(editor, event(glm::mix(from, to, 0.4)) + "," + event(to));
        release(editor, held);
    }

    static Vec3d solid_at(EditorProgram& editor, const Vec2d& pointer) {
        const ObjectView view = view_of(editor);
        return view.solid_from_mesh(hit_at(view, pointer).value().mesh_point);
    }
    static Affine3 map_of(EditorProgram& editor) {
        return texture_from_solid(editor.session().recipe());
    }
    /// The colour under the pointer, by bilinear lookup of the finest picture.
    static Vec3d color_at(EditorProgram& editor, const Vec2d& pointer) {
        settled(editor);
        const Image<Rgb8>& texels = editor.baker().front().picture()->texels;
        const Vec2d at =
            hit_at(view_of(editor), pointer).value().uv * double(texels.width()) - Vec2d(0.5);
        Vec3d sum(0.0);
        for (int k = 0; k < 4; ++k) {
            const Vec2d corner = glm::floor(at) + Vec2d(k % 2, k / 2);
            const Vec2d weight = Vec2d(1.0) - glm::abs(at - corner);
            const Rgb8& c = texels(std::size_t(corner.x), std::size_t(corner.y));
            sum += weight.x * weight.y * Vec3d(c.r, c.g, c.b);
        }
        return sum;
    }
};

TEST_F(EditMoveTest, WhatWasTakenIsUnderThePointerAgain) {
    const auto editor = with_tool();
    const Vec2d a = middle(*editor) + Vec2d(-35, 20), b = middle(*editor) + Vec2d(30, -25);
    const Recipe recipe = editor->session().recipe();
    const EditCamera camera = editor->camera();
    const Vec3d taken = map_of(*editor)(solid_at(*editor, a));
    const Vec3d color = color_at(*editor, a), other = color_at(*editor, b);
    drag(*editor, a, a);  // no way: no step
    const Image<Rgb8> before = settled(*editor);
    drag(*editor, a, b);
    EXPECT_LT(glm::distance(map_of(*editor)(solid_at(*editor, b)), taken), 1e-8);
    EXPECT_LT(glm::distance(color_at(*editor, b), color), 4.0);
    EXPECT_GT(glm::distance(other, color), 20.0);
    EXPECT_EQ(editor->camera(), camera);
    EXPECT_EQ(editor->session().recipe().solid.rotate, recipe.solid.rotate);
    EXPECT_GT(different(*editor, before), 3000u);
    play(*editor, R"({"key": "Ctrl+Z"})");
    EXPECT_EQ(editor->session().recipe(), recipe);
    EXPECT_EQ(different(*editor, before), 0u);
}

TEST_F(EditMoveTest, BesideTheObjectItGoesOnUnderThePointer) {
    const auto editor = with_tool();
    const ObjectView view = view_of(*editor);
    const Vec2d a = middle(*editor) + Vec2d(10, 5), b = view.low + Vec2d(25, 40);
    ASSERT_FALSE(hit_at(view, b));
    const Affine3 before = map_of(*editor);
    const Vec3d taken = before(solid_at(*editor, a));
    drag(*editor, a, b);
    const Affine3 after = map_of(*editor);
    const Vec3d solid = glm::inverse(after.linear) * (taken - after.offset);
    const Vec3d scene =
        glm::inverse(view.solid_from_mesh.linear) * (solid - view.solid_from_mesh.offset);
    EXPECT_LT(glm::distance(Vec2d(on_screen(view, scene)), b), 1e-5);
}

TEST_F(EditMoveTest, ShiftTurnsAboutTheMiddle) {
    const auto editor = with_tool();
    const Vec2d a = middle(*editor) + Vec2d(-35, 20), b = middle(*editor) + Vec2d(30, -25);
    const Recipe recipe = editor->session().recipe();
    const Affine3 before = map_of(*editor);
    const Vec3d from = solid_at(*editor, a), to = solid_at(*editor, b);
    drag(*editor, a, b, "Shift");
    const Affine3 after = map_of(*editor);
    EXPECT_LT(glm::distance(after(glm::length(from) * glm::normalize(to)), before(from)), 1e-8);
    EXPECT_LT(glm::distance(after(Vec3d(0.0)), before(Vec3d(0.0))), 1e-8);
    EXPECT_EQ(editor->session().recipe().solid.scale, recipe.solid.scale);
    EXPECT_NE(editor->session().recipe().solid.rotate, recipe.solid.rotate);
    play(*editor, R"({"key": "Ctrl+Z"})");
    EXPECT_EQ(editor->session().recipe(), recipe);
}

TEST_F(EditMoveTest, CtrlSizesByTheDistancesFromTheMiddle) {
    const auto editor = with_tool();
    const Vec2d centre(on_screen(view_of(*editor), middle_of(view_of(*editor))));
    const Vec2d a = middle(*editor) + Vec2d(-40, 20), b = middle(*editor) + Vec2d(60, 50);
    const Recipe recipe = editor->session().recipe();
    const Affine3 before = map_of(*editor);
    drag(*editor, a, b, "Ctrl");
    const double larger = glm::distance(b, centre) / glm::distance(a, centre);
    EXPECT_NEAR(editor->session().recipe().solid.scale, recipe.solid.scale / larger, 1e-5);
    EXPECT_LT(glm::distance(map_of(*editor)(Vec3d(0.0)), before(Vec3d(0.0))), 1e-8);
    EXPECT_EQ(editor->session().recipe().solid.rotate, recipe.solid.rotate);
}

TEST_F(EditMoveTest, EscapeTakesItBackAndTheRestOfTheDragIsNothing) {
    const auto editor = with_tool();
    const Recipe recipe = editor->session().recipe();
    const EditCamera camera = editor->camera();
    const Vec2d a = middle(*editor) + Vec2d(10, 5);
    press(*editor, a, "");
    play(*editor, event(a + Vec2d(30, 0)));
    EXPECT_NE(editor->session().recipe(), recipe);
    play(*editor, R"({"key": "Escape"},)" + event(a + Vec2d(50, 10)));
    release(*editor, "");
    EXPECT_EQ(editor->session().recipe(), recipe);
    EXPECT_EQ(editor->camera(), camera);
    settled(*editor);  // ends: nothing goes on
    play(*editor, R"({"key": "Ctrl+Z"})");
    EXPECT_NE(editor->session().recipe(), recipe);  // the step before: none was added
}

TEST_F(EditMoveTest, OtherDragsTurnTheCamera) {
    const auto editor = with_tool();
    const Recipe recipe = editor->session().recipe();
    EditCamera camera = editor->camera();
    const Vec2d inside = middle(*editor) + Vec2d(10, 5);
    const auto turns = [&](const Vec2d& from, const std::string& held) {
        drag(*editor, from, from + Vec2d(20, 10), held);
        const bool turned = editor->camera() != camera;
        camera = editor->camera();
        return turned;
    };
    EXPECT_TRUE(turns(inside, "Alt"));
    EXPECT_TRUE(turns(view_of(*editor).low + Vec2d(25, 500), ""));
    EXPECT_EQ(editor->session().recipe(), recipe);
    play(*editor, R"({"key": "P"}, {"wait": 2})");  // takes the brush instead
    EXPECT_FALSE(turns(inside, ""));
    EXPECT_EQ(editor->session().recipe().solid, recipe.solid);
    EXPECT_FALSE(editor->session().recipe().paint.empty());
    play(*editor, R"({"key": "G"}, {"key": "G"}, {"wait": 2})");
    EXPECT_TRUE(turns(inside, ""));
}

TEST_F(EditMoveTest, TheGizmosHandlesMoveTurnAndSize) {
    const auto editor = with_tool(true);
    const SolidOptions before = editor->session().recipe().solid;
    play(*editor, R"({"drag": "gizmo.move.y", "by": [25, -12]})");
    const SolidOptions moved = editor->session().recipe().solid;
    EXPECT_GT(std::abs(moved.translate.y - before.translate.y), 0.01);
    EXPECT_NEAR(moved.translate.x, before.translate.x, 1e-8);
    EXPECT_NEAR(moved.translate.z, before.translate.z, 1e-8);
    EXPECT_EQ(moved.rotate, before.rotate);
    play(*editor, R"({"drag": "gizmo.turn.z", "by": [20, 15]})");
    const SolidOptions turned = editor->session().recipe().solid;
    EXPECT_EQ(turned.scale, before.scale);
    EXPECT_GT(std::abs(turned.rotate.z - before.rotate.z), 1.0);
    EXPECT_NEAR(turned.rotate.x, before.rotate.x, 1e-6);  // z comes last: a turn about it is alone
    EXPECT_NEAR(turned.rotate.y, before.rotate.y, 1e-6);
    play(*editor, R"({"drag": "gizmo.size", "by": [50, 0]})");
    EXPECT_NEAR(editor->session().recipe().solid.scale, before.scale / std::sqrt(2.0), 1e-8);
    play(*editor, R"({"key": "Ctrl+Z"}, {"key": "Ctrl+Z"}, {"key": "Ctrl+Z"})");
    EXPECT_EQ(editor->session().recipe().solid, before);
}

TEST_F(EditMoveTest, ArrowKeysStepUnlessAnotherWindowHasThem) {
    const auto editor = with_tool(true);
    const Recipe recipe = editor->session().recipe();
    const auto solid = [&] { return editor->session().recipe().solid; };
    play(*editor, R"({"key": "Right"})");
    const ObjectView view = view_of(*editor);
    EXPECT_EQ(solid(), stepped(view, recipe.solid, SolidDrag::move, {1, 0}));
    EXPECT_NE(solid(), recipe.solid);
    play(*editor, R"({"key": "Ctrl+Z"}, {"key": "Shift+Up"})");
    EXPECT_EQ(solid(), stepped(view, recipe.solid, SolidDrag::turn, {0, 1}));
    play(*editor, R"({"key": "Ctrl+Z"}, {"key": "Ctrl+Left"})");
    EXPECT_EQ(solid(), stepped(view, recipe.solid, SolidDrag::size, {-1, 0}));
    play(*editor, R"({"key": "Ctrl+Z"}, {"click": "tab:Log"}, {"wait": 2}, {"key": "Up"})");
    EXPECT_EQ(solid(), recipe.solid);
    play(*editor, R"({"key": "G"}, {"wait": 2})");
    drag(*editor, middle(*editor), middle(*editor));
    play(*editor, R"({"key": "Right"})");
    EXPECT_EQ(solid(), recipe.solid);
}

TEST_F(EditMoveTest, TheMenuAndTheWindowDoWhatTheKeysDo) {
    const auto editor = start();
    play(*editor, R"({"click": "menu:Edit"}, {"wait": 2}, {"click": "menu:Move the texture"},
        {"wait": 2}, {"drag": "gizmo.move.x", "by": [20, 5]})");
    const Recipe recipe = editor->session().recipe();
    EXPECT_NE(recipe.solid.translate, Vec3d(0.0));
    play(*editor, R"({"click": "move.reset"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe().solid,
              (SolidOptions{recipe.solid.space, recipe.solid.scale}));
    play(*editor, R"({"key": "Ctrl+Z"})");
    EXPECT_EQ(editor->session().recipe(), recipe);
}

}  // namespace
}  // namespace burl
