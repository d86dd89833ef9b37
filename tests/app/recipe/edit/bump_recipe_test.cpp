// The recipe's bumps: reading, writing, --set, what is refused, and the pictures they make.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/recipe.h"
#include "app/surface/normals.h"
#include "atlas/base/error.h"
#include "procedural/color/srgb.h"
#include "tests/app/support/direct_picture.h"
#include "tests/app/support/sample_scene.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

using testing::HasSubstr;

Recipe with_bump(const std::string& bump, const std::vector<std::string>& settings = {}) {
    return parse_recipe("{\"bump\": " + bump + "}", "r", settings);
}

std::string wrong_bump(const std::string& bump, const std::vector<std::string>& settings = {}) {
    try {
        with_bump(bump, settings);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), settings.empty() ? ExitCode::invalid_file : ExitCode::usage);
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << bump;
    return {};
}

TEST(BumpRecipe, IsReadComparedAndWrittenBack) {
    const Recipe recipe = with_bump(R"({"height": 0.25, "input": {"node": "fbm", "octaves": 3}})");
    EXPECT_EQ(recipe.bump.height, 0.25);
    EXPECT_EQ(recipe.bump.input, graph_of(R"({"node": "fbm", "octaves": 3})"));
    EXPECT_EQ(parse_recipe(to_json(recipe), "r"), recipe);
    EXPECT_NE(recipe, parse_recipe("{}", "r"));
    EXPECT_NE(recipe, with_bump(R"({"height": 0.2, "input": {"node": "fbm", "octaves": 3}})"));
    EXPECT_TRUE(parse_recipe("{}", "r").bump.empty());
    EXPECT_THAT(to_json(parse_recipe("{}", "r")), Not(HasSubstr("bump")));
}

TEST(BumpRecipe, TakesAnyNodeThatGivesANumber) {
    EXPECT_FALSE(with_bump(R"({"input": 0.5})").bump.empty());
    EXPECT_FALSE(with_bump(R"({"input": {"node": "field", "noise": [{}]}})").bump.empty());
    EXPECT_EQ(with_bump(R"({"input": 0.5})").bump.height, 0.01);
    const Recipe constant = with_bump(R"({"input": 0.5})");
    EXPECT_EQ(parse_recipe(to_json(constant), "r"), constant);
}

TEST(BumpRecipe, IsSetFromTheCommandLine) {
    const Recipe recipe =
        with_bump(R"({"input": {"node": "fbm"}})", {"bump.height=0.5", "bump.input.octaves=2"});
    EXPECT_EQ(recipe.bump.height, 0.5);
    EXPECT_EQ(recipe.bump.input, graph_of(R"({"node": "fbm", "octaves": 2})"));
    const Recipe made = parse_recipe("{}", "r", {R"(bump.input={"node": "wrinkled"})"});
    EXPECT_EQ(made.bump.input, graph_of(R"({"node": "wrinkled"})"));
}

