// Normal maps of whole bakes: every texel in the frame that a viewer has there.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "app/bake/texture.h"
#include "app/export/vertices.h"
#include "app/measure/normal_error.h"
#include "app/pipeline/texture_color.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/surface/tangents.h"
#include "atlas/base/error.h"
#include "procedural/fill/normals.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

double degrees_between(const Vec3d& a, const Vec3d& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

Recipe bumpy(AtlasKind kind, std::uint32_t size, const char* input, double height = 0.02) {
    Recipe recipe = parse_recipe(
        fmt::format(R"({{"bump": {{"height": {}, "input": {}}}}})", height, input), "r");
    recipe.atlas.kind = kind;
    recipe.atlas.size = size;
    return recipe;
}

constexpr const char* wave = R"({"node": "sin", "input":
    {"node": "coordinate", "direction": [24, 0, 0]}})";
constexpr const char* hills = R"({"node": "fbm", "octaves": 2})";
constexpr std::array kinds{AtlasKind::uniform, AtlasKind::area, AtlasKind::length, AtlasKind::quad,
                           AtlasKind::patch};

Mesh moved(Mesh mesh, const Mat3d& linear, const Vec3d& offset) {
    for (Vec3d& p : mesh.positions) p = linear * p + offset;
    return mesh;
}

struct TexelPoint {
    std::size_t x, y;
    SurfacePoint point;
};

/// Texels whose centre lies inside a triangle's place; the rest are gutters, overscan or nothing.
std::vector<TexelPoint> texel_points(Pipeline& pipeline) {
    std::vector<TexelPoint> points;
    const Atlas& atlas = pipeline.atlas();
    for (std::uint32_t t = 0; t < atlas.corners.size(); ++t) {
        const auto& c = atlas.corners[t];
        const Vec2d u = c[1] - c[0], v = c[2] - c[0];
        const double area = u.x * v.y - u.y * v.x;
        const Vec2d low = glm::min(glm::min(c[0], c[1]), c[2]);
        const Vec2d high = glm::max(glm::max(c[0], c[1]), c[2]);
        for (double y = std::floor(low.y); y < high.y && area != 0.0; ++y)
            for (double x = std::floor(low.x); x < high.x; ++x) {
                const Vec2d p = Vec2d(x + 0.5, y + 0.5) - c[0];
                const double to_b = (p.x * v.y - p.y * v.x) / area;
                const double to_c = (u.x * p.y - u.y * p.x) / area;
                // A centre on an edge may be the neighbour's, in whose frame it looks the same.
                if (to_b > 1e-6 && to_c > 1e-6 && to_b + to_c < 1.0 - 1e-6)
                    points.push_back(
                        {std::size_t(x), std::size_t(y), {t, {1.0 - to_b - to_c, to_b, to_c}}});
            }
    }
    return points;
}

/// A flat sheet of 3 x 3 squares, one planar patch, whose normals are those of a sphere: no
/// triangle's frame fits another's.
Mesh domed_sheet() {
    Mesh mesh;
    for (std::uint32_t y = 0; y < 4; ++y)
        for (std::uint32_t x = 0; x < 4; ++x)
            mesh.positions.push_back({x / 3.0 - 0.5, y / 3.0 - 0.5, 0.3});
    for (std::uint32_t y = 0; y < 3; ++y)
        for (std::uint32_t x = 0; x < 3; ++x) {
            const std::uint32_t a = 4 * y + x;
            mesh.triangles.push_back({a, a + 1, a + 5});
            mesh.triangles.push_back({a, a + 5, a + 4});
        }
    add_whole_part(mesh);
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t)
            mesh.corners.normals.push_back(Vec3f(glm::normalize(mesh.positions[p])));
    return mesh;
}

/// Largest difference, in degrees, between what a viewer makes of a texel at its own place and the
/// bumped normal there.
double worst_texel(Pipeline& pipeline, int& mirrored) {
    const Image<Vec3f> map = components(pipeline.normal_map<RgbF>(40.0, true));
    const ViewerFrames frames = ViewerFrames::of(pipeline, 40.0);
    const SurfaceNormal exact = bumped_normals(pipeline.recipe(), pipeline.mesh());
    double worst = 0.0;
    for (const TexelPoint& texel : texel_points(pipeline)) {
        const Vec3d wanted = exact(position(frames.mesh, texel.point), frames.normal(texel.point));
        const Vec3d seen = from_frame(frames.frame(texel.point), Vec3d(map(texel.x, texel.y)));
        worst = std::max(worst, degrees_between(wanted, seen));
        mirrored += frames.tangents[3 * std::size_t(texel.point.triangle)].w < 0.0f;
    }
    return worst;
}

