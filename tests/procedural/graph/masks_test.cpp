// Masks in graphs: which a graph has and reads, and what it makes of their values.
#include "procedural/graph/masks.h"

#include <gtest/gtest.h>

#include "procedural/graph/values.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

using Json = nlohmann::ordered_json;

const char* const worn = R"({"node": "mix", "a": {"node": "curvature", "radius": 0.25},
    "b": {"node": "transform", "scale": [3, 3, 3], "input": {"node": "add",
        "a": {"node": "curvature", "radius": 0.25, "gives": "concave"},
        "b": {"node": "edge_distance", "angle": 45}}},
    "amount": {"node": "occlusion", "rays": 7, "distance": 0.5}})";

TEST(GraphMasks, AreDistinctByWhatDecidesAboutTheirValues) {
    const double far = std::numeric_limits<double>::infinity();
    const std::vector<GraphMask> expected{{MaskKind::curvature, {0.25}, 0},
                                          {MaskKind::edge_distance, {45, far}, 0},
                                          {MaskKind::occlusion, {7, 0.5}, 0}};
    EXPECT_EQ(graph_masks(graph_of(worn)), expected);
    const auto colors = graph_masks(graph_of(R"({"node": "add", "a": {"node": "split",
        "input": {"node": "vertex_color"}}, "b": {"node": "split", "channel": "alpha",
        "input": {"node": "vertex_color", "alpha": "file"}}})"));
    ASSERT_EQ(colors.size(), 4u);
    for (std::size_t c = 0; c < 4; ++c)
        EXPECT_EQ(colors[c], (GraphMask{MaskKind::vertex_color, {}, c}));
}

TEST(GraphMasks, AreReadByTheChannelsThatDependOnThem) {
    const TextureGraph graph =
        material_from_json(Json::parse(R"({"node": "mesh_uv", "input": {"node": "checkerboard",
            "b": {"node": "thickness"}}})"),
                           Json::parse(R"({"roughness": {"node": "facing"}})"),
                           Json::parse(R"({"unused": {"node": "part"}})"));
    const std::vector<GraphMask> all = graph_masks(graph);
    ASSERT_EQ(all.size(), 5u);
    const std::vector<bool> color = masks_read(graph, GraphOutput::color),
                            planes = masks_read(graph, GraphOutput::planes);
    for (std::size_t m = 0; m < all.size(); ++m) {
        EXPECT_EQ(color[m], all[m].kind != MaskKind::facing && all[m].kind != MaskKind::part);
        EXPECT_EQ(planes[m], all[m].kind != MaskKind::part);
    }
    EXPECT_EQ(first_mask_node(graph, GraphOutput::color), "mesh_uv");
    EXPECT_EQ(first_mask_node(graph_of(R"({"node": "fbm"})"), GraphOutput::planes), "");
}

/// The channels of a graph at points whose masks are given, by both evaluators.
std::vector<Vec3d> colors_of(const TextureGraph& graph, const std::vector<Vec3d>& points,
                             const MaskValues& masks) {
    const GraphValues values(graph);
    GraphValues::Scratch arrays = values.make_scratch();
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) arrays[Register(axis)][i] = points[i][axis];
    for (std::size_t m = 0; m < arrays.masks.size(); ++m)
        for (std::size_t i = 0; i < points.size(); ++i) {
            arrays.masks[m].values[i] = masks[m][i].value;
            for (std::size_t axis = 0; axis < 3 && !arrays.mask_slopes.empty(); ++axis)
                arrays.mask_slopes[m][axis].values[i] = masks[m][i].slope[int(axis)];
        }
    const auto found = values(points.size(), arrays);
    const GraphEvaluator evaluate(graph);
    GraphEvaluator::Scratch scratch = evaluate.make_scratch();
    scratch.masks = masks;
    std::vector<GraphSample> samples(points.size());
    evaluate(points, {}, scratch, samples);
    std::vector<Vec3d> colors;
    for (std::size_t i = 0; i < points.size(); ++i) {
        colors.push_back(samples[i].color());
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c][i], colors[i][int(c)], 1e-6) << i;
    }
    return colors;
}

/// Masks of random numbers from -1 to 1, with random gradients.
MaskValues random_masks(std::size_t masks, std::size_t points) {
    MaskValues values(masks);
    for (std::size_t m = 0; m < masks; ++m) {
        const std::vector<Vec3d> slopes = random_points(points, 2.0, std::uint32_t(m + 100));
        for (const Vec3d& p : random_points(points, 1.0, std::uint32_t(m)))
            values[m].push_back({p.x, slopes[values[m].size()]});
    }
    return values;
}

