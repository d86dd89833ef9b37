// Heights that are masks of the shape: the normals of whole bakes against closed forms, and against
// the gradients that points have.
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/measure/evaluate_points.h"
#include "app/pipeline/displaced_mesh.h"
#include "app/pipeline/pipeline.h"
#include "app/surface/normals.h"
#include "procedural/color/table.h"
#include "tests/app/pipeline/mask_cases.h"

namespace burl {
namespace {

using Settings = std::vector<std::string>;

Recipe height_recipe(const std::string& height, double rise, Settings settings = {}) {
    settings.push_back("bump.input=" + height);
    settings.push_back(fmt::format("bump.height={}", rise));
    return mask_recipe(R"({"node": "constant", "value": 0.5})", settings);
}

/// A texel inside its triangle: its bumped normal, the normal without bumps, and its point in the
/// SolidAtlas's space.
struct BumpedTexel {
    Vec3d bumped, plain, point;
    std::uint32_t triangle = 0;
};

/// The bumps' normals in the mesh's axes at every third texel that lies well within its triangle.
std::vector<BumpedTexel> bumped_texels(const Mesh& mesh, const Recipe& recipe, double crease) {
    Pipeline pipeline(mesh), flat(mesh);
    pipeline.set_recipe(recipe);
    Recipe none = recipe;
    none.bump.height = 0.0;
    flat.set_recipe(none);
    const auto bumped = pipeline.normal_map<RgbF>(crease, false);
    const auto plain = flat.normal_map<RgbF>(crease, false);
    const auto vector = [](const RgbF& c) { return Vec3d(c.r, c.g, c.b); };
    const SolidAtlas& solid = pipeline.solid();
    const TexelOwners owners(solid, pipeline.atlas(), OwnerReach::lookups);
    const Affine3 map = solid_from_mesh(mesh, recipe.solid.space);
    const ShapeScene scene(pipeline.atlas_mesh());
    std::vector<BumpedTexel> texels;
    std::size_t number = 0;
    for (std::uint32_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                if (++number % 3 != 0) continue;
                const std::uint32_t t = owners(x, y, span.map);
                const Vec3d p = solid.maps[span.map](x, y);
                const Vec3d weights = scene.weights_at(t, (p - map.offset) / map.linear[0][0]);
                if (std::min({weights.x, weights.y, weights.z}) < 0.02) continue;
                texels.push_back({vector(bumped(x, y)), vector(plain(x, y)), p, t});
            }
    EXPECT_GT(texels.size(), 1000u);
    return texels;
}

/// The largest angle, in degrees, between texels' normals and those of heights whose gradient in
/// the SolidAtlas's space is gradient(texel).
template <class Gradient>
double worst_angle(const std::vector<BumpedTexel>& texels, const Gradient& gradient) {
    double worst = 0.0;
    for (const BumpedTexel& texel : texels) {
        const Vec3d& n = texel.plain;
        const Vec3d g = gradient(texel), expected = glm::normalize(n - g + glm::dot(g, n) * n);
        const double sine = glm::length(glm::cross(expected, texel.bumped));
        worst = std::max(worst, std::atan2(sine, glm::dot(expected, texel.bumped)));
    }
    return glm::degrees(worst);
}

double mean_tilt(const std::vector<BumpedTexel>& texels) {
    double sum = 0.0;
    for (const BumpedTexel& texel : texels)
        sum += glm::length(glm::cross(texel.plain, texel.bumped));
    return glm::degrees(std::asin(sum / double(texels.size())));
}

TEST(MaskSlopes, HeightInBoxBumpsAsItsClosedForm) {
    const Mesh mesh = ring_and_plate();
    for (const char* kind : {"quad", "patch"})
        for (const char* space : {"unit", "object"}) {
            const Recipe recipe = height_recipe(
                R"({"node":"height_in_box","axis":"z"})", 0.7,
                {fmt::format("atlas.kind={}", kind), fmt::format("solid.space={}", space),
                 "solid.scale=4", "solid.rotate=[30,0,70]"});
            const auto texels = bumped_texels(mesh, recipe, 40.0);
            const double side = bounding_box(mesh).size().z *
                                solid_from_mesh(mesh, recipe.solid.space).linear[0][0];
            EXPECT_GT(mean_tilt(texels), 10.0 / side);
            EXPECT_LT(
                worst_angle(texels, [&](const BumpedTexel&) { return Vec3d(0, 0, 0.7 / side); }),
                1e-3)
                << kind << " " << space;
        }
}

/// A torus with colours and texture coordinates that are affine functions of its points.
Mesh painted_torus(const Vec3d& red, const Vec3d& u) {
    Mesh mesh = made::torus(1.0, 0.4, 20, 12);
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) {
            const Vec3d& p = mesh.positions[corner];
            mesh.corners.colors.push_back({glm::dot(red, p) + 0.5, 0.25, 1.0, 1.0});
            mesh.corners.uvs.push_back({glm::dot(u, p) - 2.0, 0.5});
        }
    return mesh;
}

TEST(MaskSlopes, AttributesBumpAsTheAffineFunctionsThatTheyAre) {
    const Vec3d red(0.1, -0.2, 0.15), u(1.0, 2.0, -1.0);
    const Mesh mesh = painted_torus(red, u);
    for (const char* kind : {"quad", "patch"}) {
        const Settings settings{fmt::format("atlas.kind={}", kind), "solid.space=object",
                                "solid.rotate=[10,20,30]"};
        // No crease is soft, so that the triangles' own normals are seen.
        const auto by_color = bumped_texels(
            mesh,
            height_recipe(R"({"node":"split","channel":"red","input":{"node":"vertex_color"}})",
                          3.0, settings),
            0.0);
        EXPECT_LT(worst_angle(by_color, [&](const BumpedTexel&) { return 3.0 * red; }), 1e-3);
        EXPECT_GT(mean_tilt(by_color), 10.0);
        const auto by_uv = bumped_texels(
            mesh,
            height_recipe(
                R"({"node":"mesh_uv","input":{"node":"coordinate","direction":[0.5,7,7]}})", 0.4,
                settings),
            0.0);
        EXPECT_LT(worst_angle(by_uv, [&](const BumpedTexel&) { return 0.2 * u; }), 1e-3);
        EXPECT_GT(mean_tilt(by_uv), 10.0);
    }
}

TEST(MaskSlopes, FacingOnASphereBumpsAsItsClosedForm) {
    Mesh mesh = sphere_mesh(48, 96);
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            mesh.corners.normals.push_back(Vec3f(mesh.positions[corner]));
    const Vec3d d(0.48, -0.6, 0.64);
    const Recipe recipe = height_recipe(R"({"node":"facing","direction":[0.48,-0.6,0.64]})", 0.6,
                                        {"solid.space=object", "solid.scale=3"});
    const auto texels = bumped_texels(mesh, recipe, 40.0);
    EXPECT_GT(mean_tilt(texels), 15.0);
    // The sphere's radius is 1; facets lie a thousandth inside.
    EXPECT_LT(worst_angle(texels,
                          [&](const BumpedTexel& texel) {
                              const Vec3d& n = texel.plain;
                              return 0.6 * (d - glm::dot(d, n) * n);
                          }),
              0.1);
}

TEST(MaskSlopes, EdgesOfACubeRiseStraight) {
    const auto texels = bumped_texels(
        cube_mesh(), height_recipe(R"({"node":"edge_distance"})", 0.25, {"solid.space=object"}),
        40.0);
    std::size_t known = 0;
    double worst = 0.0;
    for (const BumpedTexel& texel : texels) {
        // The nearest edge of the cube from -1 to 1 lies in the direction of the larger of the two
        // coordinates along the side.
        Vec3d along = texel.point;
        for (int k = 0; k < 3; ++k)
            if (std::abs(texel.plain[k]) > 0.5) along[k] = 0.0;
        Vec3d size = glm::abs(along);
        const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const double largest = size[axis];
        size[axis] = 0.0;
        if (largest - std::max({size.x, size.y, size.z}) < 0.05) continue;
        Vec3d g(0.0);
        g[axis] = along[axis] > 0.0 ? -0.25 : 0.25;
        worst = std::max(worst, worst_angle({texel}, [&](const BumpedTexel&) { return g; }));
        ++known;
    }
    EXPECT_GT(known, 1000u);
    EXPECT_LT(worst, 1e-3);
}

/// The largest and the mean angle between texels' normals and those that the gradients at points
/// give.
Vec2d angles_to_points(const Mesh& mesh, const std::string& height, double crease) {
    Recipe recipe = height_recipe(
        height, 0.15,
        {"solid.scale=3", "solid.rotate=[0,40,10]", "atlas.size=256", "atlas.kind=patch"});
    const auto texels = bumped_texels(mesh, recipe, crease);
    recipe.texture = recipe.bump.input;
    PointFile file;
    for (const BumpedTexel& texel : texels)
        file.points.push_back({texel.point.x, texel.point.y, texel.point.z, 0.0});
    const std::vector<PointResult> results = evaluate_points(recipe, file, &mesh);
    EXPECT_GT(mean_tilt(texels), 1.0) << height;
    Vec2d angles(0.0);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const std::vector<double>& g = results[i].float64.gradient;
        const double angle = worst_angle(
            {texels[i]}, [&](const BumpedTexel&) { return 0.15 * Vec3d(g[0], g[1], g[2]); });
        angles = {std::max(angles.x, angle), angles.y + angle / double(texels.size())};
    }
    return angles;
}