TEST(NormalMap, EveryTexelIsTheBumpedNormalInTheViewersFrame) {
    const Mat3d turn(glm::rotate(Mat4d(1.0), 0.7, Vec3d(1, 2, 3)));
    const Mat3d mirror(-30, 0, 0, 0, 50, 0, 0, 0, 20);
    int mirrored = 0;
    for (const AtlasKind kind : kinds) {
        Mesh turned_out = moved(sphere_mesh(8, 16), mirror * turn, {1e4, -2e4, 3e3});
        for (Triangle& t : turned_out.triangles) std::swap(t[1], t[2]);
        for (const Mesh& mesh : {sphere_mesh(8, 16), cube_mesh(), turned_out, domed_sheet()}) {
            Pipeline pipeline(mesh);
            pipeline.set_recipe(bumpy(kind, 128, wave));
            EXPECT_LT(worst_texel(pipeline, mirrored), 1e-4) << to_string(kind);
        }
    }
    EXPECT_GT(mirrored, 1000) << "no chart was mirrored, so nothing was tested about them";
}

TEST(NormalMap, PlaneRaisedBySineHasItsNormals) {
    // In object space: (-0.48 cos(24 x), 0, 1), normalised; the square's longest side is 1.
    Mesh mesh;
    mesh.positions = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    add_whole_part(mesh);
    for (const AtlasKind kind : kinds) {
        Pipeline pipeline(mesh);
        pipeline.set_recipe(bumpy(kind, 64, wave));
        const Image<RgbF> map = pipeline.normal_map<RgbF>(40.0, false);
        const auto points = texel_points(pipeline);
        EXPECT_GT(points.size(), 500u);
        for (const TexelPoint& texel : points) {
            const double x = position(pipeline.atlas_mesh(), texel.point).x;
            const Vec3d exact = glm::normalize(Vec3d(-0.48 * std::cos(24.0 * x), 0.0, 1.0));
            const RgbF& n = map(texel.x, texel.y);
            EXPECT_LT(glm::length(Vec3d(n.r, n.g, n.b) - exact), 1e-6);
        }
    }
}

TEST(NormalMap, FlatHeightsAreFlatInEveryTexel) {
    const char* constant = R"({"node": "constant", "value": 3})";
    for (const AtlasKind kind : kinds) {
        for (const FilterKind filter : {FilterKind::none, FilterKind::supersample}) {
            Pipeline pipeline(sphere_mesh(6, 12));
            Recipe recipe = bumpy(kind, 64, constant);
            recipe.filter = {filter, 4, false};
            pipeline.set_recipe(recipe);
            const Image<Rgb8> map = pipeline.normal_map<Rgb8>(40.0, true);
            for (const Rgb8& texel : map.pixels()) EXPECT_EQ(texel, (Rgb8{128, 128, 255}));
        }
    }
}

NormalErrors coded_errors(Pipeline& pipeline, NormalSpace space, int depth) {
    const NormalMap map = *bake_normals(pipeline, space, depth, 40.0);
    return normal_errors(pipeline, ViewerFrames::of(pipeline, 40.0), components(map),
                         map.tangent_space, 4000);
}

TEST(NormalMap, LookupsBetweenTexelsStayClose) {
    // Bilinear lookups of 256 x 256 texels between and across triangles.
    for (const AtlasKind kind : kinds) {
        Pipeline pipeline(sphere_mesh(16, 32));
        pipeline.set_recipe(bumpy(kind, 256, wave));
        const NormalErrors exact =
            normal_errors(pipeline, ViewerFrames::of(pipeline, 40.0),
                          components(pipeline.normal_map<RgbF>(40.0, true)), true, 4000);
        EXPECT_GT(exact.mean_tilt, 10.0);
        EXPECT_LT(exact.mean, 0.3) << to_string(kind);
        EXPECT_LT(exact.percentile99, 2.0) << to_string(kind);
        const NormalErrors bits8 = coded_errors(pipeline, NormalSpace::tangent, 8);
        const NormalErrors bits16 = coded_errors(pipeline, NormalSpace::tangent, 16);
        const NormalErrors object = coded_errors(pipeline, NormalSpace::object, 8);
        EXPECT_LT(bits8.mean, exact.mean + 0.35) << to_string(kind);
        EXPECT_LT(bits16.mean, exact.mean + 0.005) << to_string(kind);
        EXPECT_LT(object.mean, bits8.mean + 0.5) << to_string(kind);
    }
}

