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

bool overlap(const Vec2d& low, const Vec2d& high, const Vec2d& other_low, const Vec2d& other_high) {
    return low.x < other_high.x && other_low.x < high.x && low.y < other_high.y &&
           other_low.y < high.y;
}

void expect_sound(const NodeGraph& graph, const std::vector<NodeBox>& boxes,
                  const GraphLayout& layout) {
    ASSERT_EQ(layout.places.size(), graph.nodes.size());
    const auto high = [&](std::size_t i) {
        return layout.places[i] + Vec2d(boxes[i].width, boxes[i].height);
    };
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Vec2d& low = layout.places[i];
        EXPECT_TRUE(low.x >= 0.0 && low.y >= 0.0);
        EXPECT_TRUE(high(i).x <= layout.size.x + 1e-9 && high(i).y <= layout.size.y + 1e-9);
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_FALSE(overlap(low, high(i), layout.places[k], high(k))) << i << " " << k;
        for (const GraphInput& input : graph.nodes[i].inputs)
            if (input.from && (!input.by_name || layout.parts.empty())) {
                EXPECT_LT(high(*input.from).x, low.x);
            }
    }
}

TEST(GraphLayout, NodesOfEveryRecipeLieApartAndLeftOfTheirUsers) {
    int pages = 0;
    for (const std::string& name : test::all_recipes()) {
        SCOPED_TRACE(name);
        const NodeGraph graph = node_graph(load_recipe(name));
        const std::vector<NodeBox> boxes = boxes_of(graph);
        const GraphLayout layout = layout_graph(graph, boxes);
        expect_sound(graph, boxes, layout);
        EXPECT_EQ(layout_graph(graph, boxes).places, layout.places);
        pages += layout.parts.empty() ? 0 : 1;
        EXPECT_LT(layout.size.x, 8.0 * layout.size.y + 2000.0);
    }
    EXPECT_GT(pages, 20);
    EXPECT_LT(pages, 80);
}

/// On a page all parts lie apart, and what is used stands before its users.
TEST(GraphLayout, APageIsReadLineByLine) {
    const NodeGraph graph = node_graph(load_recipe("oak"));
    const GraphLayout layout = layout_graph(graph, boxes_of(graph));
    ASSERT_GT(layout.parts.size(), 5u);
    std::size_t nodes = 0;
    std::vector<std::size_t> part_of(graph.nodes.size());
    for (std::size_t i = 0; i < layout.parts.size(); ++i) {
        const GraphPart& part = layout.parts[i];
        nodes += part.nodes.size();
        for (const std::size_t node : part.nodes) part_of[node] = i;
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_FALSE(overlap(part.low, part.high, layout.parts[k].low, layout.parts[k].high));
    }
    EXPECT_EQ(nodes, graph.nodes.size());
    for (std::size_t i = 0; i < graph.nodes.size(); ++i)
        for (const GraphInput& input : graph.nodes[i].inputs)
            if (input.from) {
                EXPECT_LE(part_of[*input.from], part_of[i]);
            }
}

TEST(GraphLayout, AChainIsLevel) {
    const NodeGraph graph = node_graph(test::recipe_with(
        R"("texture": {"node": "color_map", "input": {"node": "abs", "input": {"node": "fbm"}}})"));
    std::vector<NodeBox> boxes(graph.nodes.size(), {100.0, 50.0, 25.0, 0.0, 25.0});
    const GraphLayout layout = layout_graph(graph, boxes, {{20.0, 10.0}, 1e9});
    for (const Vec2d& place : layout.places) EXPECT_NEAR(place.y, 0.0, 1e-9);
    EXPECT_NEAR(layout.size.x, 4 * 100.0 + 3 * 20.0, 1e-9);
    EXPECT_NEAR(layout.size.y, 50.0, 1e-9);
}

/// Two inputs of one node, whose wires would cross in the order of their names.
TEST(GraphLayout, WiresOfOneNodeDoNotCross) {
    const NodeGraph graph = node_graph(test::recipe_with(R"("define": {"a": {"node": "fbm"},
        "b": {"node": "uv"}}, "texture": {"node": "mix", "a": "b", "b": "a"})"));
    const GraphLayout layout = layout_graph(graph, boxes_of(graph));
    EXPECT_LT(layout.places[*graph.find("define.b")].y, layout.places[*graph.find("define.a")].y);
}

}  // namespace
}  // namespace burl
