// Deformation as the command line has it: the texture sticks to a mesh whose shape changes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/base/json_text.h"
#include "app/gl/draw/view_scene.h"
#include "app/image/image_io.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/scene/scene.h"
#include "app/scene/surface_pick.h"
#include "app/surface/normals.h"
#include "app/surface/posed_corners.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

using test::Outcome;
using test::run_burl;
using test::Scratch;

/// Where a point of the grid goes.
Vec3d lifted(const Vec3d& p) {
    return p + Vec3d(0.0, 0.5 * p.x * p.x, 0.25 * p.x);
}

/// A box of a grid of quads on each side, so that charts have borders; `posed`: lifted.
std::string box_obj(bool posed) {
    std::string text, faces;
    int count = 0;
    const auto side = [&](const Vec3d& corner, const Vec3d& u, const Vec3d& v) {
        constexpr int n = 4;
        for (int i = 0; i <= n; ++i)
            for (int k = 0; k <= n; ++k) {
                const Vec3d p = corner + double(i) / n * u + double(k) / n * v;
                const Vec3d q = posed ? lifted(p) : p;
                text += fmt::format("v {} {} {}\n", q.x, q.y, q.z);
            }
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < n; ++k) {
                const int a = count + i * (n + 1) + k + 1, b = a + n + 1;
                faces += fmt::format("f {} {} {} {}\n", a, b, b + 1, a + 1);
            }
        count += (n + 1) * (n + 1);
    };
    const Vec3d x(2, 0, 0), y(0, 1, 0), z(0, 0, 1), low(-1, -0.5, -0.5), high(1, 0.5, 0.5);
    side(low, y, x), side(low, z, y), side(low, x, z);
    side(high, -x, -y), side(high, -y, -z), side(high, -z, -x);
    return text + faces;
}

struct PoseBake : testing::Test {
    PoseBake() {
        scratch.write("box.obj", box_obj(false));
        scratch.write("bent.obj", box_obj(true));
    }
    Outcome bake(const std::string& out, const std::string& more, const char* atlas = "") const {
        return run_burl(scratch, fmt::format("bake '{}' -o '{}' -s 128 -q {} {}",
                                             scratch / "box.obj", scratch / out, atlas, more));
    }
    std::string pose() const { return fmt::format("--pose '{}'", scratch / "bent.obj"); }
    Scratch scratch;
};

TEST_F(PoseBake, AGlbHasTheMeshAtRestAndTheWayToThePose) {
    ASSERT_EQ(bake("rest.glb", "").exit_code, 0);
    ASSERT_EQ(bake("posed.glb", pose() + " --set pose.weight=0.25").exit_code, 0);
    const Scene rest = load_scene(scratch / "rest.glb"), posed = load_scene(scratch / "posed.glb");
    ASSERT_EQ(posed.surfaces.size(), 1u);
    const Surface& surface = posed.surfaces[0];
    EXPECT_EQ(surface.positions, rest.surfaces[0].positions);
    EXPECT_EQ(surface.triangles, rest.surfaces[0].triangles);
    EXPECT_EQ(surface.uvs, rest.surfaces[0].uvs);
    EXPECT_EQ(posed.textures[0].image, rest.textures[0].image);
    EXPECT_EQ(surface.target_share, 0.25);
    ASSERT_EQ(surface.target.positions.size(), surface.positions.size());
    // Middles of edges go half-way between its ends; the grid's own points by the formula.
    const Mat4d& place = surface.placements[0];
    double worst = 0.0;
    for (std::size_t i = 0; i < surface.positions.size(); ++i) {
        const Vec3d p(place * Vec4d(surface.positions[i], 1.0));
        const Vec3d end(place * Vec4d(surface.positions[i] + surface.target.positions[i], 1.0));
        const double column = 2.0 * (p.x + 1.0);
        if (std::abs(column - std::round(column)) < 1e-6)
            worst = std::max(worst, glm::distance(end, lifted(p)));
    }
    EXPECT_LT(worst, 1e-6);
    for (std::size_t i = 0; i < surface.normals.size(); ++i)
        EXPECT_NEAR(glm::length(surface.normals[i] + surface.target.normals[i]), 1.0, 1e-6);
}

TEST_F(PoseBake, AnObjIsWrittenInThePose) {
    ASSERT_EQ(bake("posed.obj", pose() + " --set pose.weight=0.5", "--atlas quad").exit_code, 0);
    const Mesh rest = read_mesh(scratch / "box.obj"), posed = read_mesh(scratch / "posed.obj");
    ASSERT_EQ(posed.triangles.size(), rest.triangles.size());
    for (std::size_t t = 0; t < rest.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d p = rest.positions[rest.triangles[t][k]];
            EXPECT_LT(
                glm::distance(posed.positions[posed.triangles[t][k]], 0.5 * p + 0.5 * lifted(p)),
                1e-12);
        }
}

