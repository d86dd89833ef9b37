// Balls under an environment: OpenGL's pixels against the host's ambient_shading() at the points
// of an exact sphere, a white furnace, and what surrounds a scene.
#include "app/gl/draw/light.h"

#include <gtest/gtest.h>

#include "app/gl/draw/render.h"
#include "app/light/brdf.h"
#include "app/light/tone.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

using GlLightTest = GlTest;

constexpr PictureSize size{96, 96};

/// A ball of radius 1 with its exact normals.
Scene ball(const SceneMaterial& material) {
    const Mesh mesh = sphere_mesh(96, 192);
    Scene scene;
    Surface& surface = scene.surfaces.emplace_back();
    surface.positions = mesh.positions;
    for (const Vec3d& p : mesh.positions) surface.normals.emplace_back(p);
    surface.triangles = mesh.triangles;
    surface.material = material;
    return scene;
}

/// Linear light with alpha, one sample a pixel.
Image<RgbaF> drawn_light(GlContext& context, const Scene& scene, const Camera& camera,
                         const PrefilteredLight& light) {
    context.make_current();
    const GladGLContext& gl = context.gl();
    const GlScene drawn(gl, scene);
    const GlLight gl_light(gl, light);
    const GlFramebuffer target(gl, size.width, size.height);
    const SampleTile tile{0, 0, size.width, size.height};
    drawn.clear(tile, Vec4f(0.0f));
    drawn.draw(camera, size, tile, {.light = &gl_light});
    Image<RgbaF> pixels{std::size_t(size.width), std::size_t(size.height)};
    gl.ReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_FLOAT, pixels.row(0).data());
    return pixels;
}

/// The point of the unit sphere that a pixel's middle sees, if it does not see it at a slant at
/// which OpenGL's triangles are another surface.
std::optional<Vec3d> point_seen(const Camera& camera, std::size_t x, std::size_t y) {
    const Ray ray = ray_through(camera, size, {double(x) + 0.5, double(y) + 0.5});
    const Vec3d along = glm::normalize(ray.direction);
    const double middle = -glm::dot(along, ray.origin);
    const double square = 1.0 - glm::dot(ray.origin, ray.origin) + middle * middle;
    if (square < 0.02) return {};
    return ray.origin + (middle - std::sqrt(square)) * along;
}

ShadedPoint point_of(const SceneMaterial& m) {
    ShadedPoint p;
    p.base = Vec3d(Vec3f(m.factor));
    p.metallic = double(m.metallic), p.roughness = double(m.roughness);
    p.emissive = Vec3d(m.emissive);
    p.ior = double(m.ior), p.specular = double(m.specular);
    p.clearcoat = double(m.clearcoat), p.clearcoat_roughness = double(m.clearcoat_roughness);
    p.sheen = Vec3d(m.sheen), p.sheen_roughness = double(m.sheen_roughness);
    p.transmission = double(m.transmission);
    return p;
}

struct NamedMaterial {
    const char* name;
    SceneMaterial material;
};

std::vector<NamedMaterial> materials() {
    std::vector<NamedMaterial> all;
    const auto add = [&](const char* name, const Vec3f& base, float metallic,
                         float roughness) -> SceneMaterial& {
        SceneMaterial material;
        material.factor = Vec4f(base, 1.0f);
        material.metallic = metallic, material.roughness = roughness;
        return all.emplace_back(NamedMaterial{name, material}).material;
    };
    add("plaster", {0.8f, 0.8f, 0.75f}, 0, 1.0f);
    add("plastic", {0.7f, 0.1f, 0.05f}, 0, 0.2f);
    add("mirror", {0.95f, 0.95f, 0.95f}, 1, 0.0f);
    add("gold", {1.0f, 0.77f, 0.34f}, 1, 0.3f);
    add("cast metal", {0.4f, 0.4f, 0.42f}, 1, 0.9f);
    add("half metal", {0.5f, 0.6f, 0.9f}, 0.5f, 0.5f);
    add("diamond", {0.9f, 0.9f, 0.9f}, 0, 0.05f).ior = 2.4f;
    add("matt", {0.2f, 0.5f, 0.3f}, 0, 0.4f).specular = 0.25f;
    add("ember", {0.1f, 0.1f, 0.1f}, 0, 0.7f).emissive = {2.0f, 0.4f, 0.1f};
    SceneMaterial& paint = add("car paint", {0.6f, 0.05f, 0.05f}, 0.6f, 0.6f);
    paint.clearcoat = 1.0f, paint.clearcoat_roughness = 0.1f;
    SceneMaterial& velvet = add("velvet", {0.3f, 0.02f, 0.1f}, 0, 0.9f);
    velvet.sheen = {0.9f, 0.5f, 0.6f}, velvet.sheen_roughness = 0.4f;
    add("glass", {0.9f, 0.7f, 0.4f}, 0, 0.1f).transmission = 0.9f;
    return all;
}

