#include <cmath>

#include <gtest/gtest.h>

#include "procedural/fill/graph.h"
#include "procedural/graph/values.h"
#include "procedural/numbers/simd_target.h"
#include "tests/procedural/graph/cases.h"
#include "tests/procedural/support/only_target.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

/// Both evaluations of a graph at random points.
struct Difference {
    double max = 0.0, rms = 0.0;  ///< of linear-light channels, over points that do not jump
    int jumps = 0;                ///< points that are more than 1e-3 apart
};

Difference difference_of(const TextureGraph& graph, double reach, std::size_t count) {
    const std::vector<Vec3d> points = random_points(count, reach, 3);
    const GraphEvaluator exact(graph);
    const GraphValues values(graph);
    GraphEvaluator::Scratch exact_scratch = exact.make_scratch();
    GraphValues::Scratch scratch = values.make_scratch();
    std::vector<GraphSample> samples(count);
    exact(points, {}, exact_scratch, samples);
    Difference difference;
    double squares = 0.0;
    for (std::size_t begin = 0; begin < count; begin += value_batch) {
        const std::size_t batch = std::min(value_batch, count - begin);
        for (std::size_t j = 0; j < batch; ++j)
            for (int axis = 0; axis < 3; ++axis)
                scratch[Register(axis)][j] = points[begin + j][axis];
        const auto color = values(batch, scratch);
        for (std::size_t j = 0; j < batch; ++j) {
            const Vec3d at(color[0][j], color[1][j], color[2][j]);
            const Vec3d away = glm::abs(at - samples[begin + j].color());
            const double largest = std::max({away.x, away.y, away.z});
            EXPECT_TRUE(std::isfinite(largest));
            if (largest > 1e-3) ++difference.jumps;
            if (largest > 1e-3) continue;
            difference.max = std::max(difference.max, largest);
            squares += largest * largest;
        }
    }
    difference.rms = std::sqrt(squares / double(count));
    return difference;
}

/// The error that a node may have, where that is more than rounding in float64: noise in float32
/// times what the case's numbers multiply it by, and jumps at values of noise.
struct Allowed {
    std::string_view node;
    double max = 1e-12;
    int jumps = 0;
};

constexpr std::array allowed_errors{Allowed{"add", 5e-7},
                                    Allowed{"multiply", 3e-6},
                                    Allowed{"subtract", 5e-7},
                                    Allowed{"divide", 3e-7},
                                    Allowed{"clamp", 5e-7},
                                    Allowed{"remap", 2e-6},
                                    Allowed{"length", 3e-7},
                                    Allowed{"dot", 1e-6},
                                    Allowed{"combine", 1e-6},
                                    Allowed{"split", 1.5e-7},
                                    Allowed{"hsv", 1e-6},
                                    Allowed{"levels", 5e-7},
                                    Allowed{"min", 5e-7},
                                    Allowed{"max", 5e-7},
                                    Allowed{"abs", 5e-7},
                                    Allowed{"power", 1.5e-6},
                                    Allowed{"sin", 2e-6},
                                    Allowed{"smoothstep", 1e-6},
                                    Allowed{"scale", 5e-7},
                                    Allowed{"mix", 1e-6},
                                    Allowed{"bilerp", 1.5e-5},
                                    Allowed{"color_map", 4e-6},
                                    Allowed{"layer_over", 1e-6},
                                    Allowed{"blend", 1e-6},
                                    Allowed{"checkerboard", 5e-7},
                                    Allowed{"checkerboard_3d", 5e-7},
                                    Allowed{"stripes", 5e-7},
                                    Allowed{"ramp", 5e-7},
                                    Allowed{"rings", 5e-7},
                                    Allowed{"field", 1e-6},
                                    Allowed{"fbm", 7e-7},
                                    Allowed{"wrinkled", 5e-7},
                                    Allowed{"windy", 5e-7},
                                    Allowed{"marble", 1e-5},
                                    Allowed{"bumps", 5e-7, 1},
                                    Allowed{"dots", 5e-7},
                                    Allowed{"transform", 5e-7},
                                    Allowed{"warp", 2e-6},
                                    Allowed{"map_uv", 5e-7},
                                    Allowed{"map_spherical", 5e-7},
                                    Allowed{"map_cylindrical", 5e-7},
                                    Allowed{"map_planar", 5e-7},
                                    Allowed{"tiles", 5e-7},
                                    Allowed{"bricks", 5e-7},
                                    Allowed{"planks", 5e-7},
                                    Allowed{"hexagons", 5e-7},
                                    Allowed{"simplex_nd", 2e-5},
                                    Allowed{"fibre", 3e-6},
                                    Allowed{"curl", 5e-6}};

