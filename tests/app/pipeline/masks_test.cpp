// Masks of the shape in whole bakes: a texel of the picture is the mask of atlas/shape at the
// texel's point, in the graph's units.
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/pipeline/mask_picture.h"
#include "app/pipeline/pipeline.h"
#include "atlas/shape/crease_edges.h"
#include "atlas/shape/curvature.h"
#include "atlas/shape/light.h"
#include "atlas/shape/occlusion.h"
#include "atlas/shape/point_masks.h"
#include "atlas/shape/texel_mask.h"
#include "atlas/shape/thickness.h"
#include "tests/app/pipeline/mask_cases.h"

namespace burl {
namespace {

using Points = std::span<const ShapePoint>;
using Values = std::span<float>;

/// Calls visit(value, point) for every seventh texel that shows something: its number in the
/// picture, and its point of the mesh in the file's units.
template <class Visit>
void for_points(Pipeline& pipeline, const Visit& visit) {
    const Image<RgbF> picture = pipeline.synthesize<RgbF>();
    const SolidAtlas& solid = pipeline.solid();
    const Affine3 map = solid_from_mesh(pipeline.mesh(), pipeline.recipe().solid.space);
    const ShapeScene scene(pipeline.atlas_mesh());
    const TexelOwners owners(solid, pipeline.atlas(), OwnerReach::gutters);
    std::size_t texel = 0;
    for (std::uint32_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                if (++texel % 7 != 0) continue;
                const Vec3d p = (solid.maps[span.map](x, y) - map.offset) / map.linear[0][0];
                const std::uint32_t shows = solid.triangle_of(span.map);
                const Vec3d there = scene.weights_at(shows, p);
                const bool inside = std::min({there.x, there.y, there.z}) >= 0.0;
                const std::uint32_t t = inside ? shows : owners(x, y, span.map);
                visit(picture(x, y).g, scene.surface_point(t, scene.weights_at(t, p)));
            }
    EXPECT_GT(texel, solid.size * solid.size / 3);
}

/// The root mean square of the texels' errors against a mask times `factor`.
double error_of(Pipeline& pipeline, const PointMask& mask, double factor = 1.0) {
    std::vector<ShapePoint> points;
    std::vector<float> found;
    for_points(pipeline, [&](float value, const ShapePoint& point) {
        found.push_back(value);
        points.push_back(point);
    });
    std::vector<float> truth(points.size());
    mask(points, truth);
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        sum += std::pow(double(found[i]) - factor * double(truth[i]), 2);
    return std::sqrt(sum / double(truth.size()));
}

/// A node of light in which one of its colours is white and the others are black.
std::string light_of(const std::string& white, const std::string& more) {
    std::string text = R"({"node": "lighting")";
    for (const char* color : {"sky", "ground", "sun"})
        text += fmt::format(R"(, "{}": "{}")", color, color == white ? "#ffffff" : "#000000");
    return text + more + "}";
}

TEST(MeshMasks, ATexelHasTheMaskAtItsPointInTheGraphsUnits) {
    for (const char* kind : {"quad", "patch"})
        for (const char* space : {"unit", "object"}) {
            SCOPED_TRACE(fmt::format("{} {}", kind, space));
            Pipeline pipeline(ring_and_plate());
            const double side = bounding_box(pipeline.mesh()).longest_side();
            const double unit = 4.0 * (space == std::string("unit") ? 1.0 / side : 1.0);
            const auto with = [&](const std::string& texture) {
                pipeline.set_recipe(mask_recipe(
                    texture, {fmt::format("atlas.kind={}", kind), "solid.scale=4",
                              fmt::format("solid.space={}", space), "solid.rotate=[30,0,70]"}));
            };
            with(R"({"node": "facing", "direction": [0, 3, 4]})");
            EXPECT_LT(error_of(pipeline,
                               [](Points p, Values v) {
                                   facing(p, {0, 0.6, 0.8}, v);
                               }),
                      1e-6);
            with(R"({"node": "height_in_box", "axis": "x"})");
            const Box3 box = bounding_box(pipeline.mesh());
            EXPECT_LT(error_of(pipeline, [&](Points p, Values v) { height_in_box(p, box, 0, v); }),
                      1e-5);
            const ShapeScene scene(pipeline.atlas_mesh());
            with(R"({"node": "edge_distance", "angle": 60, "farthest": 0.75})");
            const CreaseEdges edges(scene, std::numbers::pi / 3.0);
            ASSERT_GT(edges.count(), 0u);
            EXPECT_LT(
                error_of(
                    pipeline,
                    [&](Points p, Values v) { edge_distance(scene, edges, p, 0.75 / unit, v); },
                    unit),
                1e-5);
            with(R"({"node": "curvature", "radius": 0.5})");
            const CurvatureTree tree(scene);
            EXPECT_LT(
                error_of(pipeline, [&](Points p, Values v) { curvature(tree, p, 0.5 / unit, v); }),
                0.015);
            with(R"({"node": "occlusion", "distance": 0.75})");
            EXPECT_LT(error_of(pipeline,
                               [&](Points p, Values v) {
                                   occlusion(scene, p, {1024, 0.75 / unit}, v);
                               }),
                      0.02);
            with(light_of("ground", R"(, "distance": 0.75, "crease": 0)"));
            EXPECT_LT(
                error_of(pipeline,
                         [&](Points p, Values v) {
                             sky_light(scene, p, {0, 1, 0}, SkyHalf::lower, {1024, 0.75 / unit}, v);
                         }),
                0.02);
            with(light_of("sun", R"(, "angle": 3, "crease": 0)"));
            const SunOptions sun{glm::normalize(Vec3d(0.4, 0.8, 0.6)), std::numbers::pi / 60.0};
            EXPECT_LT(error_of(
                          pipeline, [&](Points p, Values v) { sun_light(scene, p, sun, v); }, 0.8),
                      0.02);
            with(R"({"node": "thickness", "distance": 2})");
            EXPECT_LT(error_of(
                          pipeline,
                          [&](Points p, Values v) {
                              thickness(scene, p, {1024, 2.0 / unit}, v);
                          },
                          unit),
                      0.06);
        }
}

TEST(MeshMasks, OnASphereAreKnown) {
    Pipeline pipeline(sphere_mesh(96, 192));  // of radius 1, so 1.5 in the graph
    const auto expect_all = [&](const std::string& texture, double value, double tolerance) {
        pipeline.set_recipe(mask_recipe(texture, {"solid.scale=3"}));
        for_points(pipeline, [&](float found, const ShapePoint&) {
            ASSERT_NEAR(found, value, tolerance) << texture;
        });
    };
    expect_all(R"({"node": "curvature", "radius": 0.3})", 0.2, 0.01);
    expect_all(R"({"node": "curvature", "radius": 0.3, "gives": "convex"})", 0.2, 0.01);
    expect_all(R"({"node": "curvature", "radius": 0.3, "gives": "concave"})", 0.0, 0.0);
    expect_all(R"({"node": "occlusion"})", 1.0, 0.01);
    expect_all(R"({"node": "thickness", "rays": 512})", 2.0, 0.04);
}

TEST(MeshMasks, AttributesOfTheFileAreInterpolated) {
    Pipeline pipeline(drawn_sheet());
    pipeline.set_recipe(mask_recipe(R"({"node": "vertex_color"})"));
    for_points(pipeline, [](float green, const ShapePoint& at) {
        ASSERT_NEAR(green, 0.25 * at.position.y, 1e-5);
    });
    pipeline.set_recipe(mask_recipe(R"({"node": "vertex_color", "alpha": "file"})"));
    for_points(pipeline, [](float green, const ShapePoint& at) {
        ASSERT_NEAR(green, 0.125 * at.position.y, 1e-5);
    });
    // A turn and a move of the solid do not matter.
    pipeline.set_recipe(mask_recipe(R"({"node": "transform", "translate": [5, 6, 7], "input":
        {"node": "mesh_uv", "input": {"node": "coordinate", "direction": [1, 10, 100]}}})",
                                    {"solid.scale=9", "solid.rotate=[10,20,30]"}));
    for_points(pipeline, [](float value, const ShapePoint& at) {
        ASSERT_NEAR(value, 3.0 * at.position.x + 1.0 + 20.0 * at.position.y, 1e-4);
    });
}