TEST_F(PoseBake, APoseThatIsTheMeshItselfChangesNothing) {
    const Mesh mesh = read_mesh(scratch / "box.obj");
    const MeshPose pose = load_pose(scratch / "box.obj", scratch / "box.obj");
    const std::vector<Vec3f> normals = corner_normals(mesh, 40.0);
    const PosedCorners corners = posed_corners(mesh, pose, normals);
    EXPECT_EQ(corners.normals, normals);
    EXPECT_EQ(corners.points.triangles, mesh.triangles);
}

TEST_F(PoseBake, NormalsOfARigidTurnAreTurned) {
    Mesh mesh = read_mesh(scratch / "box.obj");
    const Mat3d turn(Vec3d(0, 1, 0), Vec3d(-1, 0, 0), Vec3d(0, 0, 1));
    MeshPose pose{"turned", {}, {}};
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t) pose.positions.push_back(turn * mesh.positions[p]);
    // Authored normals that are not the faces' own keep their angle to the surface.
    std::vector<Vec3f> normals = corner_normals(mesh, 40.0);
    for (Vec3f& n : normals) n = glm::normalize(n + Vec3f(0.05f, -0.02f, 0.03f));
    const PosedCorners corners = posed_corners(mesh, pose, normals);
    for (std::size_t c = 0; c < normals.size(); ++c) {
        const Vec3d face = glm::normalize(glm::cross(
            mesh.positions[mesh.triangles[c / 3][1]] - mesh.positions[mesh.triangles[c / 3][0]],
            mesh.positions[mesh.triangles[c / 3][2]] - mesh.positions[mesh.triangles[c / 3][0]]));
        EXPECT_NEAR(glm::dot(Vec3d(corners.normals[c]), turn * face),
                    glm::dot(Vec3d(normals[c]), face), 1e-6);
    }
}

TEST_F(PoseBake, OtherMeshesAndMissingTargetsAreOneSentence) {
    scratch.write("other.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (const std::string& pose :
         {fmt::format("--pose '{}'", scratch / "other.obj"), std::string("--pose smile"),
          fmt::format("--pose '{}'", scratch / "missing.obj")}) {
        const Outcome outcome = bake("bad.glb", pose);
        EXPECT_NE(outcome.exit_code, 0) << pose;
        test::expect_one_sentence(outcome.err);
        EXPECT_FALSE(std::filesystem::exists(scratch / "bad.glb"));
    }
    const Outcome over = bake("bent.obj", pose());
    EXPECT_EQ(over.exit_code, 2);
    EXPECT_NE(over.err.find("bent.obj"), std::string::npos) << over.err;
}

TEST_F(PoseBake, PicturesOfABakeAndOfALazyMeshAreTheSame) {
    const std::string look = "--size 96x72 --supersample 1 --view 20,30,3";
    ASSERT_EQ(bake("posed.glb", pose() + " --levels all --level-rule direct").exit_code, 0);
    ASSERT_EQ(run_burl(scratch, fmt::format("render '{}' -o '{}' {}", scratch / "posed.glb",
                                            scratch / "a.png", look))
                  .exit_code,
              0);
    const auto lazily = [&](const std::string& out, const std::string& more) {
        return run_burl(scratch,
                        fmt::format("render --lazy '{}' {} --set atlas.size=128 -o '{}' {} {}",
                                    scratch / "box.obj", pose(), scratch / out, look, more));
    };
    ASSERT_EQ(lazily("b.png", "").exit_code, 0);
    EXPECT_EQ(read_png(scratch / "a.png"), read_png(scratch / "b.png"));
    ASSERT_EQ(lazily("rest.png", "--set pose.weight=0").exit_code, 0);
    EXPECT_NE(read_png(scratch / "b.png"), read_png(scratch / "rest.png"));
}

/// Largest difference where both pictures show the object, leaving out what an edge may move.
double median_difference(const Image<Rgb8>& a, const Image<Rgb8>& b) {
    std::vector<int> differences;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const Rgb8 p = a.pixels()[i], q = b.pixels()[i];
        differences.push_back(
            std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)}));
    }
    std::ranges::sort(differences);
    return differences[differences.size() * 9 / 10];
}

