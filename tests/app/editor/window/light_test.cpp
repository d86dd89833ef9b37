// The editor's view under an environment: materials as `burl render` shows them, live.
#include "app/editor/window/light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "app/editor/window/object.h"
#include "app/gl/draw/lazy_picture.h"
#include "app/image/image_diff.h"
#include "app/image/image_io.h"
#include "app/recipe/edit/images.h"
#include "app/surface/sample_meshes.h"
#include "tests/app/editor/window/fixture.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

/// A material whose pictures are all seen, with this opacity.
Recipe material_of(const std::string& opacity) {
    RecipeImages images;
    return parse_recipe(R"({"atlas": {"size": 256, "tries": 1}, "solid": {"scale": 3},
        "define": {"grain": {"node": "smoothstep", "low": -1, "high": 1, "input":
            {"node": "fbm", "octaves": 2}}},
        "material": {"base_color": {"node": "mix", "a": "#203050", "b": "#f0c0a0",
            "amount": "grain"}, "metallic": "grain", "roughness": {"node": "remap", "input":
            "grain", "out_low": 0.2, "out_high": 0.8}, "emissive": {"node": "scale", "a": "#402000",
            "b": "grain"}, "clearcoat": 0.5, "height": "grain")" +
                            opacity + R"(}, "bump": {"height": 0.02}})",
                        "m.json", {}, images);
}

class GlEditLightTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (!context) return;
        context->make_current();
        light = std::make_shared<const GlLight>(context->gl(),
                                                prefilter(make_environment("studio", 64), 32));
    }

    Image<Rgb8> edited(const Recipe& recipe, Mesh mesh = sample_mesh("sample:icosphere"),
                       bool every_layer = false) {
        EditBaker baker([] {});
        baker.set_mesh(std::move(mesh));
        baker.request(recipe, false);
        baker.wait();
        GlEditObject object(context->gl());
        object.show(baker.front().surface(), baker.front().picture());
        ObjectViewOptions options;
        options.size = {size.width, size.height};
        options.light = light;
        options.supersample = 2;
        options.every_layer = every_layer;
        object.draw(options);
        const auto codes = object.target()->read<std::uint8_t>();
        Image<Rgb8> picture{std::size_t(size.width), std::size_t(size.height)};
        for (std::size_t y = 0; y < picture.height(); ++y)
            for (std::size_t x = 0; x < picture.width(); ++x) {
                const std::uint8_t* code = &codes[4 * (y * picture.width() + x)];
                picture(x, y) = {code[0], code[1], code[2]};
            }
        return picture;
    }

    Image<Rgb8> rendered(const Recipe& recipe, Mesh mesh = sample_mesh("sample:icosphere")) {
        Pipeline pipeline(std::move(mesh));
        pipeline.set_recipe(recipe);
        LazyOptions options;
        options.picture.size = size;
        options.picture.light.light = "studio";
        options.light = light;
        return colors_and_alpha(render_lazily(*context, pipeline, {}, options).picture).first;
    }

    PictureSize size{120, 90};
    std::shared_ptr<const GlLight> light;
};

TEST_F(GlEditLightTest, ShowsMaterialsAsRenderDoes) {
    const Recipe recipe = material_of("");
    EXPECT_GT(diff_images(edited(recipe), rendered(recipe)).psnr_db, 40.0);
}

TEST_F(GlEditLightTest, ShowsWhatIsTransparentOverTheBackground) {
    const Recipe recipe =
        material_of(R"(, "opacity": {"node": "multiply", "a": 0.7, "b": "grain"})");
    EXPECT_GT(diff_images(edited(recipe), rendered(recipe)).psnr_db, 35.0);
}

