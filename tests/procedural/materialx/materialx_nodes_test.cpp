// MaterialX's functions: values that shaders of its own generator gave at the same points
// (references.json, written by tests/peers/materialx_points.py), gradients against differences,
// both evaluations against each other, and what has no reference: results that are not defined.
#include <fstream>
#include <limits>
#include <set>

#include "procedural/glsl/graph.h"
#include "procedural/graph/table.h"
#include "procedural/materialx/call.h"
#include "tests/paths.h"
#include "tests/procedural/graph/point_functions.h"
#include "tests/procedural/materialx/cases.h"

namespace burl {
namespace {

/// Adds the words of `operation` in a node's JSON to `all`, and those of its inputs.
void add_operations(const nlohmann::ordered_json& node, std::set<std::string>& all) {
    if (!node.is_object()) return;
    if (node.contains("operation"))
        all.insert(node["node"].get<std::string>() + " " + node["operation"].get<std::string>());
    for (const auto& value : node) add_operations(value, all);
}

nlohmann::ordered_json references() {
    std::ifstream file(test::source_folder() + "/tests/procedural/materialx/references.json");
    return nlohmann::ordered_json::parse(file);
}

/// The largest difference that a case may have seen at 10,000 points, relative to values above 1:
/// mostly the reference's float32, and its sines and arc cosines, which a software renderer gives.
double allowed(const std::string& name) {
    constexpr std::pair<const char*, double> bounds[]{
        {"noise", 1e-5},          {"fractal", 4e-5},        {"cellnoise", 1e-7},
        {"worley", 3e-7},         {"math sin", 4e-4},       {"math cos", 4e-4},
        {"math tan", 5e-4},       {"math acos", 1e-4},      {"math dodge", 1e-3},
        {"vector sin", 4e-4},     {"vector cos", 4e-4},     {"vector tan", 5e-4},
        {"vector acos", 1e-4},    {"vector refract", 1e-5}, {"vector rotate3d", 4e-4},
        {"vector hsvtorgb", 2e-5}};
    for (const auto& [begin, bound] : bounds)
        if (name.starts_with(begin)) return bound;
    return 1e-6;
}

TEST(MaterialXNodes, AreTheReferencesAtItsPoints) {
    const auto table = references();
    const auto points = table["points"].get<std::vector<std::array<double, 3>>>();
    ASSERT_EQ(points.size(), 12u);
    ASSERT_EQ(table["cases"].size(), 145u);
    for (const auto& one : table["cases"]) {
        const std::string name = one["name"];
        EXPECT_LT(one["largest"].get<double>(), allowed(name)) << name;
        const TextureGraph graph = graph_of(one["texture"].dump());
        ASSERT_EQ(one["values"].size(), points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto theirs = one["values"][i].get<std::vector<double>>();
            const GraphSample sample = sample_at(graph, {points[i][0], points[i][1], points[i][2]});
            for (std::size_t c = 0; c < theirs.size(); ++c) {
                const double size = std::max(1.0, std::abs(theirs[c]));
                EXPECT_NEAR(sample.channels[c].value, theirs[c], allowed(name) * size)
                    << name << " " << i;
            }
        }
    }
}

TEST(MaterialXNodes, ReferencesAreOfAllOperations) {
    std::set<std::string> tried, all;
    const auto table = references();
    for (const auto& one : table["cases"]) add_operations(one["texture"], tried);
    for (const NodeType& type : graph_table())
        if (type.name.starts_with("materialx_") && type.parameters()[0].path == "operation")
            for (const std::string_view word : split_choices(type.parameters()[0].choices))
                all.insert(std::string(type.name) + " " + std::string(word));
    EXPECT_EQ(tried, all);
}

TEST(MaterialXNodes, CasesAreOfAllNodes) {
    std::set<std::string_view> cases, types;
    for (const GraphCase& one : materialx_cases) cases.insert(one.node);
    for (const NodeType& type : graph_table())
        if (type.name.starts_with("materialx_")) types.insert(type.name);
    EXPECT_EQ(cases, types);
}

TEST(MaterialXNodes, GradientsAgreeWithDifferences) {
    expect_gradients_of_differences(materialx_cases);
}

TEST(MaterialXNodes, ValuesAloneAreThoseOfTheEvaluator) {
    expect_values_of_the_evaluator(materialx_cases);
}

TEST(MaterialXNodes, GiveZeroWhereTheyAreNotDefined) {
    const auto value = [](const std::string& rest) {
        const std::string json = R"({"node": "materialx_math", "operation": ")" + rest + "}";
        return sample_at(graph_of(json), Vec3d(0.0)).channels[0].value;
    };
    for (const char* undefined :
         {R"(divide", "a": 3, "b": 0)", R"(modulo", "a": 3, "b": 0)", R"(sqrt", "a": -1)",
          R"(ln", "a": 0)", R"(ln", "a": -2)", R"(power", "a": -2, "b": 0.5)",
          R"(power", "a": 0, "b": -1)", R"(asin", "a": 1.5)", R"(acos", "a": -1.5)",
          R"(burn", "a": 0.4, "b": 0, "c": 0.5)", R"(dodge", "a": 0.4, "b": 1, "c": 0.5)"})
        EXPECT_EQ(value(undefined), 0.0) << undefined;
    EXPECT_EQ(value(R"(power", "a": -2, "b": 3)"), -8.0);
    EXPECT_EQ(value(R"(smoothstep", "a": 1, "b": 1, "c": 1)"), 1.0);
}

TEST(MaterialXNodes, AreZeroWhereTheLatticeEnds) {
    const double huge = std::numeric_limits<double>::infinity();
    for (const double far : {0x1p31, -0x1p200, huge, std::nan("")})
        for (int dimensions : {2, 3}) {
            const std::array<double, 6> in{far, 0.3, 0.4, 2.0, 2.0, 0.5};
            for (const auto function : {MaterialXFunction::noise, MaterialXFunction::fractal,
                                        MaterialXFunction::cell_noise})
                EXPECT_EQ(materialx_value<double>({function, 0, dimensions, 3}, in),
                          (std::array<double, 3>{}));
            for (const double x :
                 materialx_value<double>({MaterialXFunction::worley, 0, dimensions, 3}, in))
                EXPECT_FALSE(x < 0.0);
        }
}

TEST(MaterialXNodes, HaveNoShaderAndSaySo) {
    EXPECT_EQ(no_graph_shader(graph_of(R"({"node": "materialx_noise"})")),
              "its node \"materialx_noise\" is evaluated on the host alone");
}

}  // namespace
}  // namespace burl
