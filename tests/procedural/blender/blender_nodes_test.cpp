// Blender's functions: values that Blender itself gave at the same points (references.json, written
// by tests/peers/blender_points.py), gradients against differences, and both evaluations against
// each other.
#include <fstream>
#include <set>

#include "procedural/glsl/graph.h"
#include "procedural/graph/table.h"
#include "procedural/graph/values.h"
#include "tests/paths.h"
#include "tests/procedural/blender/cases.h"

namespace burl {
namespace {

GraphSample sample_at(const TextureGraph& graph, const Vec3d& point) {
    const GraphEvaluator evaluate(graph);
    GraphEvaluator::Scratch scratch = evaluate.make_scratch();
    GraphSample sample;
    evaluate({&point, 1}, {}, scratch, {&sample, 1});
    return sample;
}

/// Three numbers of a sample: a number counts three times.
Vec3d values_of(const GraphSample& sample) {
    const auto& c = sample.channels;
    if (sample.wire == Wire::number) return Vec3d(c[0].value);
    return {c[0].value, c[1].value, c[2].value};
}

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

/// The gradient of channel c by differences, and whether two widths agree on it.
bool slope_near(const TextureGraph& graph, const Vec3d& p, std::size_t c, Vec3d& slope) {
    Vec3d coarse;
    for (int axis = 0; axis < 3; ++axis) {
        const auto by = [&](double h) {
            Vec3d a = p, b = p;
            a[axis] -= h, b[axis] += h;
            const double high = sample_at(graph, b).channels[c].value;
            return (high - sample_at(graph, a).channels[c].value) / (2.0 * h);
        };
        coarse[axis] = by(2e-5), slope[axis] = by(1e-5);
    }
    return glm::length(coarse - slope) < 2e-6 * (1.0 + glm::length(slope));
}

TEST(BlenderNodes, GradientsAgreeWithDifferences) {
    for (const GraphCase& one : blender_cases) {
        const TextureGraph graph = graph_of(one.json);
        int used = 0;
        for (const Vec3d& p : random_points(25, 3.0, 7)) {
            const GraphSample sample = sample_at(graph, p);
            for (std::size_t c = 0; c < (sample.wire == Wire::number ? 1 : 3); ++c) {
                Vec3d slope;
                if (!slope_near(graph, p, c, slope)) continue;
                ++used;
                EXPECT_LT(glm::length(sample.channels[c].slope - slope),
                          1e-5 * (1.0 + glm::length(slope)))
                    << one.node;
            }
        }
        EXPECT_GT(used, 15) << one.node;
    }
}

TEST(BlenderNodes, ValuesAloneAreThoseOfTheEvaluator) {
    for (const GraphCase& one : blender_cases) {
        const TextureGraph graph = graph_of(one.json);
        const GraphValues values(graph);
        auto scratch = values.program().make_scratch();
        for (const Vec3d& p : random_points(40, 3.0, 3)) {
            const Vec3d exact = values_of(sample_at(graph, p));
            EXPECT_LT(glm::length(values(p, scratch) - exact), 1e-5 * (1.0 + glm::length(exact)))
                << one.node;
        }
    }
}

TEST(BlenderNodes, HaveNoShaderAndSaySo) {
    EXPECT_EQ(no_graph_shader(graph_of(blender_cases[0].json)),
              "its node \"blender_noise\" is evaluated on the host alone");
    EXPECT_EQ(no_graph_shader(graph_of(R"({"node": "point"})")), "");
}

}  // namespace
}  // namespace burl
