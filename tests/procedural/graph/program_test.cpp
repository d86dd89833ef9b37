// Programs of texture graphs: the order of steps and registers, and the channels of an evaluator.
#include <gtest/gtest.h>

#include "procedural/graph/program.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

TEST(GraphProgram, StepsReadWhatWasFilledAndFillWhatNobodyDid) {
    for (const GraphCase& graph : graph_cases) {
        const TextureGraph nodes = graph_of(graph.json);
        const GraphProgram program = program_of(nodes);
        Register filled = 3;
        std::uint32_t node = 1;
        for (const GraphStep& step : program.steps) {
            for (const Register r : step.inputs) EXPECT_LT(r, filled) << graph.node;
            for (const Register r : step.outputs) EXPECT_EQ(r, filled++) << graph.node;
            EXPECT_GE(step.node, node) << graph.node;
            EXPECT_LT(step.node, nodes.nodes.size()) << graph.node;
            node = step.node;
        }
        EXPECT_EQ(program.registers, filled) << graph.node;
        EXPECT_EQ(program.results.size(), std::size_t(nodes.nodes[nodes.result].wire))
            << graph.node;
        for (const Register r : program.results) EXPECT_LT(r, filled) << graph.node;
    }
}

TEST(GraphProgram, ChannelsAreUsedAgain) {
    std::string chain = R"({"node": "fbm"})";
    for (int i = 0; i < 40; ++i)
        chain = R"({"node": "abs", "input": {"node": "sin", "input": )" + chain + "}}";
    EXPECT_LE(GraphEvaluator(graph_of(chain)).make_scratch().arrays.size(), 6u);
}

}  // namespace
}  // namespace burl
