#include "app/direct/render.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <vector>

#include "app/scene/visibility.h"
#include "app/surface/normals.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

/// Square [-1,1]^2 in the plane z, facing +z, split along its diagonal.
Mesh square_mesh(double z = 0.0) {
    Mesh mesh;
    mesh.name = "square";
    mesh.positions = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    add_whole_part(mesh);
    return mesh;
}

using SurfaceColor = std::function<Vec3d(const Vec3d& mesh_point)>;

Image<Rgb8> draw(const Mesh& mesh, const SurfaceColor& color, const View& view,
                 const PictureOptions& options) {
    const Camera camera = orbit_camera(view, bounding_sphere(mesh), options.size);
    const auto at = [&](const SurfacePoint& point) { return color(position(mesh, point)); };
    return render_points(mesh, corner_normals(mesh, 40.0), at, camera, options);
}

std::vector<std::uint32_t> all_of(const std::vector<ScreenTriangle>& triangles) {
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) indices.push_back(i);
    return indices;
}

/// How many of the mesh's triangles cover each sample, each drawn alone.
std::vector<int> cover_counts(const Mesh& mesh, const Camera& camera, const PictureSize& size) {
    const auto triangles = screen_triangles(mesh, camera, size);
    std::vector<int> counts(std::size_t(size.width * size.height), 0);
    for (const std::uint32_t index : all_of(triangles)) {
        const auto visible =
            visible_triangles(triangles, std::vector{index}, camera, size.width, 0, size.height);
        for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += visible[i] != nothing_visible;
    }
    return counts;
}

TEST(Visibility, SharedEdgesThroughSampleCentresAreDrawnOnce) {
    // In a square picture of odd size the diagonal runs through sample centres, and the picture is
    // framed so that the square's borders do too.
    const PictureSize size{33, 33};
    Camera camera;
    camera.eye = {0, 0, 1};
    camera.focal_x = camera.focal_y = 16.0 / 16.5;  // borders at samples 0 and 32
    camera.near_distance = 0.5;
    camera.far_distance = 2.0;
    const std::vector<int> counts = cover_counts(square_mesh(), camera, size);
    int once = 0;
    for (int y = 0; y < 33; ++y) {
        for (int x = 0; x < 33; ++x) {
            const int count = counts[std::size_t(33 * y + x)];
            EXPECT_LE(count, 1);
            once += count;
            const bool inner = x > 0 && x < 32 && y > 0 && y < 32;
            EXPECT_TRUE(count == 1 || !inner) << x << ',' << y;
        }
    }
    EXPECT_EQ(once, 32 * 32);  // top and left borders are in, bottom and right ones out
}

TEST(Visibility, ConvexFrontIsCoveredExactlyOnce) {
    const Mesh mesh = sphere_mesh(12, 24);
    const PictureSize size{80, 80};
    const Camera camera = orbit_camera({33, 12, 3.5}, bounding_sphere(mesh), size);
    for (const int count : cover_counts(mesh, camera, size)) {
        EXPECT_TRUE(count == 0 || count == 2) << count;  // front and back
    }
}

TEST(Visibility, BarycentricsGiveThePointBack) {
    const Mesh mesh = sphere_mesh(6, 9);
    const PictureSize size{64, 48};
    const Camera camera = orbit_camera({120, -35, 2.0}, bounding_sphere(mesh), size);
    const auto triangles = screen_triangles(mesh, camera, size);
    const auto visible =
        visible_triangles(triangles, all_of(triangles), camera, size.width, 0, size.height);
    int checked = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const std::uint32_t index = visible[std::size_t(y * size.width + x)];
            if (index == nothing_visible) continue;
            const Vec3d b = barycentrics(triangles[index], x, y);
            Vec3d point(0.0);
            for (std::size_t k = 0; k < 3; ++k) {
                point += b[int(k)] * mesh.positions[mesh.triangles[triangles[index].triangle][k]];
            }
            const Vec3d pixel = project(camera, size, point);
            EXPECT_NEAR(pixel.x, x + 0.5, 1e-9);
            EXPECT_NEAR(pixel.y, y + 0.5, 1e-9);
            ++checked;
        }
    }
    EXPECT_GT(checked, 500);
}

TEST(DirectRender, EveryPixelShowsItsOwnPoint) {
    const SurfaceColor color = [](const Vec3d& p) { return 0.5 * p + Vec3d(0.5, 0.5, 0.25); };
    const PictureOptions options{{60, 50}, false, 1};
    const Mesh mesh = square_mesh();
    const Image<Rgb8> picture = draw(mesh, color, {0, 0, 2.0}, options);
    const double eye = 2.0 * std::sqrt(2.0);
    const double half_height = eye * std::tan(17.5 * std::numbers::pi / 180.0);
    const SrgbEncoder<std::uint8_t> encode;
    int covered = 0;
    for (int y = 0; y < 50; ++y) {
        for (int x = 0; x < 60; ++x) {
            const Vec3d p((x + 0.5 - 30) / 25 * half_height, (25 - y - 0.5) / 25 * half_height, 0);
            if (std::max(std::abs(p.x), std::abs(p.y)) > 1.0) {
                EXPECT_EQ(picture(std::size_t(x), std::size_t(y)), background_srgb);
                continue;
            }
            const Vec3d c = color(p);
            EXPECT_EQ(picture(std::size_t(x), std::size_t(y)),
                      (Rgb8{encode(c.x), encode(c.y), encode(c.z)}));
            ++covered;
        }
    }
    EXPECT_GT(covered, 1500);
}

