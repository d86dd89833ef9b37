// Every node's gradient against differences of its values.
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "procedural/graph/table.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

/// Evaluates a graph at points on the six sides of one.
class Differences {
  public:
    Differences(const TextureGraph& graph, const Footprint& footprint)
        : evaluate_(graph), scratch_(evaluate_.make_scratch()), footprint_(footprint) {}

    GraphSample at(const Vec3d& p) {
        GraphSample sample;
        evaluate_({&p, 1}, {&footprint_, 1}, scratch_, {&sample, 1});
        return sample;
    }

    /// Fourth-order central differences of every channel.
    std::array<Vec3d, 4> gradient(const Vec3d& p, double h) {
        std::array<Vec3d, 4> result{};
        for (int axis = 0; axis < 3; ++axis) {
            Vec3d step(0.0);
            step[axis] = h;
            const GraphSample a = at(p - 2.0 * step), b = at(p - step), c = at(p + step),
                              d = at(p + 2.0 * step);
            for (std::size_t k = 0; k < 4; ++k)
                result[k][axis] = (a.channels[k].value - 8.0 * b.channels[k].value +
                                   8.0 * c.channels[k].value - d.channels[k].value) /
                                  (12.0 * h);
        }
        return result;
    }

  private:
    GraphEvaluator evaluate_;
    GraphEvaluator::Scratch scratch_;
    Footprint footprint_;
};

double distance(const std::array<Vec3d, 4>& a, const std::array<Vec3d, 4>& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k) sum += glm::dot(a[k] - b[k], a[k] - b[k]);
    return std::sqrt(sum);
}

/// Largest |gradient - differences| / (1 + |differences|) where the differences themselves have
/// settled, which they have not across a jump or a kink.
double worst_error(const std::string& json, const Footprint& footprint) {
    Differences differences(graph_of(json), footprint);
    double worst = 0.0;
    int used = 0;
    const std::vector<Vec3d> points = random_points(60, 3.0, 7);
    for (const Vec3d& p : points) {
        const auto coarse = differences.gradient(p, 2e-5), fine = differences.gradient(p, 1e-5);
        const double size = 1.0 + distance(fine, {});
        if (distance(coarse, fine) > 2e-6 * size) continue;
        ++used;
        const GraphSample sample = differences.at(p);
        std::array<Vec3d, 4> gradient{};
        for (std::size_t k = 0; k < 4; ++k) gradient[k] = sample.channels[k].slope;
        worst = std::max(worst, distance(gradient, fine) / size);
    }
    EXPECT_GT(used, 40) << json;
    return worst;
}

TEST(GraphGradient, CasesCoverTheTable) {
    std::set<std::string_view> cases, types;
    for (const GraphCase& graph : graph_cases) cases.insert(graph.node);
    for (const NodeType& type : graph_table())  // masks have no value at a point
        if (type.mask.components == 0 && !on_the_host_alone(type)) types.insert(type.name);
    EXPECT_EQ(cases, types);
}

TEST(GraphGradient, AgreesWithDifferences) {
    for (const GraphCase& graph : graph_cases)
        EXPECT_LT(worst_error(std::string(graph.json), {}), 1e-5) << graph.node;
}

TEST(GraphGradient, OfEveryBlendModeAgreesWithDifferences) {
    for (const std::string mode :
         {"normal", "multiply", "screen", "overlay", "add", "darken", "lighten", "soft_light"})
        EXPECT_LT(worst_error(R"({"node": "blend", "mode": ")" + mode + R"(",
            "top": {"node": "remap", "in_low": -1, "input": {"node": "fbm", "octaves": 2}},
            "base": {"node": "remap", "in_low": -1, "input": {"node": "fbm", "seed": 9}},
            "mask": {"node": "sine", "period": 3}})",
                              {}),
                  1e-5)
            << mode;
}

