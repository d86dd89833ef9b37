// What suites report: errors against values worked out by hand, and what all rows have.
#include "app/bench/bench.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "app/bench/meshes.h"
#include "app/bench/noise.h"
#include "app/bench/synthesis.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {
namespace {

TEST(BenchResult, HasTheErrorsOfItsValues) {
    const std::vector<double> values{0.5, 1.0, -0.25, 0.0}, reference{0.5, 0.7, 0.15, 0.0};
    const BenchError error = BenchError::of(values, reference);
    EXPECT_NEAR(error.max, 0.4, 1e-15);
    EXPECT_NEAR(error.rms, 0.25, 1e-15);
    EXPECT_NEAR(error.psnr(), 12.0412, 1e-4);
    EXPECT_TRUE(std::isinf(BenchError::of(values, values).psnr()));
}

TEST(BenchResult, TimesAreOverThoseOfTheGroupsFirst) {
    int runs = 0;
    const auto count = [&runs] { ++runs; };
    const std::vector<BenchRow> rows = run_paired(
        {{"a", 1, "run", count, "g"}, {"b", 1, "run", count, "g"}, {"c", 1, "run", count, "h"}}, 3);
    EXPECT_EQ(runs, 12);  // a warm-up and three rounds
    EXPECT_EQ(rows[0].times_first, 1.0);
    EXPECT_EQ(rows[2].times_first, 1.0);
    EXPECT_GT(rows[1].times_first, 0.0);
    EXPECT_LE(rows[1].lowest, rows[1].median);
    EXPECT_LE(rows[1].median, rows[1].highest);
    EXPECT_EQ(rows[1].rounds, 3);
}

TEST(BenchResult, WhatIsNotKnownIsNull) {
    BenchResult result;
    result.time.name = "untimed";
    Json json = result_json(result);
    for (const char* key :
         {"ns_median", "ns_lowest", "ns_highest", "times_first", "error_max", "error_rms", "psnr"})
        EXPECT_TRUE(json.at(key).is_null()) << key;
    result.error = BenchError{};
    json = result_json(result);
    EXPECT_EQ(json.at("error_rms"), 0.0);
    EXPECT_TRUE(json.at("psnr").is_null()) << "infinite";
    EXPECT_FALSE(json.contains("texels_per_span"));
    EXPECT_NE(result_table({&result, 1}).find("untimed"), std::string::npos);
}

TEST(BenchNoise, FindsFloatsErrorAndNoneInTheReference) {
    const std::vector<BenchResult> results = bench_noise(1, 1024);
    std::set<std::string> groups;
    int vectors = 0;
    for (const BenchResult& r : results) {
        groups.insert(r.time.group);
        EXPECT_GT(r.time.median, 0.0);
        if (!r.error) continue;  // another library's
        const bool reference = r.time.name.ends_with("float64");
        if (reference) {
            EXPECT_EQ(r.error->max, 0.0) << r.time.name;
        } else {
            EXPECT_LT(r.error->max, 1e-5) << r.time.name;
        }
        if (r.time.name == "perlin, float32" || r.time.name.ends_with("vectors")) {
            EXPECT_GT(r.error->rms, 1e-9) << r.time.name;
            vectors += r.time.name.ends_with("vectors");
        }
    }
    EXPECT_GE(vectors, 6);  // value's three fades, perlin, four octaves of both
    EXPECT_EQ(groups.size(), 4u);
}

TEST(BenchSynthesis, RoundsToHalfACodeAndFloatsFurther) {
    for (const BenchResult& r : bench_synthesis(1, {.side = 48})) {
        ASSERT_TRUE(r.error);
        const std::string& name = r.time.name;
        if (name.starts_with("sRGB")) {
            EXPECT_GT(r.error->max, 1e-4);
            EXPECT_LT(r.error->max, 0.0045);  // half a code at white
        } else if (name.starts_with("linear")) {
            EXPECT_GT(r.error->max, 0.0);
            EXPECT_LT(r.error->max, 1e-4);
        } else {
            EXPECT_EQ(r.error->max, 0.0);
        }
    }
}

TEST(BenchSynthesis, SaysHowLongSpansAre) {
    SolidAtlas solid;
    solid.size = 8;
    for (const std::uint32_t count : {1u, 2u, 6u, 7u}) solid.spans.push_back({0, count, 0});
    EXPECT_EQ(mean_span(solid), 4.0);

    const auto mean_of = [](const Mesh& mesh, std::size_t side) {
        const std::vector<BenchResult> rows = bench_synthesis(1, {mesh, {"marble"}, side});
        for (const BenchResult& r : rows) {
            EXPECT_EQ(r.texels_per_span, rows[0].texels_per_span);
            EXPECT_EQ(result_json(r).at("texels_per_span"), *r.texels_per_span);
        }
        const std::string table = result_table(rows);
        const std::size_t line = table.find('\n') + 1;  // under the header, and nowhere else
        const std::size_t words = table.find(" texels per span on average\n");
        EXPECT_NEAR(std::stod(table.substr(line)), *rows[0].texels_per_span, 0.05);
        EXPECT_LT(words, table.find('\n', line));
        EXPECT_EQ(table.find("texels per span", words + 5), std::string::npos);
        return *rows[0].texels_per_span;
    };
    const double coarse = mean_of(bumpy_sphere(300), 256), fine = mean_of(bumpy_sphere(300), 512);
    EXPECT_GT(coarse, 2.0);
    EXPECT_NEAR(fine / coarse, 2.0, 0.4) << "triangles twice as wide have spans twice as long";
}

TEST(BenchSynthesis, TakesAnyMeshAndRecipe) {
    const auto plain = bench_synthesis(1, {bumpy_sphere(300), {"marble"}, 64});
    ASSERT_EQ(plain.size(), 4u);
    EXPECT_EQ(plain[0].time.group, "marble, 64 x 64");
    EXPECT_EQ(plain[0].time.units, 64.0 * 64.0);
    // A graph of nodes is held against its float64 evaluation.
    const auto graph = bench_synthesis(1, {bumpy_sphere(300), {"wrinkled"}, 64});
    ASSERT_EQ(graph.size(), 4u);
    for (const BenchResult& r : graph) {
        ASSERT_TRUE(r.error);
        EXPECT_GT(r.time.median, 0.0);
    }
    EXPECT_GT(graph[2].error->max, 0.0);
    EXPECT_LT(graph[2].error->max, 1e-5);
    EXPECT_EQ(graph[3].error->max, 0.0);
    EXPECT_THROW(bench_synthesis(1, {.recipes = {"no-such-recipe"}}), Error);
}

}  // namespace
}  // namespace burl
