// A thinned choice of `burl bench stability`, and that its measure is one: the truth it holds
// texels against, and that it sees a single wrong texel.
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "app/recipe/lattice_check.h"
#include "atlas/base/error.h"
#include "procedural/color/map_filter.h"
#include "tests/app/programs/run_program.h"
#include "tests/stability/checks.h"
#include "tests/stability/stability.h"

namespace burl::test {
namespace {

void expect_row(const StabilityRow& row) {
    const std::string name = row.group + ", " + row.arithmetic + ": " + row.input;
    EXPECT_GT(row.values, 100u) << name;
    EXPECT_GT(row.cases, 3u) << name;
    EXPECT_LE(row.share, 1.0) << name;
    EXPECT_LE(row.jump_share, 1.0) << name;
    EXPECT_LE(row.seam_share, 1.0) << name;
    testing::Test::RecordProperty(row.group + ", " + row.arithmetic, fmt::format("{}", row.share));
    if (row.case_name.empty()) return;
    EXPECT_GT(row.share, 1e-9) << name;  // it looked
    EXPECT_FALSE(row.input.empty()) << name;
}

TEST(Stability, StaysWithinWhatIsAllowed) {
    std::set<std::string> arithmetics, groups;
    for (const StabilityRow& row : stability_errors(StabilityChoice::thinned)) {
        expect_row(row);
        groups.insert(row.group);
        arithmetics.insert(row.arithmetic);
    }
    for (const char* group : {"coordinates", "beyond 2^31", "lattice planes", "runs", "frequencies",
                              "octaves", "quadrics", "other sums", "filters: trapezoid",
                              "|q| <= 1, sum |a_k| = 2: largest", "|q| <= 1, sum |a_k| = 2: RMS"})
        EXPECT_TRUE(groups.contains(group)) << group;
    for (const char* name : {"float32", "float64", "forward float32", "forward float64"})
        EXPECT_TRUE(arithmetics.contains(name)) << name;
}

TEST(Stability, ChangesNoBitAndRefusesWhatItMust) {
    std::set<std::string> counted;
    for (const StabilityRow& row : stability_counts(StabilityChoice::thinned)) {
        expect_row(row);
        if (row.error == 0.0) counted.insert(row.group);
    }
    for (const char* group :
         {"2^32 cells apart", "threads", "places in a batch", "kernels, instruction sets",
          "filters: finite, in [0, 1]", "refusals"})
        EXPECT_TRUE(counted.contains(group)) << group;
}

TEST(Stability, LooksAtEveryKernel) {
    std::set<std::string> ways;
    for (const StabilityWay& way : stability_ways()) ways.insert(way.name);
    for (const NamedKernel& one : kernel_names)
        EXPECT_TRUE(ways.contains("--kernel " + std::string(one.name))) << one.name;
}

TEST(Stability, NamesCasesThatCanBeRepeated) {
    const StabilityCase one = stability_case("coordinates/20", StabilityChoice::thinned);
    EXPECT_EQ(one.input, stability_groups(StabilityChoice::thinned)[0].cases[20].input);
    EXPECT_EQ(case_errors(one).size(), stability_ways().size());
    for (const char* name : {"coordinates", "coordinates/", "coordinates/1x", "nowhere/0",
                             "coordinates/100000", "", "/"})
        EXPECT_THROW(stability_case(name, StabilityChoice::thinned), Error) << name;
}

Texture noise_of(const NoiseTerm& term) {
    Texture texture;
    texture.noise = {term};
    return texture;
}

TEST(StabilityTruth, IsThatOfTheTestValues) {
    // docs/reference/numerics.md.
    NoiseTerm term;
    term.range = NoiseRange::bipolar, term.seed = 7;
    EXPECT_NEAR(double(StabilityTruth(noise_of(term), {}).field({-3.7L, 12.1L, 0.9L})),
                0.307899214650604, 1e-15);
    term.fade = Fade::quintic, term.seed = 4294967295u;
    EXPECT_NEAR(double(StabilityTruth(noise_of(term), {}).field({1000000.3L, -2000000.6L, 5.5L})),
                0.250325029089344, 1e-9);
    term.kind = NoiseKind::perlin, term.seed = 5;
    EXPECT_NEAR(double(StabilityTruth(noise_of(term), {}).field({-3.7L, 12.1L, 0.9L})),
                0.209581889957376, 1e-15);
    term.kind = NoiseKind::simplex, term.seed = 0;
    EXPECT_NEAR(double(StabilityTruth(noise_of(term), {}).field({-3.7L, 12.1L, 0.45L})),
                0.0368476945989575, 1e-15);
}

TEST(StabilityTruth, AgreesWithTheReferenceWhereThatIsExact) {
    Texture texture;
    texture.quadric = {1, 2, -3, 4, 0.5, 6, -7, 0.25, 9, 10};
    for (const NamedTerm& noise : named_terms()) {
        texture.noise.push_back(noise.term);
        texture.noise.back().shape = OctaveShape(texture.noise.size() % 3);
    }
    const Affine3 map{2.0 * Mat3d(1.0), Vec3d(0.5, 0.0, -1.0)};
    const StabilityTruth truth(texture, map);
    for (int i = 0; i < 50; ++i) {
        // Multiples of 2^-20 are exact on both sides.
        const TexelMap texel{Vec3d(i * 0.25, -i, 3.0), Vec3d(17, 4711, -5) * 0x1p-20, {}, 0, 0};
        const LongPoint p = truth.point(texel, i, 0);
        const Vec3d s = map(texel(i, 0));
        for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(double(p[std::size_t(axis)]), s[axis]);
        const FieldSample reference = sample_field<double>(texture.quadric, truth.octaves(), s);
        const LongNoise exact = truth.sample(p);
        ASSERT_EQ(exact.value, truth.field(p));
        ASSERT_NEAR(double(exact.value), reference.value,
                    2e-14 * (10.0 + std::abs(reference.value)));
        for (int axis = 0; axis < 3; ++axis)
            ASSERT_NEAR(double(exact.gradient[std::size_t(axis)]), reference.gradient[axis],
                        1e-12 * (10.0 + std::abs(reference.gradient[axis])));
    }
}

TEST(StabilityTruth, KeepsPlacesThatFloat64Loses) {
    for (const NoiseKind kind : {NoiseKind::value, NoiseKind::perlin, NoiseKind::simplex}) {
        NoiseTerm term;
        term.kind = kind;
        const StabilityTruth truth(noise_of(term), {});
        // Cells repeat after 2^32, simplices after three times as many.
        const long double third = 0.3L, far = 3.0L * 0x1p40L;
        const auto here = double(truth.field({third, 0.7L * third, 0.1L}));
        const auto there = double(truth.field({far + third, far + 0.7L * third, far + 0.1L}));
        EXPECT_NEAR(there, here, 2e-6);
        const double rounded = double(far) + 0.3;
        EXPECT_GT(std::abs(evaluate_field(noise_of(term), Vec3d(rounded)) -
                           double(truth.field({third, third, third}))),
                  1e-6);
    }
}

TEST(StabilityTruth, TakesEitherSideOfAJumpForWhatRoundingCannotTell) {
    NoiseTerm term;
    term.kind = NoiseKind::cell;
    const StabilityTruth truth(noise_of(term), {});
    const SpanSizes sizes{1.0, 0.0};
    const auto left = double(truth.field({0.5L, 0.5L, 0.5L})),
               right = double(truth.field({1.5L, 0.5L, 0.5L}));
    ASSERT_GT(std::abs(left - right), 0.1);
    EXPECT_EQ(truth.error({1.0L, 0.5L, 0.5L}, left, sizes, 0x1p-23), 0.0);
    EXPECT_EQ(truth.error({1.0L, 0.5L, 0.5L}, right, sizes, 0x1p-23), 0.0);
    EXPECT_GT(truth.error({1.001L, 0.5L, 0.5L}, left, sizes, 0x1p-23), 0.1);
    EXPECT_GT(truth.error({1.0L, 0.5L, 0.5L}, 0.5 * (left + right), sizes, 0x1p-23), 0.04);
}

TEST(StabilityFilters, MeanIsThatOfTheClosedForms) {
    const ColorMap map{Wrap::repeat,
                       {{0.1, {20, 200, 20}}, {0.5, {230, 20, 120}}, {0.7, {0, 0, 90}}}};
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        ColorMap one = map;
        one.wrap = wrap;
        const MapPieces pieces(one);
        for (const double f : {-0.3, 0.0, 0.11, 0.49, 0.6, 7.25})
            for (const double u : {0.0, 1e-9, 1e-3, 0.2, 1.5, 20.0})
                for (const double ratio : {0.0, 1e-3, 0.5, 1.0}) {
                    const Vec3d mean = long_mean(one, f, u, -ratio * u);
                    EXPECT_LT(glm::distance(mean, trapezoid_filtered(pieces, f, {u, ratio * u})),
                              3e-7)
                        << f << " " << u << " " << ratio;
                }
    }
}

TEST(Stability, SeesASingleWrongTexel) {
    const StabilityGroup group = stability_groups(StabilityChoice::thinned).front();
    const StabilityCase& one = group.cases.at(20);
    const StabilityWay way = stability_ways().front();
    std::vector<double> texels = fill_texels(one, way, 1);
    EXPECT_LE(field_errors(one, way, texels).share, 1.0);
    texels[48 + 7] += 2e-6;
    const StabilityRow worse = field_errors(one, way, texels);
    EXPECT_GT(worse.share, 1.0);
    EXPECT_NE(worse.input.find("texel (7, 1)"), std::string::npos) << worse.input;
    texels[48 + 7] = std::nan("");
    EXPECT_EQ(field_errors(one, way, texels).share, HUGE_VAL);
}

TEST(LatticeCheck, RefusesWhatLiesTooFarOutInOneSentence) {
    const Scratch scratch;
    const std::string mesh = scratch.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string points = scratch.write("p.csv", "1,2,3\n1e14,0,0\n");
    const std::string out = scratch / "o.png";
    constexpr const char* steep =
        "--set texture.input.noise.0.lacunarity=16 --set texture.input.noise.0.octaves=24";
    for (const auto& [command, says] :
         {std::pair{fmt::format("bake '{}' -o '{}' {}", mesh, out, steep),
                    "texture.input.noise.0: octave 12 of 24 reaches"},
          {fmt::format("render --direct '{}' -o '{}' {}", mesh, out, steep), "2^46"},
          {fmt::format("bake '{}' -o '{}' --kernel forward {}", mesh, out, steep), "2^46"},
          {fmt::format("bake '{}' -o '{}' --precision float64 {}", mesh, out, steep), "2^46"},
          {fmt::format("bake '{}' -o '{}' --set solid.scale=1e6 --set "
                       "texture.input.noise.0.frequency.1=1e6 --set "
                       "texture.input.noise.0.octaves=9",
                       mesh, out),
           "octave 9 of 9 reaches 1.3e+14 lattice cells"},
          {fmt::format("bake '{}' -o '{}' --set solid.scale=1e6 --set "
                       "texture.input.noise.0.matrix=[1,0,0,0,0,1e9,0,0,0,0,1,0]",
                       mesh, out),
           "octave 1 of 4 reaches 5e+14"},
          {fmt::format("eval marble --points '{}'", points), "octave 1 of 4 reaches"},
          {fmt::format("bake '{}' -o '{}' --animate texture.input.noise.0.lacunarity=2:16 "
                       "--frames 3 --set texture.input.noise.0.octaves=20",
                       mesh, out),
           "use fewer octaves"}}) {
        const Outcome outcome = run_burl(scratch, command);
        EXPECT_EQ(outcome.exit_code, 5) << command << "\n" << outcome.err;
        expect_one_sentence(outcome.err);
        EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err;
        EXPECT_EQ(scratch.files(), 2u) << command;  // nothing is written
    }
    const std::string near = scratch.write("near.csv", "1,2,3\n");
    for (
        const auto& [texture, says] :
        {std::pair{R"({"node": "fbm", "octaves": 20, "lacunarity": 16})",
                   "texture: a node \"fbm\""},
         {R"({"node": "transform", "scale": [1e6, 1, 1], "input": {"node": "transform",
               "matrix": [1e6,0,0,0, 0,1,0,0, 0,0,1,0], "input": {"node": "wrinkled", "octaves": 9}}})",
          "\"wrinkled\" reaches"},
         {R"({"node": "warp", "strength": 1e6, "gain": 2, "octaves": 24, "input":
               {"node": "transform", "scale": [10, 1, 1], "input": {"node": "dots"}}})",
          "\"dots\" reaches "},
         {R"({"node": "transform", "scale": [1, 1e6, 1], "input": {"node": "transform",
               "scale": [1, 1e6, 1], "input": {"node": "bricks", "height": 1e-4}}})",
          "\"bricks\" reaches "},
         {R"({"node": "transform", "scale": [1e6, 1, 1], "input": {"node": "transform",
               "scale": [1e6, 1, 1], "input": {"node": "transform", "scale": [1e3, 1, 1],
               "input": {"node": "cells"}}}})",
          "\"cells\" reaches "},
         {R"({"node": "simplex_nd", "octaves": 20, "lacunarity": 16})", "a node \"simplex_nd\""},
         {R"({"node": "fibre", "width": 1e-6, "octaves": 24, "lacunarity": 4})",
          "\"fibre\" reaches"},
         {R"({"node": "curl", "strength": 1e6, "scale": 1e6, "gain": 2, "octaves": 24,
               "input": {"node": "dots"}})",
          "\"curl\" reaches"},
         {R"({"node": "curl", "strength": 1e6, "gain": 2, "octaves": 24, "lacunarity": 0.5, "input":
               {"node": "transform", "scale": [10, 1, 1], "input": {"node": "dots"}}})",
          "\"dots\" reaches "},
         {R"({"node": "map_spherical", "input": {"node": "field", "noise": [
               {"lacunarity": 16, "octaves": 16}]}})",
          "\"field\" reaches "}}) {
        const std::string recipe =
            scratch.write("r.json", fmt::format(R"({{"texture": {}}})", texture));
        for (const std::string& command :
             {fmt::format("bake '{}' -o '{}' -s 32 -r '{}'", mesh, out, recipe),
              fmt::format("render --direct '{}' -o '{}' --size 32x24 -r '{}'", mesh, out, recipe),
              fmt::format("eval '{}' --points '{}'", recipe, near)}) {
            const Outcome outcome = run_burl(scratch, command);
            EXPECT_EQ(outcome.exit_code, 5) << command << outcome.err;
            expect_one_sentence(outcome.err);
            EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err;
        }
    }
    // Far out but not too far, and octaves that nobody sees.
    for (const char* fits :
         {"--set texture.input.noise.0.octaves=24",
          "--set texture.input.noise.0.octaves=24 --set "
          "texture.input.noise.0.lacunarity=16 --set texture.input.noise.0.gain=0",
          "--set solid.scale=1e6 --set texture.input.noise.0.phase.0=1e9"}) {
        const Outcome outcome =
            run_burl(scratch, fmt::format("bake '{}' -o '{}' -s 32 {}", mesh, out, fits));
        EXPECT_EQ(outcome.exit_code, 0) << fits << outcome.err;
    }
}

}  // namespace
}  // namespace burl::test
