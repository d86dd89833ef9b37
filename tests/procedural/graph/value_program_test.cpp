// What value programs work out once, against the same graphs in full.
#include "procedural/graph/value_program.h"

#include <gtest/gtest.h>

#include <string>

#include "procedural/fill/graph.h"
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
Twice synthesize_twice(const std::string& json, Skip skip) {
    const TextureGraph graph = graph_of(json);
    Twice counts;
    for (const std::uint32_t seed : {1u, 2u, 3u, 4u, 5u}) {
        const SolidAtlas solid =
            SyntheticAtlas{64, seed == 1 ? 7u : 64u, 0.0, 0.01, true}.make(seed);
        const auto image = synthesize_graph<RgbF>(solid, graph, identity, {}, 1,
                                                  PrecisionKind::float32, {{}, &counts.with, {}});
        EXPECT_EQ(synthesize_graph<RgbF>(solid, graph, identity, {}, 3, PrecisionKind::float32,
                                         without(skip, &counts.without)),
                  image)
            << json;
    }
    EXPECT_EQ(counts.with.octaves + counts.skipped(skip), counts.without.octaves) << json;
    return counts;
}

TEST(ValuePrograms, ShareAndFixNothingThatShows) {
    for (const GraphCase& one : graph_cases)
        for (const Skip skip : {Skip::constants, Skip::subtrees})
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

}  // namespace
}  // namespace burl
