// The noises of graphs' shaders, counted by hand.
#include "procedural/graph/noise_count.h"

#include <gtest/gtest.h>

#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

std::size_t noises(std::string_view json) {
    return graph_noises(graph_of(json), GraphOutput::color);
}

TEST(NoiseCount, CountsOctaves) {
    EXPECT_EQ(noises(R"({"node": "coordinate"})"), 0u);
    EXPECT_EQ(noises(R"({"node": "fbm", "octaves": 5})"), 5u);
    EXPECT_EQ(noises(R"({"node": "simplex_nd", "dimensions": 3, "octaves": 7})"), 28u);
}

TEST(NoiseCount, CountsSharedNoisesOnce) {
    EXPECT_EQ(noises(R"({"node": "add", "a": {"node": "fbm", "octaves": 5},
                         "b": {"node": "fbm", "octaves": 5}})"),
              5u);
    EXPECT_EQ(noises(R"({"node": "add", "a": {"node": "fbm", "octaves": 5},
                         "b": {"node": "fbm", "octaves": 6, "seed": 3}})"),
              11u);
}

TEST(NoiseCount, CountsCellsShapesAndVectors) {
    EXPECT_EQ(noises(R"({"node": "cells"})"), 1u);
    EXPECT_EQ(noises(R"({"node": "scatter"})"), 4u);
    EXPECT_EQ(noises(R"({"node": "curl", "strength": 0.4, "steps": 2, "octaves": 2,
                         "input": {"node": "coordinate"}})"),
              24u);  // two vectors a step, of three noises an octave
}

TEST(NoiseCount, CountsWhatSlopesAreOf) {
    EXPECT_EQ(noises(R"({"node": "slope", "direction": [1, 0, 0],
                         "input": {"node": "fbm", "octaves": 3}})"),
              3u);
}

TEST(NoiseCount, CostsCountOtherStepsByEights) {
    const TextureGraph plain = graph_of(R"({"node": "coordinate"})");
    EXPECT_EQ(graph_cost(plain, GraphOutput::color), 1.0);
    const TextureGraph sum = graph_of(R"({"node": "fbm", "octaves": 5})");
    EXPECT_GE(graph_cost(sum, GraphOutput::color), 5.0);
    EXPECT_LE(graph_cost(sum, GraphOutput::color), 6.0);
}

}  // namespace
}  // namespace burl