TEST(MeshMasks, OnAFlatPatchOfManyTrianglesAreThoseOfEachTriangle) {
    // 6 x 6 squares with colours that are linear in the points, so any other triangle would show.
    Mesh mesh;
    for (std::uint32_t y = 0; y <= 6; ++y)
        for (std::uint32_t x = 0; x <= 6; ++x) mesh.positions.push_back({x, y, 0});
    for (std::uint32_t y = 0; y < 6; ++y)
        for (std::uint32_t x = 0; x < 6; ++x) {
            const std::uint32_t a = 7 * y + x;
            mesh.triangles.push_back({a, a + 1, a + 8});
            mesh.triangles.push_back({a, a + 8, a + 7});
        }
    add_whole_part(mesh);
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            mesh.corners.colors.push_back(
                {0.0, (mesh.positions[corner].x + 3.0 * mesh.positions[corner].y) / 24.0, 0.0, 1});
    for (const char* kind : {"patch", "quad"}) {
        Pipeline pipeline(mesh);
        pipeline.set_recipe(
            mask_recipe(R"({"node": "vertex_color"})",
                        {fmt::format("atlas.kind={}", kind), "solid.space=object"}));
        const Image<RgbF> picture = pipeline.synthesize<RgbF>();
        const SolidAtlas& solid = pipeline.solid();
        std::size_t texels = 0, exact = 0;
        for (std::uint32_t y = 0; y < solid.size; ++y)
            for (const Span& span : solid.row(y))
                for (std::uint32_t x = span.x; x < span.x + span.count; ++x, ++texels) {
                    const Vec3d p = solid.maps[span.map](x, y);
                    const double truth = (p.x + 3.0 * p.y) / 24.0;
                    exact += std::abs(double(picture(x, y).g) - truth) < 1e-4;
                }
        // Gutters show the sides of their charts.
        EXPECT_GT(double(exact), 0.8 * double(texels)) << kind;
    }
}