TEST_F(PoseBake, ThePictureIsThatOfTheTextureItselfOnThePosedSurface) {
    const std::string look =
        fmt::format("'{}' {} --recipe wood --size 96x72 --supersample 2 --view 20,30,3",
                    scratch / "box.obj", pose());
    ASSERT_EQ(run_burl(scratch, fmt::format("render --direct {} -o '{}'", look, scratch / "d.png"))
                  .exit_code,
              0);
    ASSERT_EQ(run_burl(scratch, fmt::format("render --lazy {} --set atlas.size=256 -o '{}'", look,
                                            scratch / "l.png"))
                  .exit_code,
              0);
    const Image<Rgb8> direct = read_png(scratch / "d.png");
    EXPECT_LE(median_difference(direct, read_png(scratch / "l.png")), 12.0);
}

TEST_F(PoseBake, AKeyedWeightMovesTheMeshOverTime) {
    scratch.write("moving.json", R"({"burl": 1, "name": "moving", "texture": {"node": "color_map",
        "stops": [[0, "#202020"], [1, "#ffffff"]], "input": {"node": "field",
        "noise": [{"kind": "value"}]}}, "animation": {"seconds": 2, "tracks": [
        {"path": "pose.weight", "keys": [[0, 0], [2, 1]]}]}})");
    const auto frame = [&](const std::string& out, const std::string& time) {
        return run_burl(scratch, fmt::format("render --direct '{}' {} --recipe '{}' --size 48x36 "
                                             "--supersample 1 -o '{}' {}",
                                             scratch / "box.obj", pose(), scratch / "moving.json",
                                             scratch / out, time))
            .exit_code;
    };
    ASSERT_EQ(frame("one.png", "--time 1"), 0);
    ASSERT_EQ(frame("all.png", "--frames 3"), 0);
    EXPECT_EQ(read_png(scratch / "all.0002.png"), read_png(scratch / "one.png"));
    EXPECT_NE(read_png(scratch / "all.0003.png"), read_png(scratch / "one.png"));
}

TEST(Pose, TheWeightRepeatsNothingOfTheTexture) {
    Recipe recipe = load_recipe("marble", {"atlas.size=64", "atlas.tries=1"});
    Pipeline pipeline(sample_mesh("sample:cube"));
    pipeline.set_cache(1 << 20);
    pipeline.set_recipe(recipe);
    const Image<Rgb8> before = *pipeline.picture<Rgb8>();
    const std::uint64_t runs = pipeline.records()[Stage::synthesis].runs;
    const std::uint64_t layouts = pipeline.records()[Stage::layout].runs;
    recipe.pose.weight = 0.3;
    pipeline.set_recipe(recipe);
    EXPECT_EQ(*pipeline.picture<Rgb8>(), before);
    EXPECT_EQ(pipeline.records()[Stage::synthesis].runs, runs);
    EXPECT_EQ(pipeline.records()[Stage::layout].runs, layouts);
}

TEST(Pose, TheWeightIsReadAndWrittenWhereItIsNotTheDefault) {
    const Recipe plain = load_recipe("marble");
    EXPECT_EQ(plain.pose.weight, 1.0);
    EXPECT_EQ(to_json(plain).find("pose"), std::string::npos);
    const Recipe half = load_recipe("marble", {"pose.weight=0.5"});
    EXPECT_EQ(half.pose.weight, 0.5);
    EXPECT_EQ(parse_recipe(to_json(half), "test"), half);
    EXPECT_THROW(load_recipe("marble", {"pose.weight=1.5"}), Error);
}

TEST(Pose, AHandHitsThePosedSurfaceAndTouchesTheOneAtRest) {
    auto scene = std::make_shared<Scene>();
    Surface& surface = scene->surfaces.emplace_back();
    surface.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    surface.normals.assign(3, Vec3f(0, 0, 1));
    surface.triangles = {{0, 1, 2}};
    surface.target.positions.assign(3, Vec3d(0, 0, 4));
    const Ray ray{{0.25, 0.25, 10}, {0, 0, -1}, 0.0, 100.0};
    const auto rest = SurfacePick(scene).meet(ray), half = SurfacePick(scene, 0.5).meet(ray);
    ASSERT_TRUE(rest && half);
    EXPECT_EQ(rest->point, Vec3d(0.25, 0.25, 0));
    EXPECT_EQ(half->point, Vec3d(0.25, 0.25, 2));
    EXPECT_EQ(half->mesh_point, Vec3d(0.25, 0.25, 0));
    EXPECT_EQ(half->depth, 8.0);
}

}  // namespace
}  // namespace burl