TEST(GraphGradient, AgreesWithDifferencesOfMeans) {
    // Where the footprint is the same everywhere, the mean over it has an exact gradient too.
    const Footprint footprint{{0.21, 0.04, -0.03}, {0.02, -0.17, 0.09}};
    for (const char* json :
         {R"({"node": "checkerboard", "a": 0.2, "b": 0.9})",
          R"({"node": "checkerboard_3d", "a": 0.2, "b": "#ff8000"})",
          R"({"node": "stripes", "direction": [1, 2, -1]})", R"({"node": "uv"})",
          R"({"node": "ramp", "direction": [1, 2, -1]})",
          R"({"node": "sine", "direction": [1, 2, -1]})", R"({"node": "fbm", "octaves": 4})",
          R"({"node": "image", "file": "image.png"})",
          R"({"node": "image", "file": "image.png", "lookup": "ewa"})",
          R"({"node": "wrinkled", "octaves": 4})", R"({"node": "windy", "octaves": 4})",
          R"({"node": "marble", "octaves": 4, "spline": "bspline"})"})
        EXPECT_LT(worst_error(json, footprint), 1e-5) << json;
}

/// The coordinate numbered `axis` that a mapping makes.
std::string mapped(const std::string& mapping, int axis) {
    const char* direction[] = {"[1,0,0]", "[0,1,0]", "[0,0,1]"};
    return "{" + mapping + R"(, "input": {"node": "coordinate", "direction": )" + direction[axis] +
           "}}";
}

TEST(GraphSeams, SlopesGoOnAcrossThem) {
    // Just below and above the half-plane where the turn jumps.
    struct Seam {
        const char* mapping;
        int axis;
        double side;  // of x
        double below, above;
    };
    for (const Seam& seam : {Seam{R"("node": "map_spherical")", 1, 0.8, 1.0, 0.0},
                             Seam{R"("node": "map_cylindrical")", 0, -0.8, 0.0, 1.0}}) {
        const TextureGraph graph = graph_of(mapped(seam.mapping, seam.axis));
        for (const double z : {-2.0, 0.3, 5.0}) {
            const Dual below = sample_of(graph, {seam.side, -1e-9, z});
            const Dual above = sample_of(graph, {seam.side, 1e-9, z});
            EXPECT_NEAR(below.value, seam.below, 1e-8) << seam.mapping;
            EXPECT_NEAR(above.value, seam.above, 1e-8) << seam.mapping;
            const double turn = 0.5 / std::numbers::pi / seam.side;
            EXPECT_NEAR(below.slope.y, turn, 1e-8) << seam.mapping;
            EXPECT_NEAR(above.slope.y, turn, 1e-8) << seam.mapping;
            EXPECT_NEAR(below.slope.x, 0.0, 1e-8) << seam.mapping;
        }
    }
}

TEST(GraphSeams, UvHasNone) {
    const TextureGraph graph = graph_of(mapped(R"("node": "map_uv", "scale": [3, 5])", 0));
    EXPECT_EQ(sample_of(graph, {1.0 - 1e-12, 0, 0}).slope, Vec3d(3, 0, 0));
    EXPECT_EQ(sample_of(graph, {1.0 + 1e-12, 0, 0}).slope, Vec3d(3, 0, 0));
}

TEST(GraphSeams, PolesAndCentreAreFinite) {
    for (const GraphCase& graph : graph_cases)
        for (const Vec3d& p : {Vec3d(0.0), Vec3d(0, 0, 1), Vec3d(0, 0, -2), Vec3d(-1, 0, 0),
                               Vec3d(1, 0, 0), Vec3d(1e8, -1e8, 3e7)}) {
            const GraphSample sample = GraphEvaluator(graph_of(graph.json))(p);
            for (const Dual& x : sample.channels) {
                EXPECT_TRUE(std::isfinite(x.value)) << graph.node;
                EXPECT_TRUE(std::isfinite(glm::dot(x.slope, Vec3d(1.0)))) << graph.node;
            }
        }
}

}  // namespace
}  // namespace burl
