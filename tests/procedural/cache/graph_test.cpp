// A graph's new colours need nothing below its colour map, and have the bytes of a bake from
// scratch.
#include "procedural/cache/graph.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "procedural/fill/graph.h"
#include "tests/procedural/graph/cases.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

constexpr std::size_t plenty = std::size_t(1) << 30;

TextureGraph mapped(const std::string& input, const std::string& stops,
                    const std::string& wrap = "clamp") {
    return graph_of(fmt::format(
        R"({{"node": "color_map", "wrap": "{}", "stops": {}, "input": {}}})", wrap, stops, input));
}

const std::string wrinkles = R"({"node": "wrinkled", "octaves": 3})";
const std::string grey = R"([[0, "#000000"], [1, "#ffffff"]])";
const std::string three = R"([[0, "#a01020"], [0.3, "#ffe0d0"], [1, "#4080c0"]])";

struct Step {
    TextureGraph graph;
    Affine3 map{};
    std::uint64_t octaves = 0;  ///< evaluated per texel
};

template <class Pixel, class FromScratch>
void follow(std::size_t budget, const std::vector<Step>& steps, const FromScratch& from_scratch) {
    const SolidAtlas solid = SyntheticAtlas{70, 11, 1.0, 0.02, true}.make(3);
    CachedGraph cached(solid, budget);
    Image<Pixel> image;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const auto& [graph, map, octaves] = steps[i];
        ASSERT_TRUE(CachedGraph::splits(graph, {}));
        SynthesisWork work;
        cached.synthesize(graph, map, int(i % 3), image, {{}, &work});
        EXPECT_EQ(image, from_scratch(solid, graph, map)) << i;
        EXPECT_GT(work.texels, 3000u);
        if (budget == plenty) {
            EXPECT_EQ(work.octaves, octaves * work.texels) << i;
            EXPECT_EQ(work.octaves_skipped[unsigned(Skip::kept_terms)],
                      (3 - octaves) * work.texels);
        }
        EXPECT_LE(cached.bytes(), budget);
    }
}

TEST(CachedGraph, LooksColoursUpInTheCachedNumber) {
    const Affine3 twice{2.0 * Mat3d(1.0), Vec3d(0.5, 0.0, -3.0)};
    const std::vector<Step> steps{
        {mapped(wrinkles, grey), {}, 3},
        {mapped(wrinkles, three), {}, 0},
        {mapped(wrinkles, three, "repeat"), {}, 0},
        {mapped(wrinkles, three, "repeat"), twice, 3},
        {mapped(wrinkles, grey), twice, 0},
        {mapped(R"({"node": "wrinkled", "octaves": 3, "seed": 4})", grey), twice, 3}};
    const auto rgb8 = [](const SolidAtlas& solid, const TextureGraph& graph, const Affine3& map) {
        return synthesize_graph<Rgb8>(solid, graph, map, {}, 1);
    };
    follow<Rgb8>(plenty, steps, rgb8);
    follow<Rgb8>(100, steps, rgb8);
    follow<Rgb16>(plenty, steps,
                  [](const SolidAtlas& solid, const TextureGraph& graph, const Affine3& map) {
                      return synthesize_graph<Rgb16>(solid, graph, map, {}, 1);
                  });
    follow<RgbF>(plenty, steps,
                 [](const SolidAtlas& solid, const TextureGraph& graph, const Affine3& map) {
                     return synthesize_graph<RgbF>(solid, graph, map, {}, 1);
                 });
}

TEST(CachedGraph, SplitsOnlyAColourMapOverItsOwnNumberInPointSamples) {
    const TextureGraph graph = mapped(wrinkles, grey);
    EXPECT_TRUE(CachedGraph::splits(graph, {}));
    EXPECT_FALSE(CachedGraph::splits(graph, {FilterKind::exact, 16, false}));
    EXPECT_FALSE(CachedGraph::splits(graph, {FilterKind::supersample, 16, false}));
    EXPECT_FALSE(CachedGraph::splits(graph_of(R"({"node": "stripes"})"), {}));
    EXPECT_FALSE(CachedGraph::splits({}, {}));
}

}  // namespace
}  // namespace burl