TEST(NormalMap, SharedTangentsBeatThoseOfEachTriangle) {
    // A frame that jumps at an edge makes lookups beside it mix normals of two frames, and splits
    // every vertex.
    Pipeline pipeline(sphere_mesh(16, 32));
    pipeline.set_recipe(bumpy(AtlasKind::patch, 256, wave));
    const ViewerFrames shared = ViewerFrames::of(pipeline, 40.0);
    ViewerFrames split = shared;
    const Mesh& mesh = shared.mesh;
    const std::vector<Vec2d> uvs = corner_uvs(pipeline.atlas());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        std::ranges::copy(corner_tangents(mesh.positions, std::span(mesh.triangles).subspan(t, 1),
                                          std::span(uvs).subspan(3 * t, 3),
                                          std::span(shared.normals).subspan(3 * t, 3)),
                          split.tangents.begin() + std::ptrdiff_t(3 * t));
    const auto error_of = [&](const ViewerFrames& frames) {
        const Recipe& recipe = pipeline.recipe();
        const std::vector<Vec3d> positions =
            map_positions(mesh, solid_from_mesh(pipeline.mesh(), recipe.solid.space));
        const Image<RgbF> map = synthesize_normals<RgbF>(
            pipeline.solid(), {mesh, pipeline.atlas(), positions, frames.normals, frames.tangents},
            recipe.bump, texture_from_solid(recipe), recipe.filter, 0);
        return normal_errors(pipeline, frames, components(map), true, 20000);
    };
    const NormalErrors of_shared = error_of(shared), of_split = error_of(split);
    EXPECT_LT(of_shared.mean, of_split.mean);
    EXPECT_LT(of_shared.percentile99, of_split.percentile99);
    RecordProperty("shared_mean", fmt::format("{:.4f}", of_shared.mean));
    RecordProperty("split_mean", fmt::format("{:.4f}", of_split.mean));
    RecordProperty("shared_99", fmt::format("{:.4f}", of_shared.percentile99));
    RecordProperty("split_99", fmt::format("{:.4f}", of_split.percentile99));
}

TEST(NormalMap, BytesDoNotDependOnThreads) {
    Pipeline one(sphere_mesh(8, 16)), all(sphere_mesh(8, 16));
    for (Pipeline* pipeline : {&one, &all})
        pipeline->set_recipe(bumpy(AtlasKind::patch, 128, hills));
    one.set_threads(1);
    EXPECT_EQ(one.normal_map<Rgb16>(40.0, true), all.normal_map<Rgb16>(40.0, true));
}

TEST(NormalMap, SupersamplesAreMeansOfNormals) {
    // Waves much finer than texels: one sample a texel is anywhere, their mean is nearly flat.
    const char* fine = R"({"node": "sin", "input":
        {"node": "coordinate", "direction": [3000, 1000, 2000]}})";
    double tilt[2] = {0.0, 0.0};
    for (const int samples : {1, 64}) {
        Pipeline pipeline(sphere_mesh(8, 16));
        Recipe recipe = bumpy(AtlasKind::patch, 64, fine, 2e-4);
        if (samples > 1) recipe.filter = {FilterKind::supersample, samples, false};
        pipeline.set_recipe(recipe);
        const Image<RgbF> map = pipeline.normal_map<RgbF>(40.0, true);
        for (const RgbF& n : map.pixels())
            tilt[samples > 1] +=
                degrees_between({n.r, n.g, n.b}, {0, 0, 1}) / double(map.pixels().size());
    }
    EXPECT_GT(tilt[0], 15.0);
    EXPECT_LT(tilt[1], 0.3 * tilt[0]);
}

TEST(NormalsAsked, AreRefusedWithOneSentence) {
    const Recipe plain = parse_recipe("{}", "r"), bumps = bumpy(AtlasKind::patch, 64, wave);
    EXPECT_EQ(normals_asked("", plain, "a.glb"), NormalSpace::none);
    EXPECT_EQ(normals_asked("", bumps, "a.glb"), NormalSpace::tangent);
    EXPECT_EQ(normals_asked("none", bumps, "a.glb"), NormalSpace::none);
    EXPECT_EQ(normals_asked("object", bumps, "a.png"), NormalSpace::object);
    for (const auto& [text, recipe, out] : {std::tuple{"tangent", plain, "a.glb"},
                                            {"object", plain, "a.png"},
                                            {"object", bumps, "a.glb"},
                                            {"object", bumps, "a.gltf"}}) {
        try {
            normals_asked(text, recipe, out);
            ADD_FAILURE() << text << " " << out;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage);
        }
    }
}

}  // namespace
}  // namespace burl