TEST(MeshMasks, WithoutAttributesAreWhiteAndNought) {
    Pipeline pipeline(cube_mesh());
    pipeline.set_recipe(mask_recipe(R"({"node": "vertex_color"})"));
    for_points(pipeline, [](float green, const ShapePoint&) { ASSERT_EQ(green, 1.0f); });
    pipeline.set_recipe(
        mask_recipe(R"({"node": "mesh_uv", "input": {"node": "coordinate", "offset": 0.25}})"));
    for_points(pipeline, [](float value, const ShapePoint&) { ASSERT_EQ(value, 0.25f); });
}

TEST(MeshMasks, TextureCoordinatesThatAreNoNumbersAreNought) {
    Mesh mesh = drawn_sheet();
    for (Vec2d& uv : mesh.corners.uvs) uv = {std::nan(""), 1e300};
    Pipeline pipeline(std::move(mesh));
    pipeline.set_recipe(mask_recipe(
        R"({"node": "mesh_uv", "input": {"node": "coordinate", "direction": [1, 1, 0]}})"));
    for_points(pipeline, [](float value, const ShapePoint&) { ASSERT_EQ(value, 65536.0f); });
}

TEST(MeshMasks, PiecesHaveNumbersOfTheirOwn) {
    Pipeline pipeline(ring_and_plate());
    std::set<float> seen;
    pipeline.set_recipe(mask_recipe(R"({"node": "part", "seed": 4})"));
    for_points(pipeline, [&](float value, const ShapePoint&) { seen.insert(value); });
    EXPECT_EQ(seen.size(), 2u);
    const float first = *seen.begin();
    EXPECT_TRUE(first >= 0.0f && *seen.rbegin() < 1.0f);
    seen.clear();
    pipeline.set_recipe(mask_recipe(R"({"node": "part", "seed": 4, "piece": "part"})"));
    for_points(pipeline, [&](float value, const ShapePoint&) { seen.insert(value); });
    EXPECT_EQ(seen.size(), 1u);
}

TEST(MeshMasks, LightOnASphereIsKnownInTheMeshsAxes) {
    Pipeline pipeline(sphere_mesh(48, 96));
    const Vec3d axis(0.6, 0.0, 0.8);
    const auto expect_all = [&](const std::string& texture, double tolerance, const auto& truth) {
        pipeline.set_recipe(mask_recipe(texture, {"solid.scale=3", "solid.rotate=[40,50,60]"}));
        for_points(pipeline, [&](float found, const ShapePoint& point) {
            ASSERT_NEAR(found, truth(glm::dot(point.normal, axis)), tolerance) << texture;
        });
    };
    const char* const up = R"(, "up": [3, 0, 4], "rays": 512, "crease": 0)";
    expect_all(light_of("sky", up), 0.04, [](double c) { return (1.0 + c) / 2.0; });
    expect_all(light_of("ground", up), 0.04, [](double c) { return (1.0 - c) / 2.0; });
    expect_all(
        light_of("sun", R"(, "direction": [3, 0, 4], "angle": 0, "crease": 0, "sun_strength": 2)"),
        1e-5, [](double c) { return 2.0 * std::max(c, 0.0); });
}

TEST(MeshMasks, LightIsSmoothOverEdgesThatAreNoCreases) {
    Pipeline pipeline(sphere_mesh(32, 64));
    const Vec3d axis(0.6, 0.0, 0.8);
    const auto largest_error = [&](const std::string& crease) {
        pipeline.set_recipe(mask_recipe(light_of(
            "sun",
            R"(, "direction": [3, 0, 4], "angle": 0, "sun_strength": 1, "crease": )" + crease)));
        double largest = 0.0;
        for_points(pipeline, [&](float found, const ShapePoint& point) {
            const double cosine = glm::dot(glm::normalize(point.position), axis);
            if (std::abs(cosine) < 0.2) return;  // where triangles begin to face away
            largest = std::max(largest, std::abs(double(found) - std::max(cosine, 0.0)));
        });
        return largest;
    };
    EXPECT_LT(largest_error("40"), 0.02);
    EXPECT_GT(largest_error("0"), 0.04);
}