TEST(GraphFloat32, EveryNodeIsTheFloat64OneUpToItsNoise) {
    for (const GraphCase& graph : graph_cases) {
        Allowed allowed;
        for (const Allowed& known : allowed_errors)
            if (known.node == graph.node) allowed = known;
        const Difference found = difference_of(graph_of(graph.json), 5.0, 8000);
        EXPECT_LT(found.max, allowed.max) << graph.node;
        EXPECT_LT(found.rms, 0.3 * allowed.max) << graph.node;
        EXPECT_LE(found.jumps, allowed.jumps) << graph.node;
    }
}

TEST(GraphFloat32, SlopesAreThoseOfTheEvaluator) {
    const Difference found = difference_of(
        graph_of(R"({"node": "mix", "amount": {"node": "slope", "direction": [1, 2, 3],
            "input": {"node": "transform", "rotate": [10, 20, 30], "input": {"node": "fbm"}}}})"),
        5.0, 2000);
    EXPECT_LT(found.max, 1e-4);
    EXPECT_EQ(found.jumps, 0);
}

TEST(GraphFloat32, FarPointsLoseNoPlace) {
    // 2^20 cells from the origin a float32 coordinate would have 3 bits of fraction.
    const std::string far = R"({"node": "transform", "translate": [1048576, -1048576, 2097152],
        "input": )";
    for (const char* node : {R"({"node": "fbm", "octaves": 4})", R"({"node": "wrinkled"})",
                             R"({"node": "field", "noise": [{"kind": "value", "octaves": 4}]})"})
        EXPECT_LT(difference_of(graph_of(far + node + "}"), 5.0, 4000).max, 1e-6) << node;
    EXPECT_EQ(difference_of(graph_of(far + R"({"node": "checkerboard_3d"}})"), 5.0, 4000).jumps, 0);
}

const char* const busy = R"({"node": "layer_over", "top": {"node": "scale", "a": "#ffffff80",
    "b": {"node": "checkerboard_3d"}},
    "base": {"node": "color_map", "stops": [[0, "#000000"], [0.3, "#ff8040"], [1, "#000000"]],
    "input": {"node": "warp", "input": {"node": "add", "a": {"node": "wrinkled"},
    "b": {"node": "power", "exponent": 1.5, "input": {"node": "map_spherical", "input":
        {"node": "dots"}}}}}}})";

TEST(GraphFloat32, BytesDependNeitherOnThreadsNorOnTheInstructionSet) {
    const SolidAtlas solid = SyntheticAtlas{}.make(3);
    const TextureGraph graph = graph_of(busy);
    for (const Filter filter : {Filter{}, Filter{FilterKind::supersample, 3}}) {
        const auto one = synthesize_graph<Rgb8>(solid, graph, {}, filter, 1);
        const auto precise = synthesize_graph<RgbF>(solid, graph, {}, filter, 1);
        for (const int threads : {2, 3, 0})
            EXPECT_EQ(synthesize_graph<RgbF>(solid, graph, {}, filter, threads), precise);
        on_every_target([&] {
            EXPECT_EQ(synthesize_graph<Rgb8>(solid, graph, {}, filter, 1), one) << simd_level();
            EXPECT_EQ(synthesize_graph<RgbF>(solid, graph, {}, filter, 1), precise) << simd_level();
        });
    }
}

TEST(GraphFloat32, TexturesAreTheFloat64OnesUpToRounding) {
    const Affine3 map{Mat3d(3.0), Vec3d(0.1, 0.2, 0.3)};
    const SolidAtlas solid = SyntheticAtlas{.size = 96, .block = 31}.make(5);
    const TextureGraph graph = graph_of(busy);
    for (const Filter filter : {Filter{}, Filter{FilterKind::supersample, 5}}) {
        using enum PrecisionKind;
        const auto fast = synthesize_graph<RgbF>(solid, graph, map, filter, 2, float32);
        const auto exact = synthesize_graph<RgbF>(solid, graph, map, filter, 2, float64);
        const auto fast16 = synthesize_graph<Rgb16>(solid, graph, map, filter, 2, float32);
        const auto exact16 = synthesize_graph<Rgb16>(solid, graph, map, filter, 2, float64);
        for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
            ASSERT_NEAR(fast.pixels()[i].r, exact.pixels()[i].r, 1e-5);
            ASSERT_NEAR(fast.pixels()[i].g, exact.pixels()[i].g, 1e-5);
            ASSERT_NEAR(fast.pixels()[i].b, exact.pixels()[i].b, 1e-5);
            ASSERT_NEAR(fast16.pixels()[i].r, exact16.pixels()[i].r, 200);  // steep near black
        }
    }
}