/// The mean square difference of what both show, in codes from 0 to 1, as decibels.
double psnr_of(const Image<RgbaF>& drawn, const SceneMaterial& material, const Camera& camera,
               const PrefilteredLight& light) {
    const LightOptions studio{.light = "studio"};
    const ShadedPoint point = point_of(material);
    double sum = 0.0, count = 0.0;
    for (std::size_t y = 0; y < drawn.height(); ++y)
        for (std::size_t x = 0; x < drawn.width(); ++x) {
            const auto seen = point_seen(camera, x, y);
            if (!seen) continue;
            const Vec3d want =
                ambient_shading(point, *seen, glm::normalize(camera.eye - *seen), light);
            const RgbaF& c = drawn(x, y);
            EXPECT_EQ(c.a, 1.0f);
            const Vec3d a = developed(want, studio),
                        b = developed({double(c.r), double(c.g), double(c.b)}, studio);
            for (int k = 0; k < 3; ++k) {
                const double difference = srgb_encode(a[k]) - srgb_encode(b[k]);
                sum += difference * difference, count += 1.0;
            }
        }
    EXPECT_GT(count, 3000.0);
    return -10.0 * std::log10(sum / count);
}

TEST_F(GlLightTest, BallsAreShadedAsOnTheHost) {
    for (const char* environment : {"studio", "sun"}) {
        const PrefilteredLight light = prefilter(make_environment(environment, 128), 32);
        EXPECT_EQ(light.sun.shines(), environment == std::string("sun"));
        for (const auto& [name, material] : materials()) {
            const Scene scene = ball(material);
            const Camera camera = orbit_camera({-30, 20, 3.5}, bounding_sphere(scene), size);
            const Image<RgbaF> drawn = drawn_light(*context, scene, camera, light);
            EXPECT_GE(psnr_of(drawn, material, camera, light), 45.0) << name << environment;
        }
    }
}

TEST_F(GlLightTest, NothingIsLostInAWhiteRoom) {
    const PrefilteredLight white = prefilter(white_environment(), 8);
    for (const float metallic : {0.0f, 1.0f})
        for (const float roughness : {0.0f, 0.1f, 0.3f, 0.5f, 0.7f, 0.9f, 1.0f}) {
            SceneMaterial material;
            material.metallic = metallic, material.roughness = roughness;
            const Scene scene = ball(material);
            const Camera camera = orbit_camera({}, bounding_sphere(scene), size);
            const Image<RgbaF> drawn = drawn_light(*context, scene, camera, white);
            std::size_t seen = 0;
            for (const RgbaF& c : drawn.pixels()) {
                if (c.a == 0.0f) continue;
                ++seen;
                for (const float x : {c.r, c.g, c.b})
                    ASSERT_NEAR(x, 1.0f, 0.01f) << metallic << " " << roughness;
            }
            EXPECT_GT(seen, 3000u);
        }
}

/// Every environment lights a ball by the diffuse light of its own.
TEST_F(GlLightTest, AllEnvironmentsDraw) {
    SceneMaterial plaster;
    plaster.roughness = 1.0f, plaster.specular = 0.0f;
    const Scene scene = ball(plaster);
    const Camera camera = orbit_camera({}, bounding_sphere(scene), size);
    for (const EnvironmentNote& note : environment_notes()) {
        const PrefilteredLight light = prefilter(make_environment(note.name, 32), 8);
        const Image<RgbaF> drawn = drawn_light(*context, scene, camera, light);
        const Vec3d want = diffuse_light(light, *point_seen(camera, 48, 48));
        const RgbaF& have = drawn(48, 48);
        EXPECT_NEAR(double(have.g), want.g, 0.01 * want.g) << note.name;
        EXPECT_GT(want.g, 0.05) << note.name;
    }
}