TEST(GraphMasks, GiveTheTexelsNumbersWhereverTheyStand) {
    const std::vector<Vec3d> points = random_points(200, 3.0, 5);
    const MaskValues m = random_masks(3, points.size());
    const std::vector<Vec3d> colors = colors_of(graph_of(worn), points, m);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double curved = m[0][i].value, amount = m[2][i].value;
        const double worn = std::max(0.0, -curved) + m[1][i].value;
        EXPECT_NEAR(colors[i].x, (1 - amount) * curved + amount * worn, 1e-12);
    }
}

TEST(GraphMasks, SlopesOfProductsFollowTheProductRule) {
    const TextureGraph graph = graph_of(R"({"node": "slope", "direction": [0, 2, 0],
        "input": {"node": "multiply", "a": {"node": "part"},
                  "b": {"node": "coordinate", "direction": [0, 1.5, 0]}}})");
    const std::vector<Vec3d> points = random_points(200, 3.0, 6);
    const MaskValues m = random_masks(1, points.size());
    const std::vector<Vec3d> colors = colors_of(graph, points, m);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(colors[i].x, 3.0 * (m[0][i].value + points[i].y * m[0][i].slope.y), 1e-12);
}

TEST(GraphMasks, BatchesLongerThanOneReadTheirOwnNumbers) {
    const std::vector<Vec3d> points = random_points(700, 3.0, 7);
    const MaskValues m = random_masks(1, points.size());
    const GraphEvaluator evaluate(graph_of(R"({"node": "height_in_box"})"));
    GraphEvaluator::Scratch scratch = evaluate.make_scratch();
    scratch.masks = m;
    std::vector<GraphSample> samples(points.size());
    evaluate(points, {}, scratch, samples);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(samples[i].channels[0].value, m[0][i].value);
        EXPECT_EQ(samples[i].channels[0].slope, m[0][i].slope);
    }
}

TEST(GraphMasks, ColoursOfTheFileAreMultipliedByTheirAlphaWhereItIsWanted) {
    const std::vector<Vec3d> points{Vec3d(0.0)};
    const MaskValues color{{0.5}, {0.25}, {1.0}, {0.5}};
    EXPECT_EQ(colors_of(graph_of(R"({"node": "vertex_color"})"), points, color)[0],
              Vec3d(0.5, 0.25, 1.0));
    const TextureGraph graph = graph_of(R"({"node": "vertex_color", "alpha": "file"})");
    EXPECT_EQ(colors_of(graph, points, color)[0], Vec3d(0.25, 0.125, 0.5));
    EXPECT_FALSE(is_opaque(graph, graph.result));
}

TEST(GraphMasks, LightIsThatOfBothHalvesOfTheSkyAndOfTheSun) {
    const TextureGraph graph = graph_of(R"({"node": "lighting", "sky": "#ff0000",
        "ground": {"node": "coordinate"}, "sun": "#00ff0080", "sky_strength": 3,
        "sun_strength": 0.5})");
    const std::vector<GraphMask> masks = graph_masks(graph);
    ASSERT_EQ(masks.size(), 3u);
    const std::vector<double> numbers{
        128, std::numeric_limits<double>::infinity(), 0, 1, 0, 0.4, 0.8, 0.6, 2, 40};
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(masks[c], (GraphMask{MaskKind::lighting, numbers, c}));
    EXPECT_TRUE(is_opaque(graph, graph.result));
    const std::vector<Vec3d> points = random_points(50, 3.0, 9);
    const MaskValues m = random_masks(3, points.size());
    const std::vector<Vec3d> colors = colors_of(graph, points, m);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double ground = 3.0 * m[1][i].value * points[i].x;
        const double sun = 0.5 * m[2][i].value * 128.0 / 255.0;
        EXPECT_NEAR(colors[i].x, 3.0 * m[0][i].value + ground, 1e-6);
        EXPECT_NEAR(colors[i].y, ground + sun, 1e-6);
        EXPECT_NEAR(colors[i].z, ground, 1e-6);
    }
}

TEST(GraphMasks, TextureCoordinatesAreAPoint) {
    const TextureGraph graph = graph_of(R"({"node": "transform", "translate": [9, 9, 9],
        "input": {"node": "mesh_uv", "input": {"node": "map_uv", "scale": [2, 4],
        "input": {"node": "combine", "red": {"node": "coordinate"},
                  "green": {"node": "coordinate", "direction": [0, 1, 0]},
                  "blue": {"node": "coordinate", "direction": [0, 0, 1]}}}}})");
    const std::vector<Vec3d> points = random_points(50, 3.0, 8);
    const MaskValues m = random_masks(2, points.size());
    const std::vector<Vec3d> colors = colors_of(graph, points, m);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_LT(glm::distance(colors[i], Vec3d(2.0 * m[0][i].value, 4.0 * m[1][i].value, 0.0)),
                  1e-12);
}

}  // namespace
}  // namespace burl