TEST(MeshMasks, SkyAndSunAreKeptApart) {
    Pipeline pipeline(ring_and_plate());
    const auto runs_with = [&](const std::string& more) {
        pipeline.set_recipe(mask_recipe(light_of("sun", more)));
        static_cast<void>(pipeline.synthesize<Rgb8>());
        return pipeline.records()[Stage::masks].runs;
    };
    EXPECT_EQ(runs_with(R"(, "rays": 16)"), 3u);
    EXPECT_EQ(runs_with(R"(, "rays": 16, "sun_strength": 2, "sky_strength": 0.5)"), 3u);
    EXPECT_EQ(runs_with(R"(, "rays": 16, "angle": 5)"), 4u);
    EXPECT_EQ(runs_with(R"(, "rays": 16, "angle": 5, "direction": [1, 0, 0])"), 5u);
    EXPECT_EQ(runs_with(R"(, "rays": 17, "angle": 5, "direction": [1, 0, 0])"), 7u);
    EXPECT_EQ(runs_with(R"(, "rays": 17, "angle": 5, "direction": [1, 0, 0], "up": [0, 0, 1])"),
              9u);
}

TEST(MeshMasks, LightMultipliesColours) {
    Pipeline pipeline(ring_and_plate());
    const auto picture = [&](const std::string& texture) {
        pipeline.set_recipe(mask_recipe(texture));
        return pipeline.synthesize<RgbF>();
    };
    const auto light = picture(R"({"node": "lighting", "rays": 16})");
    const auto both = picture(R"({"node": "scale", "a": {"node": "lighting", "rays": 16},
        "b": {"node": "transform", "scale": [6, 6, 6],
              "input": {"node": "checkerboard", "a": "#ffffff", "b": "#000000"}}})");
    std::size_t kept = 0, dark = 0;
    for (std::size_t i = 0; i < light.pixels().size(); ++i) {
        if (light.pixels()[i].g == 0.0f) continue;
        kept += both.pixels()[i] == light.pixels()[i];
        dark += both.pixels()[i] == RgbF{};
    }
    EXPECT_GT(std::min(kept, dark), 1000u);
}

TEST(MaskPictures, OfLightAreTheNodesColours) {
    Pipeline pipeline(ring_and_plate());
    pipeline.set_recipe(mask_recipe(R"({"node": "lighting"})"));
    const Image<Rgb8> codes = pipeline.synthesize<Rgb8>();
    EXPECT_EQ(light_picture<Rgb16>(pipeline), pipeline.synthesize<Rgb16>());
    pipeline.set_recipe(mask_recipe(R"({"node": "fbm"})"));
    EXPECT_EQ(light_picture<Rgb8>(pipeline), codes);
    std::set<std::uint8_t> reds;
    for (const Rgb8& pixel : codes.pixels()) reds.insert(pixel.r);
    EXPECT_GT(reds.size(), 100u);  // shaded, not flat
}

TEST(MaskPictures, HoldTheNodesNumbersAsCodes) {
    struct Case {
        std::string name;
        double factor, offset;
    };
    const double diagonal = 2.0 * std::sqrt(3.0);  // of the cube, at scale 2 and side 1
    for (const auto& [name, factor, offset] :
         {Case{"occlusion", 1.0, 0.0}, Case{"curvature", 0.5, 0.5}, Case{"facing", 0.5, 0.5},
          Case{"height_in_box", 1.0, 0.0}, Case{"thickness", 1.0 / diagonal, 0.0},
          Case{"edge_distance", 1.0 / diagonal, 0.0}, Case{"part", 1.0, 0.0}}) {
        Pipeline pipeline(cube_mesh());
        pipeline.set_recipe(
            mask_recipe(fmt::format(R"({{"node": "{}"}})", name), {"solid.scale=2"}));
        const Image<RgbF> values = pipeline.synthesize<RgbF>();
        const Image<Grey8> codes = mask_picture<Grey8>(pipeline, name);
        const Image<Grey16> fine = mask_picture<Grey16>(pipeline, name);
        for (std::size_t y = 0; y < codes.height(); ++y)
            for (std::size_t x = 0; x < codes.width(); ++x) {
                const double value = factor * double(values(x, y).r) + offset;
                ASSERT_NEAR(codes(x, y), 255.0 * value, 0.51) << name;
                ASSERT_NEAR(fine(x, y), 65535.0 * value, 0.6) << name;
            }
        EXPECT_EQ(pipeline.records()[Stage::masks].runs, 1u) << name;
    }
    EXPECT_EQ(mask_picture_names().size(), 8u);
}

}  // namespace
}  // namespace burl
