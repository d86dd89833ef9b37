// Atlases filled with graphs that read masks: a texel has its own mask, whatever the filter, the
// precision, the rows and the threads.
#include "procedural/fill/mask_images.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "atlas/base/error.h"
#include "procedural/cache/graph.h"
#include "procedural/fill/graph.h"
#include "procedural/fill/pictures.h"
#include "tests/procedural/graph/cases.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

/// A number in [0, 1) for every texel.
MaskImages noise_images(std::uint32_t size, std::size_t count) {
    MaskImages images;
    std::mt19937 random(11);
    for (std::size_t m = 0; m < count; ++m) {
        Image<float> image(size, size);
        for (std::size_t y = 0; y < size; ++y)
            for (float& value : image.row(y)) value = float(random() % 4096) / 4096.0f;
        images.push_back(std::make_shared<const TexelField>(TexelField{std::move(image)}));
    }
    return images;
}

// The sum of a mask and twice another; the coordinate sees to it that points count, too.
const char* const sum = R"({"node": "warp", "strength": 3, "input": {"node": "add",
    "a": {"node": "occlusion"}, "b": {"node": "add",
    "a": {"node": "multiply", "a": {"node": "curvature"}, "b": 2},
    "b": {"node": "coordinate", "direction": [0, 0, 0], "offset": 0.5}}}})";

TEST(MaskImages, ATexelHasItsOwnNumbers) {
    const SolidAtlas solid = SyntheticAtlas{}.make(3);
    const MaskImages masks = noise_images(solid.size, 2);
    const TextureGraph graph = graph_of(sum);
    for (const Filter filter :
         {Filter{}, Filter{FilterKind::trapezoid}, Filter{FilterKind::supersample, 5}})
        for (const auto precision : {PrecisionKind::float32, PrecisionKind::float64})
            for (const int threads : {1, 3}) {
                const auto image = synthesize_graph<RgbF>(solid, graph, {}, filter, threads,
                                                          precision, {}, {}, masks);
                for (std::size_t y = 0; y < solid.size; ++y)
                    for (const Span& span : solid.row(y))
                        for (std::size_t x = span.x; x < span.x + span.count; ++x)
                            ASSERT_NEAR(
                                image(x, y).g,
                                masks[0]->values(x, y) + 2.0f * masks[1]->values(x, y) + 0.5f,
                                1e-6);
            }
}

TEST(MaskImages, TexelsWithoutASpanHaveNone) {
    const SolidAtlas solid = SyntheticAtlas{}.make(3);
    const auto image =
        synthesize_graph<RgbF>(solid, graph_of(sum), {}, {}, 2, PrecisionKind::float32, {}, {},
                               noise_images(solid.size, 2));
    EXPECT_EQ(image(48, 0).r, 0.5f);  // the fourth block
}

TEST(MaskImages, BandsArePartsOfTheWhole) {
    const SolidAtlas solid = SyntheticAtlas{}.make(4);
    const MaskImages masks = noise_images(solid.size, 2);
    const TextureGraph graph = graph_of(sum);
    for (const Filter filter : {Filter{}, Filter{FilterKind::trapezoid}}) {
        const auto whole = synthesize_graph<RgbF>(solid, graph, {}, filter, 2,
                                                  PrecisionKind::float32, {}, {}, masks);
        const auto band = synthesize_graph<RgbF>(solid, graph, {}, filter, 2,
                                                 PrecisionKind::float32, {}, {17, 40}, masks);
        for (std::size_t y = 17; y < 40; ++y)
            EXPECT_TRUE(std::ranges::equal(band.row(y - 17), whole.row(y)));
    }
}

TEST(MaskImages, ChannelsOfAMaterialReadThem) {
    const SolidAtlas solid = SyntheticAtlas{}.make(5);
    const MaskImages masks = noise_images(solid.size, 1);
    const TextureGraph graph = material_from_json(
        nlohmann::ordered_json::parse(R"({"node": "fbm"})"),
        nlohmann::ordered_json::parse(R"({"roughness": {"node": "edge_distance"}})"), {});
    PicturePlan plan;
    plan.is_color = false;
    for (PictureComponent& component : plan.components)
        component.plane = PlaneLayout(graph).of(Channel::roughness);
    for (const Filter filter : {Filter{}, Filter{FilterKind::trapezoid}}) {
        const auto picture = synthesize_pictures<RgbaF>(solid, graph, {plan}, {}, filter, 2,
                                                        PrecisionKind::float32, {}, masks);
        for (std::size_t y = 0; y < solid.size; ++y)
            for (const Span& span : solid.row(y))
                for (std::size_t x = span.x; x < span.x + span.count; ++x)
                    ASSERT_EQ(picture[0](x, y).b, masks[0]->values(x, y));
    }
    // The base colour alone needs none.
    EXPECT_NO_THROW(synthesize_graph<Rgb8>(solid, graph, {}, {}, 1));
}

TEST(MaskImages, AKeptNumberIsThatOfTheTexel) {
    const SolidAtlas solid = SyntheticAtlas{}.make(6);
    const MaskImages masks = noise_images(solid.size, 1);
    CachedGraph cache(solid, std::size_t(1) << 24);
    for (const char* color : {"#ff0000", "#00ff00"}) {
        const TextureGraph graph = graph_of(fmt::format(
            R"({{"node": "color_map", "stops": [[0, "#000000"], [1, "{}"]],
                "input": {{"node": "facing"}}}})",
            color));
        ASSERT_TRUE(CachedGraph::splits(graph, {}));
        Image<Rgb8> image;
        SynthesisWork work;
        cache.synthesize(graph, {}, 2, image, {{}, &work}, masks);
        EXPECT_EQ(image, synthesize_graph<Rgb8>(solid, graph, {}, {}, 1, PrecisionKind::float32, {},
                                                {}, masks));
    }
}

TEST(MaskImages, AreAskedForInOneSentence) {
    const SolidAtlas solid = SyntheticAtlas{}.make(3);
    const TextureGraph graph = graph_of(sum);
    MaskImages half = noise_images(solid.size, 2);
    half[1] = nullptr;
    for (const MaskImages& masks : {MaskImages(), half, noise_images(32, 2)}) {
        try {
            synthesize_graph<Rgb8>(solid, graph, {}, {}, 1, PrecisionKind::float32, {}, {}, masks);
            ADD_FAILURE();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::unsupported);
            EXPECT_NE(std::string(error.what()).find("\"occlusion\""), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace burl