TEST(MaskSlopes, NormalMapsAndPointsAgree) {
    Mesh mesh = ring_and_plate();
    for (const char* height :
         {R"({"node":"height_in_box"})", R"({"node":"edge_distance","farthest":2})",
          R"({"node":"multiply","a":{"node":"fbm"},"b":{"node":"height_in_box","axis":"x"}})"})
        // In the mean, for the nearest edge may be either of two.
        EXPECT_LT(angles_to_points(mesh, height, 40.0).y, 0.01) << height;
    mesh = sphere_mesh(24, 48);
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            mesh.corners.normals.push_back(Vec3f(mesh.positions[corner]));
    EXPECT_LT(angles_to_points(mesh, R"({"node":"facing"})", 40.0).x, 0.01);
    mesh = painted_torus({0.1, 0.2, 0.3}, {1, 2, 3});
    EXPECT_LT(angles_to_points(
                  mesh, R"({"node":"split","channel":"red","input":{"node":"vertex_color"}})", 0.0)
                  .x,
              0.01);
    // Differences over texels and over points are not the same, but alike.
    EXPECT_LT(angles_to_points(made::cuboid({0, 0, 0}, {1, 1, 1}),
                               R"({"node":"curvature","radius":0.6})", 40.0)
                  .y,
              4.0);
}

