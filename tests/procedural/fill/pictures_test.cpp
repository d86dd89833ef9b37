#include "procedural/fill/pictures.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "atlas/base/json.h"
#include "procedural/color/srgb.h"
#include "procedural/fill/graph.h"
#include "procedural/graph/evaluator.h"
#include "procedural/graph/json.h"
#include "procedural/graph/values.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

using Json = nlohmann::ordered_json;

/// A material that shares its grain.
TextureGraph oak() {
    const Json define = Json::parse(R"({
        "grain": {"node": "add", "a": {"node": "rings", "spacing": 0.3, "profile": "ramp"},
                  "b": {"node": "fbm", "octaves": 3}}})");
    const Json texture = Json::parse(R"({"node": "mix", "a": "#c9a06a", "b": "#6e472280",
        "amount": {"node": "clamp", "input": "grain"}})");
    const Json material = Json::parse(R"({
        "opacity": {"node": "remap", "input": "grain", "in_low": 0, "in_high": 1, "out_low": 0.5,
                    "out_high": 1, "clamp": "on"},
        "roughness": {"node": "mix", "a": 0.3, "b": 0.8, "amount": "grain"},
        "metallic": 0.25, "emissive": {"node": "scale", "a": "#ff8000", "b": "grain"}})");
    return material_from_json(texture, material, define);
}

std::vector<PicturePlan> plans_of(const TextureGraph& graph) {
    const PlaneLayout planes(graph);
    PicturePlan color, data;
    for (std::size_t c = 0; c < 3; ++c) {
        color.components[c].plane = c;
        data.components[c].plane = *planes.of(Channel::emissive) + c;
    }
    color.components[3] = {1.0, planes.alpha(), planes.of(Channel::opacity)};
    color.alpha = planes.alpha();
    data.components[3] = {-1.0, planes.of(Channel::roughness), {}, 1.0};
    data.is_color = false;
    return {color, data};
}

