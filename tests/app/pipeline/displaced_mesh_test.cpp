// Displacement against closed forms, and against the normals of bumps of the same height.
#include "app/pipeline/displaced_mesh.h"
#include "app/recipe/edit/recipe_json.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/pipeline/texture_color.h"
#include "app/recipe/edit/images.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/mesh/subdivide.h"

namespace burl {
namespace {

Recipe bumpy_recipe(const std::string& json) {
    RecipeImages images;
    return parse_recipe(json, "d.json", {}, images);
}

TEST(DisplacedMesh, AConstantHeightMovesASphereOutwards) {
    const Mesh sphere = subdivided(sample_mesh("sample:icosphere"), 1);
    const double unit = bounding_box(sphere).longest_side();
    const Mesh moved = displaced_mesh(
        sphere, bumpy_recipe(R"({"material": {"height": 0.5}, "bump": {"height": 0.2}})"), sphere);
    ASSERT_EQ(moved.triangles, sphere.triangles);
    for (std::size_t i = 0; i < moved.positions.size(); ++i) {
        const Vec3d by = moved.positions[i] - sphere.positions[i];
        EXPECT_NEAR(glm::length(by), 0.1 * unit, 1e-12 * unit);
        EXPECT_GT(glm::dot(glm::normalize(by), glm::normalize(sphere.positions[i])), 0.999);
    }
}

TEST(DisplacedMesh, TheHeightIsThatOfTheSolidPoint) {
    const Mesh cube = subdivided(sample_mesh("sample:cube"), 3);
    const Recipe recipe = bumpy_recipe(R"({"solid": {"space": "object", "scale": 2},
        "material": {"height": {"node": "coordinate", "direction": [1, 0, 0]}},
        "bump": {"height": 0.25}})");
    const Mesh moved = displaced_mesh(cube, recipe, cube);
    for (std::size_t i = 0; i < moved.positions.size(); ++i)
        EXPECT_NEAR(glm::length(moved.positions[i] - cube.positions[i]),
                    std::abs(0.25 * 2 * cube.positions[i].x), 1e-9);
}

TEST(DisplacedMesh, HeightsThatAreNoNumbersAreRefused) {
    const Mesh cube = sample_mesh("sample:cube");
    EXPECT_THROW(displaced_mesh(cube, bumpy_recipe(R"({"material": {"height": {"node": "power",
                                         "input": 1e9, "exponent": 40}}})"),
                                cube),
                 Error);
}

/// The greatest angle, in radians, between the faces of a displaced sphere and the normals that
/// bumps of the same height have there.
double angle_to_bumps(int times, double height) {
    const Mesh sphere = subdivided(sample_mesh("sample:icosphere"), times);
    // On a true sphere, so that normals are known at every point.
    Mesh round = sphere;
    for (Vec3d& p : round.positions) p = glm::normalize(p);
    const Recipe recipe = bumpy_recipe(fmt::format(
        R"({{"solid": {{"space": "object"}}, "bump": {{"height": {}}},
            "material": {{"height": {{"node": "sin", "input": {{"node": "coordinate",
            "direction": [5, 3, 1]}}}}}}}})",
        height));
    const Mesh moved = displaced_mesh(round, recipe, round);
    const SurfaceNormal bumped = bumped_normals(recipe, round);
    double worst = 0.0;
    for (const Triangle& t : round.triangles) {
        const auto face = [&t](const Mesh& mesh) {
            const auto& p = mesh.positions;
            return glm::normalize(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
        };
        const auto& p = round.positions;
        const Vec3d middle = glm::normalize(p[t[0]] + p[t[1]] + p[t[2]]);
        worst = std::max(worst,
                         std::acos(std::min(1.0, glm::dot(face(moved), bumped(middle, middle)))));
    }
    return worst;
}

TEST(DisplacedMesh, FacesHaveTheNormalsOfBumpsOfTheSameHeight) {
    // Bumps leave out terms of the order of height times curvature, facets of the edge's length.
    const double coarse = angle_to_bumps(2, 0.01), fine = angle_to_bumps(4, 0.01);
    EXPECT_LT(fine, 0.6 * coarse);
    EXPECT_LT(fine, 0.01);
    EXPECT_GT(angle_to_bumps(4, 0.05), angle_to_bumps(4, 0.005));
}

}  // namespace
}  // namespace burl