TEST(MaskSlopes, TheNodeSlopeSeesThem) {
    // On the sheet red is x / 2, u is 3 x + 1, at a scale of 2 in the file's units.
    for (const char* precision : {"float32", "float64"}) {
        Pipeline pipeline(drawn_sheet());
        pipeline.set_recipe(mask_recipe(
            R"({"node": "combine",
                "red": {"node": "slope", "direction": [1, 0, 0],
                        "input": {"node": "split", "channel": "red",
                                  "input": {"node": "vertex_color"}}},
                "green": {"node": "slope", "direction": [0.25, 0, 0], "input": {"node": "mesh_uv",
                          "input": {"node": "coordinate"}}},
                "blue": {"node": "slope", "direction": [0, 1, 0],
                         "input": {"node": "height_in_box"}}})",
            {"solid.space=object", "solid.scale=2", fmt::format("precision.kind={}", precision)}));
        const Image<RgbF> picture = pipeline.synthesize<RgbF>();
        std::size_t seen = 0;
        for (const RgbF& texel : picture.pixels()) {
            if (texel == RgbF{}) continue;
            ASSERT_NEAR(texel.r, 0.25, 1e-6);
            ASSERT_NEAR(texel.g, 0.375, 1e-6);
            ASSERT_NEAR(texel.b, 0.25, 1e-6);
            ++seen;
        }
        EXPECT_GT(seen, 128u * 64u);
    }
}

TEST(MaskSlopes, DisplacementMovesPointsByMasks) {
    const Mesh mesh = made::torus(1.0, 0.4, 24, 16);
    Mesh rest = mesh;
    rest.corners.normals = corner_normals(mesh, 180.0);
    const Recipe recipe =
        height_recipe(R"({"node":"height_in_box","axis":"z"})", 0.5, {"solid.space=object"});
    const Mesh moved = displaced_mesh(rest, recipe, rest);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3d& p = mesh.positions[i];
        EXPECT_NEAR(glm::distance(moved.positions[i], p), 0.5 * (p.z + 0.4) / 0.8, 1e-4);
    }
}

}  // namespace
}  // namespace burl
