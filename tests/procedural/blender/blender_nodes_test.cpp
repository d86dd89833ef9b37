// Blender's functions: values that Blender itself gave at the same points (references.json, written
// by tests/peers/blender_points.py), gradients against differences, and both evaluations against
// each other.
#include <fstream>
#include <set>

#include "procedural/glsl/graph.h"
#include "procedural/graph/table.h"
#include "tests/paths.h"
#include "tests/procedural/blender/cases.h"
#include "tests/procedural/graph/point_functions.h"

namespace burl {
namespace {

TEST(BlenderNodes, AreBlendersAtItsPoints) {
    std::ifstream file(test::source_folder() + "/tests/procedural/blender/references.json");
    const auto references = nlohmann::ordered_json::parse(file);
    const auto points = references["points"].get<std::vector<std::array<double, 3>>>();
    ASSERT_EQ(references["cases"].size(), 186u);
    int far = 0;
    for (const auto& one : references["cases"]) {
        const TextureGraph graph = graph_of(one["texture"].dump());
        const auto values = one["values"].get<std::vector<std::array<double, 3>>>();
        ASSERT_EQ(values.size(), points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec3d theirs{values[i][0], values[i][1], values[i][2]};
            const Vec3d ours =
                values_of(sample_at(graph, {points[i][0], points[i][1], points[i][2]}));
            const double size = std::max({1.0, std::abs(theirs.x), std::abs(theirs.y)});
            far += glm::length(ours - theirs) > 1e-4 * size;
            EXPECT_LT(glm::length(ours - theirs), 1e-3 * size) << one["name"] << " " << i;
        }
    }
    EXPECT_LE(far, 10);
}

TEST(BlenderNodes, CasesAreOfAllNodes) {
    std::set<std::string_view> cases, types;
    for (const GraphCase& one : blender_cases) cases.insert(one.node);
    for (const NodeType& type : graph_table())
        if (type.name.starts_with("blender_")) types.insert(type.name);
    EXPECT_EQ(cases, types);
}

TEST(BlenderNodes, GradientsAgreeWithDifferences) {
    expect_gradients_of_differences(blender_cases);
}

TEST(BlenderNodes, ValuesAloneAreThoseOfTheEvaluator) {
    expect_values_of_the_evaluator(blender_cases);
}

TEST(BlenderNodes, HaveNoShaderAndSaySo) {
    EXPECT_EQ(no_graph_shader(graph_of(blender_cases[0].json)),
              "its node \"blender_noise\" is evaluated on the host alone");
    EXPECT_EQ(no_graph_shader(graph_of(R"({"node": "point"})")), "");
}

}  // namespace
}  // namespace burl
