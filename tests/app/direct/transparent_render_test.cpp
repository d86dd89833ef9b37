// Transparent surfaces in the ground truth: layers in any order against Porter and Duff's "over",
// applied from the back to the front.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "app/recipe/edit/recipe_json.h"
#include "app/scene/visibility.h"
#include "app/surface/normals.h"
#include "tests/app/support/direct_picture.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

/// A square of the plane z, 2 wide, seen along z, and its straight colour with alpha.
struct Pane {
    double z = 0.0;
    Vec3d color{0.0};
    double alpha = 1.0;
};

Mesh panes_mesh(const std::vector<Pane>& panes) {
    Mesh mesh;
    for (const Pane& pane : panes) {
        const auto first = std::uint32_t(mesh.positions.size());
        for (const auto& [x, y] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
            mesh.positions.emplace_back(x, y, pane.z);
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    }
    add_whole_part(mesh);
    return mesh;
}

Image<Rgb8> draw_panes(const std::vector<Pane>& panes, std::span<const PlaneLayer> planes = {}) {
    const Mesh mesh = panes_mesh(panes);
    const SampleColor color = [&](const SurfacePoint& point, const Footprint&) {
        const Pane& pane = panes[point.triangle / 2];
        return Vec4d(pane.alpha * pane.color, pane.alpha);
    };
    const PictureOptions options{{21, 21}, false, 1};
    const Camera camera = orbit_camera({0, 0, 3}, bounding_sphere(mesh), options.size);
    return opaque(
        render_samples({mesh, corner_normals(mesh, 40.0), color, {}, planes}, camera, options));
}

/// The colours that the middle shows, from the back to the front.
Rgb8 expected_of(std::vector<Pane> panes) {
    std::ranges::sort(panes, {}, &Pane::z);
    Vec3d light = background_linear();
    for (const Pane& pane : panes) light = pane.alpha * pane.color + (1.0 - pane.alpha) * light;
    const SrgbEncoder<std::uint8_t> encode;
    return {encode(light.x), encode(light.y), encode(light.z)};
}

TEST(TransparentRender, PanesAreSeenThroughOneAnotherInAnyOrder) {
    std::vector<Pane> panes{{0.9, {1, 0, 0}, 0.5},      {0.4, {0, 0.5, 0}, 0.25},
                            {0.1, {1, 1, 1}, 0.0},      {-0.2, {0, 0, 1}, 0.75},
                            {-0.7, {0.3, 0.9, 0}, 1.0}, {-0.9, {1, 1, 1}, 0.5}};
    const Rgb8 expected = expected_of(panes);
    std::mt19937 random(3);
    for (int i = 0; i < 8; ++i) {
        std::ranges::shuffle(panes, random);
        EXPECT_EQ(draw_panes(panes)(10, 10), expected);
    }
    EXPECT_EQ(draw_panes(panes)(0, 0), background_srgb);
}

TEST(TransparentRender, PlanesStandBetweenPanes) {
    const Pane front{0.5, {1, 0, 0}, 0.5}, wall{0.0, {0, 1, 0}, 0.25}, back{-0.5, {0, 0, 1}, 0.5};
    const std::array<PlaneLayer, 1> planes{
        PlaneLayer{{{0, 0, 1}, 0.0}, [&](const Vec3d&, const Footprint&) {
                       return Vec4d(wall.alpha * wall.color, wall.alpha);
                   }}};
    const Image<Rgb8> picture = draw_panes({back, front}, planes);
    EXPECT_EQ(picture(10, 10), expected_of({front, wall, back}));
    EXPECT_EQ(picture(0, 0), expected_of({wall}));
}

TEST(TransparentRender, TrianglesBehindAreThoseThatCoverTheSampleByDepth) {
    const Mesh mesh = sphere_mesh(12, 24);
    const PictureSize size{60, 60};
    const Camera camera = orbit_camera({33, 12, 3.5}, bounding_sphere(mesh), size);
    const auto triangles = screen_triangles(mesh, camera, size);
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) all.push_back(i);
    const auto front = visible_triangles(triangles, all, camera, 60, 0, 60);
    const auto back = triangles_behind(front, triangles, all, camera, 60, 0, 60);
    const auto none = triangles_behind(back, triangles, all, camera, 60, 0, 60);
    int covered = 0;
    for (std::size_t k = 0; k < front.size(); ++k) {
        // A convex surface is crossed twice.
        EXPECT_EQ(front[k] == nothing_visible, back[k] == nothing_visible);
        EXPECT_EQ(none[k], nothing_visible);
        if (front[k] == nothing_visible) continue;
        ++covered;
        const int x = int(k) % 60, y = int(k) / 60;
        EXPECT_LT(depth_of(triangles[front[k]], camera, x, y),
                  depth_of(triangles[back[k]], camera, x, y));
    }
    EXPECT_GT(covered, 500);
}

/// The picture's middle of a sphere with the recipe's material.
Rgb8 middle_of(const std::string& json) {
    const Mesh mesh = sphere_mesh(20, 30);
    const PictureOptions options{{31, 31}, false, 1};
    const Camera camera = orbit_camera({10, 5, 3.5}, bounding_sphere(mesh), options.size);
    return render_direct(mesh, parse_recipe(json, "test"), camera, options)(15, 15);
}

TEST(TransparentRender, ASphereShowsItsBackThroughItsFront) {
    const Vec3d red(1, 0, 0);
    const auto twice = [&](double a) { return expected_of({{1, red, a}, {-1, red, a}}); };
    EXPECT_EQ(middle_of(R"({"material": {"base_color": "#ff000080"}})"), twice(128 / 255.0));
    EXPECT_EQ(middle_of(R"({"material": {"base_color": "#ff0000", "opacity": 0.25}})"),
              twice(0.25));
    EXPECT_EQ(middle_of(R"({"material": {"base_color": "#ff000080",
        "opacity": {"node": "constant", "value": 0.5}}})"),
              twice(64 / 255.0));
    EXPECT_EQ(middle_of(R"({"material": {"base_color": {"stops": [[0, "#ff000040"],
        [1, "#ff000040"]]}}})"),
              twice(64 / 255.0));
}

TEST(TransparentRender, MasksAreThereOrNot) {
    const auto mask = [](const char* cutoff) {
        return middle_of(std::string(R"({"material": {"base_color": "#ff000080", "alpha": "mask",
            "alpha_cutoff": )") +
                         cutoff + "}}");
    };
    EXPECT_EQ(mask("0.5"), (Rgb8{255, 0, 0}));
    EXPECT_EQ(mask("0.51"), background_srgb);
}

TEST(TransparentRender, OpaqueIsOverBlack) {
    const SrgbEncoder<std::uint8_t> encode;
    EXPECT_EQ(middle_of(R"({"material": {"base_color": "#ff000080", "alpha": "opaque"}})"),
              (Rgb8{encode(128 / 255.0), 0, 0}));
}

TEST(TransparentRender, BytesDoNotDependOnThreads) {
    const Mesh mesh = sphere_mesh(20, 30);
    const Recipe recipe = parse_recipe(
        R"({"material": {"base_color": {"stops": [[0, "#20408000"], [1, "#ffffff"]],
            "input": {"node": "fbm", "octaves": 2}}}})",
        "test");
    const PictureOptions options{{60, 50}, true, 2};
    const Camera camera = orbit_camera({10, 20, 3}, bounding_sphere(mesh), options.size);
    const Image<Rgb8> parallel = render_direct(mesh, recipe, camera, options);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(render_direct(mesh, recipe, camera, options), parallel);
}

}  // namespace
}  // namespace burl
