// What stands behind a surface that transmits, by rays: panes before walls and planes, whose light
// is known.
#include <optional>

#include <gtest/gtest.h>

#include "app/direct/render.h"
#include "app/direct/traced_light.h"
#include "procedural/color/srgb.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

constexpr PictureSize size{9, 9};

Environment white_room() {
    return {Image<RgbF>(64, 32, {1.0f, 1.0f, 1.0f})};
}

/// Squares about the z axis that face +z, 2 wide, and the materials of the squares in their order.
struct Squares {
    Mesh mesh;
    std::vector<Vec3f> normals;
    std::vector<MaterialSample> materials;

    void add(double z, const MaterialSample& material) {
        const auto first = std::uint32_t(mesh.positions.size());
        for (const auto& [x, y] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
            mesh.positions.emplace_back(x, y, z);
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
        normals.insert(normals.end(), 6, Vec3f(0.0f, 0.0f, 1.0f));
        materials.push_back(material);
    }
};

/// A thin pane that reflects nothing and lets this share of light through.
MaterialSample pane(const Vec3d& color, double roughness = 0.0) {
    MaterialSample material;
    material.point.base = color, material.point.roughness = roughness;
    material.point.specular = 0.0, material.point.transmission = 1.0;
    return material;
}

/// A black surface that glows.
MaterialSample lamp(const Vec3d& light, double alpha = 1.0) {
    MaterialSample material;
    material.point.base = Vec3d(0.0), material.point.specular = 0.0;
    material.point.emissive = light;
    material.alpha = alpha;
    return material;
}

/// The light in the middle of the picture, seen from +z.
Vec3d middle(Squares squares, const std::optional<PlaneLayer>& plane = std::nullopt) {
    add_whole_part(squares.mesh);
    std::vector<PlaneLayer> planes;
    std::vector<Plane> bare;
    if (plane) planes.push_back(*plane), bare.push_back(plane->plane);
    const Blockers blockers(squares.mesh, bare);
    const TracedLight light(white_room(), 64, &blockers);
    DirectScene scene{squares.mesh, squares.normals, {}, {}, planes};
    scene.material = [&](const SurfacePoint& at, const Footprint&) {
        EXPECT_NEAR(at.weights.x + at.weights.y + at.weights.z, 1.0, 1e-9);
        EXPECT_GE(std::min({at.weights.x, at.weights.y, at.weights.z}), -1e-6);
        return squares.materials[at.triangle / 2];
    };
    scene.around.light = &light, scene.around.blockers = &blockers;
    PictureOptions options{size, true, 1};
    options.light.light = "neutral", options.light.tone_curve = false;
    Camera camera = orbit_camera({0, 0, 3}, {Vec3d(0.0), 2.0}, size);
    const Rgba8 c = render_samples(scene, camera, options)(4, 4);
    return {srgb_decode(c.r / 255.0), srgb_decode(c.g / 255.0), srgb_decode(c.b / 255.0)};
}

void expect_light(const Vec3d& have, const Vec3d& want) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(have[k], want[k], 0.03) << k;
}

TEST(Through, APaneShowsTheRoomOrTheWallBehindIt) {
    Squares squares;
    squares.add(0.0, pane({0.5, 0.8, 0.25}));
    expect_light(middle(squares), {0.5, 0.8, 0.25});
    squares.add(-0.5, lamp({0.9, 0.1, 0.4}));
    expect_light(middle(squares), {0.45, 0.08, 0.1});
}

TEST(Through, PanesMultiply) {
    Squares squares;
    squares.add(0.5, pane({0.5, 0.8, 0.25}));
    squares.add(0.0, pane({0.6, 0.5, 1.0}));
    expect_light(middle(squares), {0.3, 0.4, 0.25});
    squares.add(-0.5, lamp({1.0, 0.5, 0.0}));
    expect_light(middle(squares), {0.3, 0.2, 0.0});
}

TEST(Through, WhatIsTransparentBehindAPaneShowsWhatIsBehindIt) {
    Squares squares;
    squares.add(0.5, pane({0.5, 0.5, 0.5}));
    squares.add(0.0, lamp({0.0, 1.0, 0.0}, 0.25));
    expect_light(middle(squares), {0.375, 0.5, 0.375});
    squares.add(-0.5, lamp({0.8, 0.0, 0.0}));
    expect_light(middle(squares), {0.3, 0.125, 0.0});
}

TEST(Through, ARoughPaneAveragesWhatIsBehindIt) {
    Squares squares;
    squares.add(0.0, pane({1.0, 1.0, 1.0}, 0.5));
    squares.add(-0.001, lamp({0.3, 0.2, 0.1}));
    // A rough surface loses what it would let through more than once.
    const Vec3d seen = middle(squares);
    EXPECT_NEAR(seen.y / seen.x, 2.0 / 3.0, 0.03);
    EXPECT_GT(seen.x, 0.25);
    EXPECT_LT(seen.x, 0.33);
}

TEST(Through, PlanesAreSeen) {
    PlaneLayer layer;
    layer.plane = {{0.0, 0.0, 1.0}, -0.7};
    layer.material = [](const Vec3d& at, const Footprint&) {
        EXPECT_NEAR(at.z, -0.7, 1e-9);
        return lamp({0.2, 0.4, 0.8});
    };
    Squares squares;
    squares.add(0.0, pane({0.5, 0.5, 0.5}));
    expect_light(middle(squares, layer), {0.1, 0.2, 0.4});
}

}  // namespace
}  // namespace burl
