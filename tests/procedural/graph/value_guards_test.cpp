// What graphs leave out of a batch, and interval arithmetic, against the same graphs in full.
#include "procedural/graph/value_guards.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "procedural/fill/graph.h"
#include "procedural/graph/value_ranges.h"
#include "procedural/graph/values.h"
#include "tests/procedural/graph/cases.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

constexpr Affine3 identity{Mat3d(1.0), Vec3d(0.0)};

Economy without(Skip skip, SynthesisWork* work) {
    Economy economy;
    economy.skips.forbid(skip);
    economy.work = work;
    return economy;
}

struct Twice {
    SynthesisWork with, without;
    std::uint64_t skipped(Skip skip) const { return with.octaves_skipped[unsigned(skip)]; }
};

/// Synthesises with and without the skip; the bytes must agree, and the counts add up.
Twice synthesize_twice(const std::string& json, Skip skip, const Filter& filter = {}) {
    const TextureGraph graph = graph_of(json);
    Twice counts;
    for (const std::uint32_t seed : {1u, 2u, 3u, 4u, 5u}) {
        const SolidAtlas solid =
            SyntheticAtlas{64, seed == 1 ? 7u : 64u, 0.0, 0.01, true}.make(seed);
        const auto image = synthesize_graph_rgbf(solid, graph, identity, filter, 1,
                                                 PrecisionKind::float32, {{}, &counts.with, {}});
        EXPECT_EQ(synthesize_graph_rgbf(solid, graph, identity, filter, 3, PrecisionKind::float32,
                                        without(skip, &counts.without)),
                  image)
            << json;
    }
    EXPECT_EQ(counts.with.octaves + counts.skipped(skip), counts.without.octaves) << json;
    return counts;
}

TEST(ValueGuards, LeaveOutSquaresThatABatchDoesNotTouch) {
    const Twice counts = synthesize_twice(
        R"({"node": "transform", "scale": 0.3, "input": {"node": "checkerboard",
            "a": {"node": "fbm", "octaves": 6}, "b": {"node": "wrinkled", "octaves": 6}}})",
        Skip::covered_layers);
    EXPECT_GT(counts.skipped(Skip::covered_layers), counts.without.octaves / 10);
}

TEST(ValueGuards, LeaveOutWhatIsUnderAnOpaqueLayer) {
    const std::string layered = R"({"node": "layer_over", "top": {"node": "color_map",
            "stops": [[0, "#ff0000"], [1, "#0000ff"]], "input": {"node": "fbm", "octaves": 3}},
        "base": {"node": "color_map", "stops": [[0, "#00ff00"], [1, "#ffffff"]],
                 "input": {"node": "fbm", "octaves": 5, "seed": 9}},
        "opacity": {"node": "smoothstep", "low": -0.2, "high": 0.3,
                    "input": {"node": "coordinate", "direction": [1, 0, 0]}}})";
    for (const Filter& filter : {Filter{}, Filter{FilterKind::supersample, 4}}) {
        const Twice counts = synthesize_twice(layered, Skip::covered_layers, filter);
        EXPECT_GT(counts.skipped(Skip::covered_layers), counts.without.octaves / 4);
    }
}

/// Layers whose weights hang on one another: a guard's weight may be what another one guards.
TEST(ValueGuards, NestAndCross) {
    const auto mask = [](int axis) {
        const std::array directions{"[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]"};
        return std::string(R"({"node": "smoothstep", "low": -0.1, "high": 0.1, "input":
            {"node": "coordinate", "direction": )") +
               directions[std::size_t(axis)] + "}}";
    };
    const auto noise = [](int seed) {
        return R"({"node": "fbm", "octaves": 4, "seed": )" + std::to_string(seed) + "}";
    };
    const auto mix = [](const std::string& a, const std::string& b, const std::string& amount) {
        return R"({"node": "mix", "a": )" + a + R"(, "b": )" + b + R"(, "amount": )" + amount + "}";
    };
    const auto multiply = [](const std::string& a, const std::string& b) {
        return R"({"node": "multiply", "a": )" + a + R"(, "b": )" + b + "}";
    };
    const std::string inner = mix(noise(1), noise(2), mask(0));
    const std::string cross = multiply(multiply(mask(0), noise(3)), multiply(mask(1), noise(4)));
    for (const std::string& json :
         {mix(inner, noise(5), mask(1)), cross, mix(cross, inner, multiply(mask(2), inner)),
          mix(noise(6), multiply(cross, inner), multiply(mask(0), mask(2))),
          multiply(mix(mask(0), noise(7), mask(1)), mix(mask(1), noise(8), mask(0)))}) {
        const Twice counts = synthesize_twice(json, Skip::covered_layers);
        EXPECT_GT(counts.skipped(Skip::covered_layers), 0u) << json;
    }
}

TEST(ValueGuards, EveryNodeIsTheSameWithoutThem) {
    for (const GraphCase& one : graph_cases)
        for (const Skip skip : {Skip::covered_layers, Skip::constants, Skip::subtrees})
            synthesize_twice(std::string(one.json), skip);
}

TEST(ValuePrograms, CountWhatConstantsAndEqualSubtreesSpare) {
    const std::string fbm = R"({"node": "fbm", "octaves": 5})";
    const Twice shared = synthesize_twice(
        R"({"node": "multiply", "a": )" + fbm + R"(, "b": )" + fbm + "}", Skip::subtrees);
    EXPECT_EQ(shared.skipped(Skip::subtrees), shared.with.octaves);
    const Twice fixed = synthesize_twice(R"({"node": "add", "a": )" + fbm +
                                             R"(, "b": {"node": "transform", "scale": [0, 0, 0],
                                             "input": )" +
                                             fbm + "}}",
                                         Skip::constants);
    EXPECT_EQ(fixed.skipped(Skip::constants), fixed.with.octaves);
}

/// The arrays of every step at random points lie in the ranges of a box around them.
TEST(ValueRanges, HoldWhatGraphsCompute) {
    std::mt19937 random(1);
    std::size_t known = 0, all = 0;
    for (const GraphCase& one : graph_cases)
        for (const double size : {0.01, 2.0}) {
            const GraphValues values(graph_of(one.json));
            std::array<ValueRange, 3> box;
            GraphValues::Scratch scratch = values.make_scratch();
            for (Register axis = 0; axis < 3; ++axis) {
                const double middle = std::uniform_real_distribution<double>(-2.0, 2.0)(random);
                std::uniform_real_distribution<double> inside(middle - size, middle + size);
                box[axis] = {middle - size, middle + size};
                for (std::size_t j = 0; j < value_batch; ++j) scratch[axis][j] = inside(random);
            }
            values(value_batch, scratch);
            // Arrays are used again: only those of results hold what their last step wrote.
            const std::vector<ValueStep>& steps = values.program().steps();
            const std::vector<ValueRange> ranges =
                value_ranges(steps, values.make_scratch().arrays.size(), box);
            for (const Register r : values.results()) {
                ++all, known += ranges[r].finite();
                for (std::size_t j = 0; j < value_batch; ++j) {
                    ASSERT_GE(scratch[r][j], ranges[r].low) << one.node;
                    ASSERT_LE(scratch[r][j], ranges[r].high) << one.node;
                }
            }
        }
    EXPECT_GT(known, 3 * all / 4);
}

}  // namespace
}  // namespace burl
