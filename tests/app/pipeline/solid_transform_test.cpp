// A turned and moved solid, against meshes whose points were turned and moved by GLM before.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

#include "app/gl/fill/synthesizer.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/lattice_check.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

const std::vector<std::string> askew{"solid.scale=1.5", "solid.rotate=[20,-130,75]",
                                     "solid.translate=[0.3,-7,2.25]"};

/// The transform of `askew`, worked out by hand.
Vec3d by_hand(const Vec3d& point) {
    const auto turn = [](double degrees, const Vec3d& axis) {
        return glm::rotate(Mat4d(1.0), glm::radians(degrees), axis);
    };
    const Mat4d rotation = turn(75, {0, 0, 1}) * turn(-130, {0, 1, 0}) * turn(20, {1, 0, 0});
    return 1.5 * Vec3d(rotation * Vec4d(point, 1.0)) + Vec3d(0.3, -7, 2.25);
}

TEST(SolidTransform, TurnsScalesThenMoves) {
    const Affine3 map = texture_from_solid(load_recipe("marble", askew));
    for (const Vec3d& p : {Vec3d(0.0), Vec3d(1, 2, 3), Vec3d(-0.4, 0.1, 0.7)})
        EXPECT_LT(glm::distance(map(p), by_hand(p)), 1e-14);
    const Affine3 quarter =
        texture_from_solid(load_recipe("marble", {"solid.scale=1", "solid.rotate=[0,90,0]"}));
    EXPECT_LT(glm::distance(quarter({0, 0, 1}), Vec3d(1, 0, 0)), 1e-15);
}

TEST(SolidTransform, WithoutItNothingChanges) {
    const Affine3 map = texture_from_solid(load_recipe("marble", {"solid.scale=3"}));
    EXPECT_EQ(map, (Affine3{3.0 * Mat3d(1.0), Vec3d(0.0)}));
}

TEST(SolidTransform, IsKeptInJson) {
    const Recipe recipe = load_recipe("marble", askew);
    EXPECT_EQ(recipe.solid.rotate, Vec3d(20, -130, 75));
    EXPECT_EQ(recipe.solid.translate, Vec3d(0.3, -7, 2.25));
    EXPECT_EQ(parse_recipe(to_json(recipe), "again"), recipe);
    EXPECT_EQ(load_recipe("marble", {"solid.rotate.1=90"}).solid.rotate, Vec3d(0, 90, 0));
    EXPECT_THROW(load_recipe("marble", {"solid.rotate.1=361"}), Error);
}

struct Ways {
    const char* recipe;
    std::vector<std::string> settings;
    HostWay way;
};

TEST(SolidTransform, EveryWayOfTheHostFollows) {
    HostWay forward, direct;
    forward.forward = true;
    direct.kernel = Kernel::direct;
    const std::vector<Ways> all{
        {"marble", {}, {}},
        {"marble", {}, direct},
        {"marble", {}, forward},
        {"marble", {"precision.kind=float64"}, {}},
        {"wood", {"filter.kind=trapezoid", "filter.octaves=fade"}, {}},
        {"wood", {"filter.kind=supersample"}, {}},
        {"checks", {}, {}},
        {"checks", {"filter.kind=trapezoid"}, {}},
    };
    const Mesh mesh = sphere_mesh(8, 12);
    for (const Ways& one : all) {
        std::vector<std::string> settings = one.settings;
        settings.insert(settings.end(), {"atlas.kind=area", "atlas.size=64"});
        const Recipe plain = load_recipe(one.recipe, settings);
        settings.insert(settings.end(), askew.begin(), askew.end());
        const Recipe turned = load_recipe(one.recipe, settings);
        Pipeline pipeline(mesh);
        pipeline.set_recipe(turned);
        std::vector<Vec3d> points = map_positions(mesh, solid_from_mesh(mesh, SolidSpace::unit));
        for (Vec3d& point : points) point = by_hand(point);
        Recipe moved = plain;
        moved.solid.scale = 1.0;
        const SolidAtlas solid = rasterize(mesh, pipeline.mesh_atlas(), points);
        const Image<RgbF> expected = fill_texture<RgbF>(solid, moved, one.way);
        const Image<RgbF> made = fill_texture<RgbF>(pipeline.solid(), turned, one.way);
        // Points differ by roundings, which only jumps of a colour map can show.
        std::size_t away = 0;
        for (std::size_t i = 0; i < made.pixels().size(); ++i) {
            const RgbF &a = made.pixels()[i], &b = expected.pixels()[i];
            away += std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) > 1e-4f;
        }
        EXPECT_LE(away, 4u) << one.recipe << " " << settings.front();
        EXPECT_GT(differing(made, fill_texture<RgbF>(pipeline.solid(), plain, one.way)), 1000u);
    }
}

TEST(SolidTransform, OnlyTheTextureIsMadeAgain) {
    Pipeline pipeline(cube_mesh());
    pipeline.set_recipe(load_recipe("marble", {"atlas.size=64"}));
    const Image<Rgb8> before = pipeline.synthesize<Rgb8>();
    std::vector<std::string> settings = askew;
    settings.push_back("atlas.size=64");
    pipeline.set_recipe(load_recipe("marble", settings));
    const Image<Rgb8> after = pipeline.synthesize<Rgb8>();
    EXPECT_GT(differing(before, after), 1000u);
    EXPECT_EQ(pipeline.records()[Stage::layout].runs, 1u);
    EXPECT_EQ(pipeline.records()[Stage::synthesis].runs, 2u);
    Pipeline fresh(cube_mesh());
    fresh.set_recipe(pipeline.recipe());
    EXPECT_EQ(differing(after, fresh.synthesize<Rgb8>()), 0u);
}

TEST(SolidTransform, LatticesAreCheckedWhereCornersLie) {
    // Far along x only: too far for the lattice once x is turned to the axis of high frequency.
    Mesh mesh = cube_mesh({1e6, 0.0, 0.0});
    Recipe recipe = load_recipe("marble", {"solid.space=object"});
    NoiseTerm& term = plain_texture(recipe.texture)->noise.front();
    term.octaves = 1;
    term.frequency = {1.0, 1e6, 1e6};
    term.phase = Vec3d(0.0);
    recipe.solid.scale = 1e3;
    EXPECT_NO_THROW(check_lattice(recipe, mesh));
    recipe.solid.rotate = {0.0, 0.0, 90.0};
    EXPECT_THROW(check_lattice(recipe, mesh), Error);
}

using GlSolidTransformTest = GlTest;

TEST_F(GlSolidTransformTest, OpenGlFollows) {
    const std::unique_ptr<TextureSynthesizer> gl = make_gl_synthesizer(std::move(context));
    for (const char* name : {"marble", "checks"}) {
        std::vector<std::string> settings = askew;
        settings.insert(settings.end(), {"atlas.size=64", "atlas.tries=1"});
        Pipeline pipeline(sphere_mesh(8, 12));
        pipeline.set_recipe(load_recipe(name, settings));
        ASSERT_EQ(gl->problem(pipeline.recipe()), "");
        Image<Rgb8> drawn;
        gl->synthesize(pipeline.solid(), pipeline.recipe(), 1, &drawn);
        EXPECT_EQ(differing(drawn, pipeline.synthesize<Rgb8>()), 0u) << name;
        gl->forget_atlas();
    }
}

}  // namespace
}  // namespace burl