TEST(Pictures, AnOpaqueColourHasTheBytesOfATextureAlone) {
    const SolidAtlas solid = SyntheticAtlas{}.make(3);
    const TextureGraph graph = graph_from_json(Json::parse(
        R"({"node": "mix", "a": "#c9a06a", "b": "#6e4722", "amount": {"node": "fbm"}})"));
    PicturePlan plan;
    for (std::size_t c = 0; c < 3; ++c) plan.components[c].plane = c;
    for (const Filter filter :
         {Filter{}, Filter{FilterKind::trapezoid}, Filter{FilterKind::supersample, 5}})
        for (const auto precision : {PrecisionKind::float32, PrecisionKind::float64}) {
            const auto alone = synthesize_graph<Rgb8>(solid, graph, {}, filter, 2, precision);
            const auto pictures =
                synthesize_pictures<Rgba8>(solid, graph, {plan}, {}, filter, 2, precision);
            for (std::size_t y = 0; y < solid.size; ++y)
                for (std::size_t x = 0; x < solid.size; ++x) {
                    const Rgba8& p = pictures[0](x, y);
                    ASSERT_EQ((Rgb8{p.r, p.g, p.b}), alone(x, y)) << x << " " << y;
                    ASSERT_EQ(p.a, 255);
                }
        }
}

TEST(Pictures, ChannelsAreThoseOfTheGraphAtTheTexelsPoint) {
    const SolidAtlas solid = SyntheticAtlas{}.make(5);
    const TextureGraph graph = oak();
    const Affine3 map{Mat3d(3.0), Vec3d(0.1, 0.2, 0.3)};
    const auto floats = synthesize_pictures<RgbaF>(solid, graph, plans_of(graph), map, {}, 2,
                                                   PrecisionKind::float64);
    const auto codes = synthesize_pictures<Rgba8>(solid, graph, plans_of(graph), map, {}, 2,
                                                  PrecisionKind::float64);
    // One graph per channel, each evaluated by itself.
    TextureGraph opacity = graph, roughness = graph, emissive = graph;
    opacity.result = graph.channels[0].node;
    roughness.result = graph.channels[1].node;
    emissive.result = graph.channels[2].node;
    const GraphEvaluator color_at(graph), opacity_at(opacity), roughness_at(roughness),
        emissive_at(emissive);
    const auto within = [](double number) { return std::clamp(number, 0.0, 1.0); };
    int texels = 0;
    for (std::size_t y = 0; y < solid.size; y += 3)
        for (const Span& span : solid.row(y)) {
            const Vec3d p = map(solid.maps[span.map](span.x, std::int64_t(y)));
            const auto color = color_at(p).channels;
            const double share = opacity_at(p).channels[0].value;
            const RgbaF& found = floats[0](span.x, y);
            EXPECT_FLOAT_EQ(found.g, float(color[1].value * share));
            EXPECT_FLOAT_EQ(found.a, float(color[3].value * share));
            const double straight = srgb_encode(color[1].value / color[3].value);
            EXPECT_NEAR(codes[0](span.x, y).g, 255.0 * straight, 0.51);
            EXPECT_NEAR(codes[0](span.x, y).a, 255.0 * color[3].value * share, 0.51);
            EXPECT_FLOAT_EQ(floats[1](span.x, y).r, float(within(emissive_at(p).color().x)));
            EXPECT_NEAR(floats[1](span.x, y).a, within(1.0 - roughness_at(p).channels[0].value),
                        1e-6);
            ++texels;
        }
    EXPECT_GT(texels, 20);
}

TEST(Pictures, NumbersBeyondOneAreOneInFloatsToo) {
    const SolidAtlas solid = SyntheticAtlas{}.make(3);
    const Json material = Json::parse(R"({"opacity": {"node": "add", "a": 2, "b": 3},
        "roughness": {"node": "add", "a": -2, "b": 1}, "emissive": {"node": "add", "a": 0, "b": 4}})");
    const TextureGraph graph = material_from_json(
        Json::parse(R"({"node": "scale", "a": "#ffffff80", "b": 1})"), material, {});
    const double alpha = 128.0 / 255;
    const auto floats = synthesize_pictures<RgbaF>(solid, graph, plans_of(graph), {}, {}, 1);
    for (const Span& span : solid.row(solid.size / 2)) {
        const RgbaF &color = floats[0](span.x, solid.size / 2),
                    &data = floats[1](span.x, solid.size / 2);
        EXPECT_FLOAT_EQ(color.r, float(alpha));
        EXPECT_FLOAT_EQ(color.a, float(alpha));
        EXPECT_EQ(data.r, 1.0f);
        EXPECT_EQ(data.a, 1.0f);  // one less the roughness of 0
    }
}

TEST(Pictures, BytesDoNotDependOnThreads) {
    const SolidAtlas solid = SyntheticAtlas{}.make(3);
    const TextureGraph graph = oak();
    for (const Filter filter :
         {Filter{}, Filter{FilterKind::trapezoid}, Filter{FilterKind::supersample, 5}}) {
        const auto one = synthesize_pictures<Rgba16>(solid, graph, plans_of(graph), {}, filter, 1);
        for (const int threads : {2, 3, 0})
            EXPECT_EQ(
                synthesize_pictures<Rgba16>(solid, graph, plans_of(graph), {}, filter, threads),
                one);
    }
}

TEST(Pictures, BandsAreRowsOfTheWhole) {
    const SolidAtlas solid = SyntheticAtlas{}.make(3);
    const TextureGraph graph = oak();
    const auto plans = plans_of(graph);
    for (const Filter filter :
         {Filter{}, Filter{FilterKind::trapezoid}, Filter{FilterKind::supersample, 5}}) {
        const auto whole = synthesize_pictures<Rgba16>(solid, graph, plans, {}, filter, 2);
        SynthesisWork work, whole_work;
        for (std::size_t first = 0; first < solid.size; first += 7) {
            const auto rows = synthesize_pictures<Rgba16>(solid, graph, plans, {}, filter, 2,
                                                          PrecisionKind::float32, {.work = &work},
                                                          {}, {first, first + 7});
            ASSERT_EQ(rows.size(), whole.size());
            for (std::size_t i = 0; i < rows.size(); ++i) {
                ASSERT_EQ(rows[i].height(), std::min<std::size_t>(7, solid.size - first));
                for (std::size_t y = 0; y < rows[i].height(); ++y)
                    ASSERT_TRUE(std::ranges::equal(rows[i].row(y), whole[i].row(first + y)));
            }
        }
        synthesize_pictures<Rgba16>(solid, graph, plans, {}, filter, 2, PrecisionKind::float32,
                                    {.work = &whole_work});
        EXPECT_EQ(work.texels, whole_work.texels);
        EXPECT_EQ(work.octaves, whole_work.octaves);
    }
}

TEST(Pictures, NamesAreEvaluatedOnce) {
    const TextureGraph graph = oak();
    TextureGraph color = graph;
    color.channels.clear();
    EXPECT_EQ(GraphValues(graph, nullptr, GraphOutput::planes).program().octaves(),
              GraphValues(color).program().octaves());
    std::size_t sums = 0;
    for (const GraphStep& step : program_of(graph).steps)
        sums += std::holds_alternative<OctaveSum>(step.work) ? 1 : 0;
    EXPECT_EQ(sums, 1u);
}

}  // namespace
}  // namespace burl
