// A thinned choice of `burl bench stability`, and that its measure is one: the truth it holds
// texels against, and that it sees a single wrong texel.
#include <cmath>

#include <gtest/gtest.h>

#include "app/bench_stability.h"
#include "app/lattice_check.h"
#include "app/stability_truth.h"
#include "procedural/synthesize.h"
#include "tests/app/run_program.h"

namespace burl::test {
namespace {

TEST(Stability, StaysWithinWhatIsAllowed) {
    std::size_t counted = 0;
    for (const StabilityRow& row : bench_stability(false)) {
        EXPECT_GT(row.values, 300u) << row.group;
        EXPECT_GT(row.cases, 5u) << row.group;
        EXPECT_LE(row.share, 1.0) << row.group << ": " << row.input;
        if (row.group == "2^32 cells apart") counted = 1;
        if (counted == 0) {
            EXPECT_TRUE(row.error > 0.0 || row.group == "runs: seams") << row.group;
            EXPECT_FALSE(row.input.empty()) << row.group;
        } else {
            ++counted;
            EXPECT_EQ(row.error, 0.0) << row.group << ": " << row.input;
        }
    }
    EXPECT_EQ(counted, 6u);  // five rows count failures
}

Texture noise_of(const NoiseTerm& term) {
    Texture texture;
    texture.noise = {term};
    return texture;
}

TEST(StabilityTruth, IsThatOfTheTestValues) {
    // docs/numerics.md.
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
}

TEST(StabilityTruth, AgreesWithTheReferenceWhereThatIsExact) {
    Texture texture;
    texture.quadric = {1, 2, -3, 4, 0.5, 6, -7, 0.25, 9, 10};
    for (const Fade fade : {Fade::linear, Fade::smooth, Fade::quintic})
        for (const NoiseKind kind : {NoiseKind::value, NoiseKind::perlin, NoiseKind::simplex}) {
            NoiseTerm term;
            term.kind = kind, term.fade = fade, term.octaves = 3, term.amplitude = 0.7;
            term.shape = OctaveShape(texture.noise.size() % 3);
            texture.noise.push_back(term);
        }
    const Affine3 map{2.0 * Mat3d(1.0), Vec3d(0.5, 0.0, -1.0)};
    const StabilityTruth truth(texture, map);
    for (int i = 0; i < 50; ++i) {
        // Multiples of 2^-20 are exact on both sides.
        const TexelMap texel{Vec3d(i * 0.25, -i, 3.0), Vec3d(17, 4711, -5) * 0x1p-20, {}, 0, 0};
        const StabilityTruth::Point p = truth.point(texel, i, 0);
        const Vec3d s = map(texel(i, 0));
        for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(double(p[std::size_t(axis)]), s[axis]);
        const double reference = evaluate_field(texture, s);
        ASSERT_NEAR(double(truth.field(p)), reference, 1e-14 * (10.0 + std::abs(reference)));
    }
}

TEST(StabilityTruth, KeepsPlacesThatFloat64Loses) {
    const StabilityTruth truth(noise_of({}), {});
    const long double third = 1.0L / 3.0L, far = 0x1p40L;  // cells repeat after 2^32
    const auto here = double(truth.field({third, third, third}));
    EXPECT_NEAR(double(truth.field({far + third, far + third, far + third})), here, 1e-6);
    const double rounded = 0x1p40 + 1.0 / 3.0;
    EXPECT_GT(std::abs(evaluate_field(noise_of({}), Vec3d(rounded)) - here), 1e-6);
}

TEST(Stability, SeesASingleWrongTexel) {
    const StabilityGroup group = stability_groups(false).front();
    const StabilityCase& one = group.cases.at(20);
    Image<float> field = synthesize_field(one.solid, one.texture, one.map, 1);
    EXPECT_LE(field_errors(one, field).share, 1.0);
    field(7, 2) += 2e-6f;
    const StabilityRow worse = field_errors(one, field);
    EXPECT_GT(worse.share, 1.0);
    EXPECT_NE(worse.input.find("texel (7, 2)"), std::string::npos) << worse.input;
    field(7, 2) = std::nanf("");
    EXPECT_EQ(field_errors(one, field).share, HUGE_VAL);
}

struct Refusal {
    const char* arguments;
    const char* says;
};

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
    EXPECT_EQ(run_burl(scratch, fmt::format("bake '{}' -o '{}' -s 32 --set "
                                            "texture.input.noise.0.octaves=24",
                                            mesh, out))
                  .exit_code,
              0);
}

}  // namespace
}  // namespace burl::test
