// The benchmark's meshes are what they say, and the atlas suite measures what other code measures.
#include "app/bench/atlas.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/bench/levels.h"
#include "app/bench/meshes.h"
#include "app/bench/precision.h"
#include "atlas/measure/atlas_measures.h"

namespace burl {
namespace {

TEST(BenchMeshes, AreClosedAndRunOneWayRound) {
    for (const std::size_t faces : {12u, 300u, 5000u}) {
        const Mesh sphere = bumpy_sphere(faces), ring = torus(faces);
        for (const Mesh& mesh : {sphere, ring}) {
            const Connectivity edges = build_connectivity(mesh);
            EXPECT_EQ(edges.boundary_edges, 0u) << mesh.name;
            EXPECT_EQ(edges.split_faces, 0u) << mesh.name;
            EXPECT_EQ(edges.shells, 1u) << mesh.name;
            const auto euler = std::int64_t(mesh.positions.size() + mesh.triangles.size()) -
                               std::int64_t(edges.interior_edges);
            EXPECT_EQ(euler, mesh.name == "torus" ? 0 : 2);
            EXPECT_EQ(mesh.parts.at(0).triangle_count, mesh.triangles.size());
        }
        EXPECT_NEAR(double(sphere.triangles.size()) / double(faces), 1.0, 0.25);
        double volume = 0.0;
        for (const auto& [a, b, c] : sphere.triangles)
            volume += glm::dot(sphere.positions[a],
                               glm::cross(sphere.positions[b], sphere.positions[c])) /
                      6.0;
        EXPECT_GT(volume, 0.2) << "normals point outwards";
        EXPECT_LT(volume, 1.5);
    }
}

TEST(BenchAtlases, TextureHoldsTwentyFiveToAHundredTexelsAPair) {
    EXPECT_EQ(bench_texture(1'000'000), 4096u);
    for (const std::size_t faces : {10u, 1000u, 31415u, 2'000'000u}) {
        const double texels = std::pow(double(bench_texture(faces)), 2) / (0.5 * double(faces));
        EXPECT_GE(texels, 25.0);
        EXPECT_LT(texels, 105.0);
    }
}

TEST(BenchAtlases, AllKindsSideBySide) {
    const std::vector<AtlasBench> rows = bench_atlases(std::vector<std::size_t>{300, 700}, 1, 500);
    ASSERT_EQ(rows.size(), 12u);
    const std::vector<std::string> kinds{"uniform", "area", "length", "quad", "patch", "chart"};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const AtlasBench& row = rows[i];
        EXPECT_EQ(row.kind, kinds[i % 6]);
        EXPECT_EQ(row.faces, i < 6 ? 300u : 768u);
        for (const char* name : {"connectivity", "layout", "spans"}) {
            EXPECT_GT(row.stage(name).one_thread, 0.0);
            EXPECT_GT(row.stage(name).all_threads, 0.0);
        }
        EXPECT_EQ(row.stages.size(), row.kind == "quad" ? 5u : 3u);
        ASSERT_EQ(row.rmse.size(), 3u);
        // A level shows less than the texture itself, and more than its mean alone (.35).
        for (const double rmse : row.rmse) {
            EXPECT_GT(rmse, 1e-4);
            EXPECT_LT(rmse, 0.3);
        }
        EXPECT_GT(row.psnr, -20.0 * std::log10(row.rmse[2]));
        ASSERT_EQ(row.views.size(), 25u);
        EXPECT_LT(row.views[0].rmse[0], row.views[24].rmse[0]);
    }
    const Mesh mesh = bumpy_sphere(300);
    const Atlas quad = layout_atlas(mesh, build_connectivity(mesh),
                                    {AtlasKind::quad, Overscan::bilinear, rows[3].size});
    EXPECT_EQ(rows[3].coverage,
              measure(mesh, quad, rasterize(mesh, quad, mesh.positions)).coverage);
}

TEST(BenchPrecision, HalvesTheErrorWithEveryBit) {
    const std::vector<PrecisionBench> rows = bench_precision(1, 64);
    ASSERT_EQ(rows.size(), 28u);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const PrecisionBench& row = rows[i];
        EXPECT_EQ(row.texture, i < 14 ? "wood" : "marble");
        EXPECT_GT(row.time.ns_per_unit(), 0.0);
        EXPECT_EQ(row.time.name, row.precision);
        EXPECT_EQ(row.time.group, row.texture);
        if (row.precision == "float64") {
            EXPECT_EQ(row.max_error, 0.0);
        } else if (row.precision == "float32") {
            EXPECT_LT(row.max_error, 2e-6);
            EXPECT_GT(row.max_error, 1e-9);
        } else {
            EXPECT_LE(row.rms_error, row.max_error);
            EXPECT_LT(row.coordinate_rms_error, row.rms_error) << row.precision;
        }
        if (row.precision == "fixed:8.12") {  // after 16 and 14
            EXPECT_NEAR(rows[i].rms_error / rows[i - 2].rms_error, 16.0, 1.6);
            EXPECT_NEAR(rows[i].coordinate_rms_error / rows[i - 2].coordinate_rms_error, 16.0, 1.6);
            EXPECT_NEAR(rows[i - 2].psnr - rows[i].psnr, 12.0, 4.0);
        }
    }
}

// At 64 x 64 gutters are one texel wide, so that all levels have level 0's texels for samples.
TEST(BenchLevels, EveryRuleOfEveryLevel) {
    const std::vector<LevelBench> rows =
        bench_levels(1, {.mesh = torus(100), .recipes = {"noise"}, .side = 64}, 40);
    const std::vector<std::string> rules{"average", "direct:64", "direct:16", "direct:4",
                                         "direct:1"};
    ASSERT_EQ(rows.size(), 25u);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const LevelBench& row = rows[i];
        EXPECT_EQ(row.level, i / 5 + 1);
        EXPECT_EQ(row.rule, rules[i % 5]);
        EXPECT_EQ(row.samples, 1.0);
        EXPECT_GT(row.rmse, 0.0);
        EXPECT_EQ(row.rmse, rows[i - i % 5].rmse);
        EXPECT_EQ(row.of_average, 1.0);
        EXPECT_GT(row.time.median, 0.0);
    }
    EXPECT_GT(rows.back().rmse, rows.front().rmse);
}

}  // namespace
}  // namespace burl