/// Balls within balls, of which the innermost one's triangles come last: in their order it would be
/// seen over the others.
Mesh nested_balls() {
    const Mesh ball = sample_mesh("sample:icosphere");
    Mesh mesh;
    mesh.positions = ball.positions, mesh.triangles = ball.triangles;
    for (const double size : {0.75, 0.5}) {
        const auto first = std::uint32_t(mesh.positions.size());
        for (const Vec3d& p : ball.positions) mesh.positions.push_back(size * p);
        for (const Triangle& t : ball.triangles)
            mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    add_whole_part(mesh);
    return mesh;
}

TEST_F(GlEditLightTest, ShowsEveryLayerOfWhatBlends) {
    const Recipe recipe = material_of(R"(, "opacity": 0.35)");
    const Image<Rgb8> truth = rendered(recipe, nested_balls());
    const auto psnr = [&](bool every_layer) {
        return diff_images(edited(recipe, nested_balls(), every_layer), truth).psnr_db;
    };
    EXPECT_GT(psnr(true), 45.0);
    EXPECT_LT(psnr(false), 42.0);
}

/// A number of the material that no picture has, and a channel that begins to vary.
TEST(EditBakerMaterial, FollowsTheRecipe) {
    EditBaker baker([] {});
    baker.set_mesh(sample_mesh("sample:cube", {}));
    const auto shown = [&](const std::string& settings) {
        baker.request(load_recipe("marble", {"atlas.size=64", "atlas.tries=1", settings}), false);
        baker.wait();
        return baker.front().picture();
    };
    const auto rough = shown("material.roughness=0.875");
    EXPECT_EQ(rough->material->numbers.roughness, 0.875f);
    EXPECT_TRUE(rough->material->pictures.empty());
    const auto metal = shown(R"(material.metallic={"node": "fbm"})");
    const SceneMaterial& numbers = metal->material->numbers;
    EXPECT_EQ(numbers.metallic, 1.0f);
    ASSERT_GE(numbers.map(MaterialMap::metallic_roughness), 0);
    EXPECT_EQ(metal->material->pictures.size(), 1u);
    EXPECT_NE(metal->surface, rough->surface) << "it has another texture";
    EXPECT_EQ(baker.front().surface()->scene.surfaces[0].material.maps, numbers.maps);
}

using GlEditLightMenu = GlEditProgramTest;

TEST_F(GlEditLightMenu, ChoosesAnEnvironment) {
    auto editor = start();
    const Image<Rgb8> head = settled(*editor);
    const auto choose = [&](const std::string& name) {
        play(*editor, R"({"click": "menu:View"}, {"wait": 2}, {"click": "menu:Light"}, {"wait": 2},
            {"click": "menu:)" +
                          name + R"("}, {"wait": 2})");
        return settled(*editor);
    };
    const Image<Rgb8> neutral = choose("neutral");
    EXPECT_GT(differing(neutral, head), 1000u);
    EXPECT_EQ(differing(choose("headlight"), head), 0u);
    EXPECT_EQ(differing(choose("neutral"), neutral), 0u);
    play(*editor, R"({"key": "L"}, {"wait": 2})");
    EXPECT_GT(differing(settled(*editor), neutral), 1000u);
    play(*editor, R"({"key": "L"}, {"wait": 2})");
    EXPECT_EQ(differing(settled(*editor), neutral), 0u);
}

TEST_F(GlEditLightTest, TheFirstPictureOfAllIsLit) {
    EditorOptions options;
    EXPECT_EQ(options.light, "studio");
    options.mesh = "sample:cube";
    options.settings = {"atlas.size=64", "atlas.tries=1",
                        R"(texture={"node":"constant","value":"#c08040"})"};
    options.gallery = false;
    const auto far = [](const Rgb8& a, const Rgb8& b) {
        return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) > 4;
    };
    const auto colors = [&](const std::string& light) {
        options.light = light;
        EditorProgram editor(create_unseen_window(create_osmesa_context(), {640, 480}), options);
        std::vector<Rgb8> seen;
        for (int after = 0; after < 5; after += editor.settled()) {
            editor.frame({});
            const glm::dvec2 at = editor.items().find("object").value().middle();
            seen.push_back(editor.screenshot()(std::size_t(at.x), std::size_t(at.y)));
        }
        return seen;
    };
    const std::vector<Rgb8> lit = colors("studio");
    const Rgb8 nothing = lit.front(), last = lit.back();
    EXPECT_TRUE(far(nothing, last)) << "the object comes in";
    EXPECT_TRUE(far(colors("headlight").back(), last)) << "another light";
    for (const Rgb8& color : lit) EXPECT_TRUE(!far(color, nothing) || !far(color, last));
}

}  // namespace
}  // namespace burl