/// Both sides of a sheet are lit, each by the light on its own side.
TEST_F(GlLightTest, TheOtherSideHasItsOwnLight) {
    Scene scene;
    Surface& sheet = scene.surfaces.emplace_back();
    sheet.positions = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
    sheet.normals.assign(4, Vec3f(0, 1, 0));
    sheet.triangles = {{0, 2, 1}, {0, 3, 2}};
    sheet.material.roughness = 1.0f, sheet.material.specular = 0.0f;
    Environment sky{Image<RgbF>(64, 32)};
    for (std::size_t y = 0; y < 16; ++y)
        for (std::size_t x = 0; x < 64; ++x) sky.radiance(x, y) = {1.0f, 0.5f, 0.25f};
    const PrefilteredLight light = prefilter(sky, 8);
    const auto middle = [&](double elevation) {
        const Camera camera = orbit_camera({0, elevation, 3}, bounding_sphere(scene), size);
        return drawn_light(*context, scene, camera, light)(48, 48);
    };
    EXPECT_NEAR(middle(60).r, 1.0f, 0.03f);
    EXPECT_NEAR(middle(60).b, 0.25f, 0.03f);
    EXPECT_NEAR(middle(-60).r, 0.0f, 0.03f);
}

/// Pixels of a transparent picture, put over the background, are those of the opaque one.
TEST_F(GlLightTest, TransparentBackgroundsLeaveTheObjectAlone) {
    const Scene scene = ball({.factor = {0.25f, 0.5f, 0.75f, 1.0f}});
    const Camera camera = orbit_camera({}, bounding_sphere(scene), size);
    PictureOptions options{size, false, 3};
    const auto drawn = [&] {
        context->make_current();
        const GlScene uploaded(context->gl(), scene);
        const GlSurroundings around(context->gl(), scene, options);
        return render_picture(*context, uploaded, around, camera, options);
    };
    options.background = {Background::Kind::color, {10, 200, 90}};
    const Image<Rgba8> opaque = drawn();
    options.background = {Background::Kind::transparent, {}};
    const Image<Rgba8> clear = drawn();
    const SrgbEncoder<std::uint8_t> encode;
    const Rgba8 inside{encode(0.25), encode(0.5), encode(0.75), 255};
    EXPECT_EQ(clear(0, 0).a, 0);
    EXPECT_EQ(clear(48, 48), inside);
    EXPECT_EQ(opaque(0, 0), (Rgba8{10, 200, 90, 255}));
    std::size_t edge = 0;
    for (std::size_t y = 0; y < clear.height(); ++y)
        for (std::size_t x = 0; x < clear.width(); ++x) {
            const Rgba8& c = clear(x, y);
            if (c.a == 0) continue;
            EXPECT_EQ((Rgba8{c.r, c.g, c.b, 255}), inside);
            edge += c.a < 255;
            const double a = c.a / 255.0,
                         light = a * srgb_decode(c.r / 255.0) + (1 - a) * srgb_decode(10 / 255.0);
            EXPECT_NEAR(opaque(x, y).r, encode(light), 1);
        }
    EXPECT_GT(edge, 100u);
}

/// The environment behind the scene is the one that the eye's rays meet.
TEST_F(GlLightTest, TheEnvironmentIsSeenWhereItIs) {
    context->make_current();
    const Environment environment = make_environment("dusk", 64);
    const GlBackdrop backdrop(context->gl(), environment);
    const GlFramebuffer target(context->gl(), size.width, size.height);
    context->gl().Viewport(0, 0, size.width, size.height);
    for (const View& view : {View{0, 0, 2}, View{90, 30, 2}, View{200, -60, 2}, View{270, 0, 2}}) {
        const Camera camera = orbit_camera(view, {Vec3d(1, 2, 3), 5.0}, size);
        backdrop.draw(camera, size, {0, 0, size.width, size.height});
        Image<RgbaF> pixels{std::size_t(size.width), std::size_t(size.height)};
        context->gl().ReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_FLOAT,
                                 pixels.row(0).data());
        for (std::size_t y = 0; y < pixels.height(); y += 5)
            for (std::size_t x = 0; x < pixels.width(); x += 5) {
                const Ray ray = ray_through(camera, size, {double(x) + 0.5, double(y) + 0.5});
                const Vec3d want = light_from(environment, ray.direction);
                EXPECT_NEAR(double(pixels(x, y).r), want.r, 0.02 * want.r + 1e-3);
                EXPECT_NEAR(double(pixels(x, y).b), want.b, 0.02 * want.b + 1e-3);
            }
    }
}

}  // namespace
}  // namespace burl
