// The places of nodes: none overlap, wires lead to the right, and a graph always looks the same.
#include "app/edit/graph_layout.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/edit/edit_cases.h"

namespace burl {
namespace {

std::vector<NodeBox> boxes_of(const NodeGraph& graph) {
    std::vector<NodeBox> boxes;
    for (const GraphNodeView& node : graph.nodes)
        boxes.push_back({150.0, 40.0 + 16.0 * double(node.inputs.size()), 30.0, 16.0, 10.0});
    return boxes;
}

bool overlap(const Vec2d& a, const NodeBox& of_a, const Vec2d& b, const NodeBox& of_b) {
    return a.x < b.x + of_b.width && b.x < a.x + of_a.width && a.y < b.y + of_b.height &&
           b.y < a.y + of_a.height;
}

TEST(GraphLayout, NodesOfEveryRecipeLieApartAndLeftOfTheirUsers) {
    for (const std::string& name : test::all_recipes()) {
        const NodeGraph graph = node_graph(load_recipe(name));
        const std::vector<NodeBox> boxes = boxes_of(graph);
        const GraphLayout layout = layout_graph(graph, boxes, {60.0, 14.0});
        ASSERT_EQ(layout.places.size(), graph.nodes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Vec2d &at = layout.places[i], end = at + Vec2d(boxes[i].width, boxes[i].height);
            EXPECT_TRUE(at.x >= 0.0 && at.y >= 0.0) << name;
            EXPECT_TRUE(end.x <= layout.size.x + 1e-9 && end.y <= layout.size.y + 1e-9) << name;
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_FALSE(overlap(at, boxes[i], layout.places[k], boxes[k])) << name;
            for (const GraphInput& input : graph.nodes[i].inputs)
                if (input.from) {
                    EXPECT_LE(layout.places[*input.from].x + 150.0 + 60.0, at.x + 1e-9);
                }
        }
        EXPECT_EQ(layout_graph(graph, boxes, {60.0, 14.0}).places, layout.places);
    }
}

TEST(GraphLayout, AChainIsLevel) {
    const NodeGraph graph = node_graph(test::recipe_with(
        R"("texture": {"node": "color_map", "input": {"node": "abs", "input": {"node": "fbm"}}})"));
    std::vector<NodeBox> boxes(graph.nodes.size(), {100.0, 50.0, 25.0, 0.0, 25.0});
    const GraphLayout layout = layout_graph(graph, boxes, {20.0, 10.0});
    for (const Vec2d& place : layout.places) EXPECT_NEAR(place.y, 0.0, 1e-9);
    EXPECT_NEAR(layout.size.x, 4 * 100.0 + 3 * 20.0, 1e-9);
    EXPECT_NEAR(layout.size.y, 50.0, 1e-9);
}

/// Two inputs of one node, whose wires would cross in the order of their names.
TEST(GraphLayout, WiresOfOneNodeDoNotCross) {
    const NodeGraph graph = node_graph(test::recipe_with(R"("define": {"a": {"node": "fbm"},
        "b": {"node": "uv"}}, "texture": {"node": "mix", "a": "b", "b": "a"})"));
    const GraphLayout layout = layout_graph(graph, boxes_of(graph), {60.0, 14.0});
    EXPECT_LT(layout.places[*graph.find("define.b")].y, layout.places[*graph.find("define.a")].y);
}

}  // namespace
}  // namespace burl