TEST(BumpRecipe, WrongOnesAreRefusedWithTheirPath) {
    EXPECT_THAT(wrong_bump("3"), HasSubstr("bump is 3, must be an object"));
    EXPECT_THAT(wrong_bump("{}"), HasSubstr("bump.input is missing"));
    EXPECT_THAT(wrong_bump(R"({"height": 0.1})"), HasSubstr("bump.input is missing"));
    EXPECT_THAT(wrong_bump(R"({"input": 1, "heigth": 1})"), HasSubstr("did you mean \"height\"?"));
    EXPECT_THAT(wrong_bump(R"({"input": 1, "height": "a"})"), HasSubstr("bump.height is \"a\""));
    EXPECT_THAT(wrong_bump(R"({"input": 1, "height": 1e7})"), HasSubstr("bump.height is"));
    EXPECT_THAT(wrong_bump(R"({"input": {}})"), HasSubstr("bump.input has no key \"node\""));
    EXPECT_THAT(wrong_bump(R"({"input": "#ff0000"})"), HasSubstr("bump.input gives a colour"));
    EXPECT_THAT(wrong_bump(R"({"input": {"node": "marble"}})"),
                HasSubstr("bump.input gives a colour"));
    EXPECT_THAT(wrong_bump(R"({"input": {"node": "fbn"}})"), HasSubstr("did you mean \"fbm\"?"));
    EXPECT_THAT(wrong_bump(R"({"input": {"node": "fbm", "octaves": 1e9}})"),
                HasSubstr("bump.input.octaves is"));
    EXPECT_THAT(
        wrong_bump(R"({"input": {"node": "abs", "input": {"node": "dots", "a": "#ffffff"}}})"),
        HasSubstr("bump.input.input.a gives a colour"));
    EXPECT_THAT(wrong_bump(R"({"input": 1})", {"bump.input.node=marble"}),
                HasSubstr("bump.input gives a colour"));
    EXPECT_THAT(wrong_bump(R"({"input": 1})", {"bump.hight=2"}), HasSubstr("bump.height"));
}

/// Longest side 1 about the origin, in the plane z = 0, facing +z.
Mesh unit_square(double size = 1.0) {
    Mesh mesh;
    const double h = 0.5 * size;
    mesh.positions = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    add_whole_part(mesh);
    return mesh;
}

/// Rises by 1 per unit of s before the scale of 4.
constexpr const char* slope_recipe =
    R"({"solid": {"scale": 4}, "texture": {"stops": [[0, "#ffffff"]]},
    "bump": {"height": 0.25, "input": {"node": "coordinate", "direction": [1, 0, 0]}}})";

TEST(BumpedNormals, HeightIsALengthInTheSolidAndTheScaleMakesSlopesSteeper) {
    // 0.25 * 4 = 1: a slope of 45 degrees, whatever the size of the mesh in its file.
    const Recipe recipe = parse_recipe(slope_recipe, "r");
    for (const double size : {1.0, 0.01, 500.0}) {
        const SurfaceNormal bumped = bumped_normals(recipe, unit_square(size));
        const Vec3d n = bumped({0.1 * size, 0.2 * size, 0}, {0, 0, 1});
        EXPECT_LT(glm::length(n - Vec3d(-std::sqrt(0.5), 0, std::sqrt(0.5))), 1e-13) << size;
    }
    // In the file's own units a smaller height makes the smaller mesh as steep.
    const Recipe object = parse_recipe(slope_recipe, "r", {"solid.space=object"});
    const Vec3d n = bumped_normals(object, unit_square(500.0))({1, 2, 0}, {0, 0, 1});
    EXPECT_LT(glm::length(n - Vec3d(-std::sqrt(0.5), 0, std::sqrt(0.5))), 1e-13);
    EXPECT_FALSE(bumped_normals(parse_recipe("{}", "r"), unit_square()));
}

std::uint8_t grey_at_centre(const Mesh& mesh, const Recipe& recipe, bool lit) {
    PictureOptions options;
    options.size = {21, 21};
    options.lit = lit;
    const View view{0.0, 0.0, 1.0};
    const Camera camera = orbit_camera(view, bounding_sphere(mesh), options.size);
    return render_direct(mesh, recipe, camera, options)(10, 10).r;
}

TEST(BumpedNormals, ShadeTheDirectPicture) {
    // Seen along z, the headlight gives 0.25 + 0.75 cos(45 degrees) in linear light.
    const Mesh mesh = unit_square();
    const Recipe recipe = parse_recipe(slope_recipe, "r");
    const double light = 0.25 + 0.75 * std::sqrt(0.5);
    EXPECT_NEAR(grey_at_centre(mesh, recipe, true), 255.0 * srgb_encode(light), 0.6);
    EXPECT_EQ(grey_at_centre(mesh, recipe, false), 255);
    EXPECT_EQ(grey_at_centre(mesh, parse_recipe(slope_recipe, "r", {"bump.height=0"}), true), 255);
}

TEST(BumpedNormals, AreLitOnTheSideThatIsSeen) {
    const Vec3d n{0, 0, 1}, eye{0.6, 0, 0.8};
    EXPECT_DOUBLE_EQ(headlight(n, n, eye), headlight(n, eye));
    EXPECT_DOUBLE_EQ(headlight(n, eye, eye), 1.0);
    EXPECT_DOUBLE_EQ(headlight(n, -eye, eye), ambient);
    EXPECT_DOUBLE_EQ(headlight(-n, -eye, eye), 1.0);  // a face seen from behind
    EXPECT_DOUBLE_EQ(headlight(-n, eye, eye), ambient);
}

TEST(BumpedNormals, PlacementsCarryThem) {
    // Stretched 4 times along x the slope of 1 is one of 1/4: cosine 1 / sqrt(1 + 1/16).
    Mesh mesh = unit_square();
    Mat4d stretch(1.0);
    stretch[0][0] = 4.0;
    mesh.parts[0].instances = {stretch};
    const double light = 0.25 + 0.75 / std::sqrt(1.0 + 1.0 / 16.0);
    EXPECT_NEAR(grey_at_centre(mesh, parse_recipe(slope_recipe, "r"), true),
                255.0 * srgb_encode(light), 0.6);
}

}  // namespace
}  // namespace burl