/// Both evaluations with gradients, of all nodes, over texels of which some show no fine octaves.
TEST(GraphFloat32, NodesFilterAsInFloat64) {
    const std::vector<Vec3d> points = random_points(1500, 5.0, 2);
    std::vector<Footprint> footprints;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double size = std::exp2(-double(i % 12));
        footprints.push_back({size * Vec3d(0.2, 0.1, 0.0), size * Vec3d(0.0, -0.3, 0.1)});
    }
    for (const GraphCase& graph : graph_cases) {
        const GraphEvaluator exact(graph_of(graph.json));
        const GraphEvaluator quick(graph_of(graph.json), {FilterKind::trapezoid},
                                   PrecisionKind::float32);
        GraphEvaluator::Scratch scratch = exact.make_scratch();
        std::vector<GraphSample> a(points.size()), b(points.size());
        exact(points, footprints, scratch, a);
        quick(points, footprints, scratch, b);
        int values = 0, slopes = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t c = 0; c < std::size_t(a[i].wire); ++c) {
                const Dual &x = a[i].channels[c], &y = b[i].channels[c];
                values += std::abs(x.value - y.value) > 2e-5 * (1.0 + std::abs(x.value));
                const double size = 1.0 + glm::length(x.slope);
                slopes += glm::length(x.slope - y.slope) > 1e-3 * size;
            }
        // Kinks of noise, and edges of a pattern where noise has them.
        EXPECT_LE(values, 4) << graph.node;
        EXPECT_LE(slopes, 24) << graph.node;
    }
}

TEST(GraphFloat32, GradientsDoNotDependOnTheBatch) {
    const std::vector<Vec3d> points = random_points(300, 5.0, 2);
    const std::vector<Footprint> footprints(points.size(), {{0.02, 0.01, 0}, {0, -0.03, 0.01}});
    for (const GraphCase& graph : graph_cases) {
        const GraphEvaluator evaluate(graph_of(graph.json), {FilterKind::trapezoid},
                                      PrecisionKind::float32);
        expect_batches_equal_points(evaluate, points, footprints, graph.node);
    }
}

TEST(GraphFloat32, FilteredTexturesAreTheFloat64OnesUpToRounding) {
    const SolidAtlas solid = SyntheticAtlas{}.make(5);
    const TextureGraph graph = graph_of(busy);
    using enum PrecisionKind;
    for (const bool fade : {false, true}) {
        const Filter filter{FilterKind::trapezoid, 1, fade};
        const auto fast = synthesize_graph<RgbF>(solid, graph, {}, filter, 2, float32);
        const auto exact = synthesize_graph<RgbF>(solid, graph, {}, filter, 2, float64);
        EXPECT_EQ(synthesize_graph<RgbF>(solid, graph, {}, filter, 1, float32), fast);
        int away = 0;
        for (std::size_t i = 0; i < fast.pixels().size(); ++i)
            away += std::abs(fast.pixels()[i].g - exact.pixels()[i].g) > 2e-5f;
        EXPECT_LE(away, 4);
    }
}

TEST(ValueProgram, WorksOutOnceWhatIsEqualAndNothingThatIsNotRead) {
    const auto steps = [](const char* json) {
        return GraphValues(graph_of(json)).program().steps();
    };
    const auto noises = [](const std::vector<ValueStep>& all) {
        return std::count_if(all.begin(), all.end(), [](const ValueStep& step) {
            return std::holds_alternative<NoiseSum>(step.work);
        });
    };
    // The same noise twice; one that only alpha depends on; one with another seed.
    EXPECT_EQ(noises(steps(R"({"node": "add", "a": {"node": "fbm"}, "b": {"node": "fbm"}})")), 1);
    EXPECT_EQ(noises(steps(R"({"node": "mix", "a": "#ff0000", "b": "#ff000080",
                              "amount": {"node": "smoothstep", "input": {"node": "fbm"}}})")),
              1);
    EXPECT_EQ(noises(steps(R"({"node": "add", "a": {"node": "fbm"},
                              "b": {"node": "fbm", "seed": 1}})")),
              2);
    // Affine maps are multiplied out: a checkerboard has one step per axis and cell.
    const auto plain = steps(R"({"node": "transform", "scale": [2, 3, 4], "input":
        {"node": "transform", "translate": [1, 2, 3], "input": {"node": "stripes"}}})");
    EXPECT_EQ(plain.size(), 2u);  // one coordinate, its cell's parity
}

TEST(ValueProgram, ArraysAreUsedAgain) {
    std::string chain = R"({"node": "fbm"})";
    for (int i = 0; i < 40; ++i)
        chain = R"({"node": "abs", "input": {"node": "sin", "input": )" + chain + "}}";
    const GraphValues values(graph_of(chain));
    EXPECT_EQ(values.program().steps().size(), 81u);
    EXPECT_LE(values.make_scratch().arrays.size(), 6u);
}

}  // namespace
}  // namespace burl
