// The library from outside: linked as a program links it, and held to the program's own files and
// to figures that do not come from it.
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "burl/bake.h"
#include "burl/evaluate.h"
#include "burl/metrics.h"
#include "burl/version.h"
#include "tests/library/library_folder.h"

namespace {

TEST(Library, WritesTheProgramsBytes) {
    const fs::path path = folder();
    const burl::Mesh mesh = burl::Mesh::read("sample:torus");
    for (const std::string recipe : {"oak", "marble", "gold"}) {
        burl::BakeOptions options;
        options.size = 128;
        options.levels = -1;
        const burl::Baked baked = burl::bake(mesh, burl::Recipe::load(recipe), options);
        burl::write(baked, (path / "ours.glb").string());
        run_burl("bake sample:torus --recipe " + recipe + " --size 128 --levels all -o " +
                 (path / "theirs.glb").string());
        EXPECT_EQ(bytes_of(path / "ours.glb"), bytes_of(path / "theirs.glb")) << recipe;
        EXPECT_GT(bytes_of(path / "ours.glb").size(), 10000u);
    }
}

TEST(Library, WritesTheProgramsPictures) {
    const fs::path path = folder();
    burl::BakeOptions options;
    options.size = 64;
    options.depth = 16;
    options.packing = "separate";
    options.masks = {"occlusion"};
    const burl::Baked baked =
        burl::bake(burl::Mesh::read("sample:cube"), burl::Recipe::load("oak"), options);
    burl::write(baked, (path / "ours.png").string());
    run_burl("bake sample:cube --recipe oak --size 64 --depth 16 --channels occlusion -o " +
             (path / "theirs.png").string());
    std::size_t pictures = 0;
    for (const auto& file : fs::directory_iterator(path)) {
        const std::string name = file.path().filename().string();
        if (!name.starts_with("ours")) continue;
        ++pictures;
        EXPECT_TRUE(bytes_of(file.path()) == bytes_of(path / ("theirs" + name.substr(4)))) << name;
    }
    EXPECT_EQ(pictures, baked.image_names().size());
    EXPECT_GE(pictures, 3u);  // colour, occlusion and what oak varies
}

TEST(Library, WritesTheProgramsFloats) {
    const fs::path path = folder();
    const burl::Mesh torus = burl::Mesh::read("sample:torus");
    for (const std::string recipe : {"marble", "oak"})  // a texture alone, and a material
        for (const int levels : {0, -1}) {
            burl::BakeOptions options;
            options.size = 64;
            options.depth = 32;
            options.levels = levels;
            options.packing = "separate";
            const burl::Baked baked = burl::bake(torus, burl::Recipe::load(recipe), options);
            burl::write(baked, (path / "ours.exr").string());
            run_burl("bake sample:torus --depth 32 --size 64 --force --recipe " + recipe +
                     (levels == 0 ? "" : " --levels all") + " -o " +
                     (path / "theirs.exr").string());
            EXPECT_TRUE(bytes_of(path / "ours.exr") == bytes_of(path / "theirs.exr"))
                << recipe << ' ' << levels;
            EXPECT_GT(bytes_of(path / "ours.exr").size(), 10000u);
        }
}

TEST(Library, BakesTheSameFloats) {
    // A float and its code of 8 bits are the same value: sRGB's formula (IEC 61966-2-1) says so.
    const burl::Mesh mesh = burl::Mesh::read("sample:cube");
    burl::BakeOptions codes, floats;
    codes.size = floats.size = 64;
    floats.depth = 32;
    for (const std::string recipe : {"marble", "carrara"}) {
        const burl::Recipe loaded = burl::Recipe::load(recipe);
        const burl::Baked a = burl::bake(mesh, loaded, codes), b = burl::bake(mesh, loaded, floats);
        const burl::ImageView low = a.image("color"), high = b.image("color");
        ASSERT_EQ(low.components, 3u);
        ASSERT_EQ(high.components, 3u);
        EXPECT_EQ(high.type, burl::ComponentType::f32);
        EXPECT_TRUE(low.srgb);
        const auto* code = static_cast<const std::uint8_t*>(low.data);
        const auto* number = static_cast<const float*>(high.data);
        for (std::size_t i = 0; i < 64 * 64 * 3; ++i) {
            const double x = number[i];
            const double srgb = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
            ASSERT_NEAR(code[i], 255.0 * srgb, 0.51) << recipe << ' ' << i;
        }
    }
}

TEST(Library, ArraysAreAMesh) {
    const burl::Mesh mesh(tetrahedron, faces, {}, "corner");
    EXPECT_EQ(mesh.name(), "corner");
    ASSERT_EQ(mesh.positions().size(), 12u);
    ASSERT_EQ(mesh.triangles().size(), 12u);
    EXPECT_TRUE(mesh.uvs().empty());
    for (std::size_t i = 0; i < 12; ++i)  // points are numbered by first use: corner by corner
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(mesh.positions()[3 * mesh.triangles()[i] + k], tetrahedron[3 * faces[i] + k]);
}

TEST(Library, AtlasHasEveryTriangle) {
    burl::BakeOptions options;
    options.size = 64;
    options.atlas = "area";
    const burl::Baked baked =
        burl::bake(burl::Mesh(tetrahedron, faces), burl::Recipe::load("marble"), options);
    const auto uvs = baked.uvs();
    ASSERT_EQ(baked.triangles().size(), 12u);
    ASSERT_EQ(uvs.size(), 24u);
    double covered = 0.0;
    for (std::size_t t = 0; t < 4; ++t) {
        const double* p = &uvs[6 * t];
        covered += 0.5 * std::abs((p[2] - p[0]) * (p[5] - p[1]) - (p[4] - p[0]) * (p[3] - p[1]));
        for (std::size_t k = 0; k < 6; ++k) EXPECT_TRUE(p[k] >= 0.0 && p[k] <= 1.0);
    }
    EXPECT_GT(covered, 0.5);
    EXPECT_LE(covered, 1.0);
}

TEST(Library, RefusesArraysInASentence) {
    using burl::ErrorKind;
    const auto refused = [](std::vector<double> points, std::vector<std::uint32_t> corners,
                            std::vector<double> uvs = {}) {
        return error_of([&] { burl::Mesh(points, corners, uvs); });
    };
    EXPECT_EQ(
        refused({0, 0}, {0, 1, 2}),
        std::pair(ErrorKind::usage, std::string("positions: 2 numbers are not three per point")));
    EXPECT_EQ(refused(tetrahedron, {0, 1, 7}).second,
              "triangles: triangle 0 refers to point 7, and there are points 0 to 3");
    EXPECT_EQ(refused(tetrahedron, {}).second,
              "triangles: 0 numbers are not three per triangle, of at least one");
    EXPECT_EQ(refused({0, 0, 0, 1, 0, 0, 0, std::nan(""), 0}, {0, 1, 2}).second,
              "positions: row 2 has nan, which is not finite or beyond 1e+100");
    EXPECT_EQ(refused(tetrahedron, faces, {0, 1}).second,
              "uvs: 2 numbers are not two per corner of 4 triangles, which are 24");
}

TEST(Library, RefusesOptionsInASentence) {
    const burl::Mesh mesh(tetrahedron, faces);
    const burl::Recipe recipe = burl::Recipe::load("marble");
    const auto refused = [&](auto change) {
        burl::BakeOptions options;
        options.size = 32;
        change(options);
        return error_of([&] { burl::bake(mesh, recipe, options); });
    };
    using Options = burl::BakeOptions;
    EXPECT_EQ(refused([](Options& o) { o.depth = 12; }).second, "depth 12: must be 8, 16 or 32");
    EXPECT_EQ(refused([](Options& o) { o.atlas = "quads"; }).second,
              "atlas 'quads': must be one of uniform, area, length, quad, patch, chart, uv");
    EXPECT_EQ(refused([](Options& o) { o.size = 99999; }).first, burl::ErrorKind::usage);
    EXPECT_EQ(refused([](Options& o) { o.atlas = "uv"; }).first, burl::ErrorKind::usage);
    // Options of the command line go by the library's names.
    EXPECT_NE(refused([](Options& o) { o.atlas = "uv"; }).second.find("use atlas chart"),
              std::string::npos);
    EXPECT_EQ(error_of([] { burl::Mesh::read("sample:cube", {.up = "w"}); }).second.find("up w: "),
              0u);
    EXPECT_NE(refused([](Options& o) { o.masks = {"fog"}; }).second.find("no mask 'fog'"),
              std::string::npos);
    EXPECT_EQ(error_of([] { burl::Recipe::load("no-such-wood"); }).first, burl::ErrorKind::usage);
    EXPECT_EQ(error_of([] { burl::Mesh::read("/nowhere/a.obj"); }).first, burl::ErrorKind::io);
    EXPECT_EQ(error_of([] { burl::Recipe::parse("{\"textur\": 1}"); }).first,
              burl::ErrorKind::invalid_file);
    const burl::Baked baked = burl::bake(mesh, recipe, {.size = 32});
    EXPECT_EQ(error_of([&] { burl::write(baked, "a.exr"); }).first, burl::ErrorKind::usage);
    EXPECT_NE(error_of([&] { baked.image("colour"); }).second.find("there are color"),
              std::string::npos);
}

TEST(Library, RecipesChange) {
    const burl::Recipe marble = burl::Recipe::load("marble");
    const burl::Recipe smaller = marble.set("atlas.size", 48);
    EXPECT_EQ(burl::Recipe::parse(smaller.to_json()).to_json(), smaller.to_json());
    const burl::Baked baked = burl::bake(burl::Mesh(tetrahedron, faces), smaller);
    EXPECT_EQ(baked.image("color").width, 48u);
    const auto [kind, sentence] = error_of([&] { marble.set("atlas.sise", 48); });
    EXPECT_EQ(kind, burl::ErrorKind::usage);
    EXPECT_TRUE(sentence.starts_with("there is no parameter")) << sentence;
    EXPECT_GT(burl::Recipe::names().size(), 50u);
}

TEST(Library, EvaluatesAQuadric) {
    // f = s^2 + s t at the point (s, t, r) before the recipe's scale, 1: so are its derivatives.
    const burl::Recipe recipe = burl::Recipe::parse(
        R"({"texture": {"node": "color_map", "stops": [[0, "#000000"], [1, "#ffffff"]],)"
        R"( "input": {"node": "field", "quadric": {"A": 1, "B": 0.5}}}})");
    const std::vector<double> points{0.125, 0.25, 0.5, -0.5, 0.5, 0.0};
    const burl::Evaluated at = burl::evaluate(recipe, points);
    ASSERT_EQ(at.values.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const double x = points[3 * i], y = points[3 * i + 1];
        EXPECT_NEAR(at.values[i], x * x + x * y, 1e-15);
        EXPECT_NEAR(at.gradients[3 * i], 2 * x + y, 1e-15);
        EXPECT_NEAR(at.gradients[3 * i + 1], x, 1e-15);
        EXPECT_NEAR(at.gradients[3 * i + 2], 0.0, 1e-15);
    }
}

TEST(Library, EvaluatesManyPointsLikeOne) {
    const burl::Recipe oak = burl::Recipe::load("oak");
    std::vector<double> points(3 * 10000);
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = std::sin(double(i));
    const burl::Evaluated all = burl::evaluate(oak, points, {.channel = "roughness"});
    for (const std::size_t i :
         {std::size_t(0), std::size_t(4095), std::size_t(4096), std::size_t(9999)}) {
        const burl::Evaluated one =
            burl::evaluate(oak, std::span(points).subspan(3 * i, 3), {.channel = "roughness"});
        EXPECT_EQ(all.values[i], one.values[0]);
        EXPECT_TRUE(one.values[0] > 0.0 && one.values[0] < 1.0);
    }
    EXPECT_EQ(error_of([&] { burl::evaluate(oak, std::span(points).first(4)); }).second,
              "points: 4 numbers are not three per point");
}

TEST(Library, MetricsAreTheProgramsOwn) {
    const fs::path path = folder();
    const std::string command = std::string(BURL_PROGRAM) +
                                " metrics sample:torus --atlas quad --size 64 --json > " +
                                (path / "metrics.json").string();
    ASSERT_EQ(std::system(command.c_str()), 0);
    const burl::Mesh torus = burl::Mesh::read("sample:torus");
    const std::string ours = burl::metrics(torus, burl::Recipe::load("marble"), {"quad", 64});
    EXPECT_EQ(ours, bytes_of(path / "metrics.json"));
    EXPECT_EQ(burl::number_at(ours, "/atlases/0/size"), 64.0);
    EXPECT_EQ(error_of([&] { burl::number_at(ours, "/atlases/7"); }).first, burl::ErrorKind::usage);
}

TEST(Library, TellsHowFarItIs) {
    burl::BakeOptions options;
    options.size = 64;
    std::vector<std::string> stages;
    std::vector<double> shares;
    const auto here = std::this_thread::get_id();
    options.progress = [&](const burl::ProgressState& state) {
        EXPECT_EQ(std::this_thread::get_id(), here);
        stages.push_back(state.stage);
        shares.push_back(state.share);
        return true;
    };
    burl::bake(burl::Mesh(tetrahedron, faces), burl::Recipe::load("marble"), options);
    ASSERT_FALSE(shares.empty());
    EXPECT_EQ(shares.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
}

TEST(Library, StopsWhenItIsTold) {
    const burl::Mesh torus = burl::Mesh::read("sample:torus");
    for (const int depth : {8, 32})
        for (const std::string recipe : {"wood", "oak"}) {  // a texture alone, and a material
            burl::BakeOptions options;
            options.size = 4096;  // a second and more
            options.depth = depth;
            const auto start = std::chrono::steady_clock::now();
            auto asked = start;
            options.progress = [&](const burl::ProgressState&) {
                asked = std::chrono::steady_clock::now();
                return asked - start < std::chrono::milliseconds(150);
            };
            const auto error =
                error_of([&] { burl::bake(torus, burl::Recipe::load(recipe), options); });
            EXPECT_EQ(error.first, burl::ErrorKind::stopped) << recipe << ' ' << error.second;
            EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(2));
        }
}

TEST(Library, LetsExceptionsOfCallbacksThrough) {
    burl::BakeOptions options;
    options.size = 64;
    options.progress = [](const burl::ProgressState&) -> bool { throw std::array<int, 2>{4, 2}; };
    try {
        burl::bake(burl::Mesh(tetrahedron, faces), burl::Recipe::load("marble"), options);
        FAIL();
    } catch (const std::array<int, 2>& thrown) {
        EXPECT_EQ(thrown[1], 2);
    }
}

TEST(Library, TellsItsVersion) {
    EXPECT_EQ(burl::version(), BURL_VERSION);
    EXPECT_FALSE(burl::simd().empty());
}

}  // namespace