TEST(DirectRender, HeadlightByHand) {
    // Seen at 60 degrees from far away, n.v = 1/2: 0.25 + 0.75 / 2 = 0.625 of the colour.
    const PictureOptions options{{9, 9}, true, 1};
    const Image<Rgb8> picture = draw(
        square_mesh(), [](const Vec3d&) { return Vec3d(0.8); }, {60, 0, 1.5}, options);
    const SrgbEncoder<std::uint8_t> encode;
    EXPECT_EQ(picture(4, 4).r, encode(0.8 * 0.625));
    // From behind the same: lighting is two-sided.
    const Image<Rgb8> behind = draw(
        square_mesh(), [](const Vec3d&) { return Vec3d(0.8); }, {120, 0, 1.5}, options);
    EXPECT_EQ(behind(4, 4).r, encode(0.8 * 0.625));
}

TEST(DirectRender, SupersamplesInLinearLight) {
    // A black and white border through the middle of a pixel column: half the light, not half the
    // code.
    const PictureOptions options{{9, 9}, false, 4};
    const Image<Rgb8> picture = draw(
        square_mesh(), [](const Vec3d& p) { return Vec3d(p.x < 0 ? 0.0 : 1.0); }, {0, 0, 1.5},
        options);
    EXPECT_EQ(picture(3, 4), (Rgb8{0, 0, 0}));
    EXPECT_EQ(picture(4, 4), (Rgb8{188, 188, 188}));  // sRGB code of 1/2
    EXPECT_EQ(picture(5, 4), (Rgb8{255, 255, 255}));
}

TEST(DirectRender, FrontmostWinsInEitherOrder) {
    for (const bool front_first : {true, false}) {
        Mesh mesh = square_mesh(front_first ? 0.5 : -0.5);
        const Mesh other = square_mesh(front_first ? -0.5 : 0.5);
        for (const Triangle& t : other.triangles) {
            mesh.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
        }
        mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
        add_whole_part(mesh);
        const Image<Rgb8> picture =
            draw(mesh, [](const Vec3d& p) { return p.z > 0 ? Vec3d(1, 0, 0) : Vec3d(0, 0, 1); },
                 {0, 0, 2}, {{21, 21}, false, 1});
        EXPECT_EQ(picture(10, 10), (Rgb8{255, 0, 0}));
    }
}

TEST(DirectRender, PlacementsShowTheFirstOnesColors) {
    Mesh mesh = square_mesh();
    Mat4d right(1.0), left(1.0);
    left[3] = {-1.5, 0, 0, 1};
    right[3] = {1.5, 0, 0, 1};
    mesh.parts[0].instances = {left, right};  // both moved: the middle stays empty
    const Image<Rgb8> picture =
        draw(mesh, [](const Vec3d& p) { return Vec3d(p.x > 0 ? 1.0 : 0.0, 0, 1); }, {0, 0, 3},
             {{100, 40}, false, 1});
    EXPECT_EQ(picture(50, 20), background_srgb);
    // Two squares, each black-red half beside full half, in the mesh's own coordinates.
    for (std::size_t x = 0; x < 25; ++x) EXPECT_EQ(picture(x, 20), picture(x, 19));
    int changes = 0;
    for (std::size_t x = 1; x < 100; ++x) changes += picture(x, 20) != picture(x - 1, 20);
    EXPECT_EQ(changes, 6);  // background, 0, 1, background, 0, 1, background
}

TEST(DirectRender, BytesDoNotDependOnThreads) {
    const auto picture = [] {
        return draw(sphere_mesh(20, 30), [](const Vec3d& p) { return Vec3d(0.5) + 0.5 * p; },
                    {10, 20, 3}, {{90, 70}, true, 2});
    };
    const Image<Rgb8> parallel = picture();
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(picture(), parallel);
}

TEST(DirectRender, SizeOfTheSceneDoesNotMatter) {
    const auto picture_at = [](double scale) {
        Mesh mesh = sphere_mesh(8, 12);
        for (Vec3d& p : mesh.positions) p *= scale;
        return draw(mesh, [&](const Vec3d& p) { return Vec3d(0.5) + 0.5 * p / scale; }, {10, 20, 3},
                    {{40, 40}, true, 1});
    };
    EXPECT_EQ(picture_at(1.0), picture_at(std::ldexp(1.0, 300)));
    EXPECT_EQ(picture_at(1.0), picture_at(std::ldexp(1.0, -300)));
}

}  // namespace
}  // namespace burl
