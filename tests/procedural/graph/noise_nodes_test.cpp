// The nodes simplex_nd, fibre and curl against their definitions, and over footprints.
#include <cmath>

#include <gtest/gtest.h>

#include "procedural/noise/noise.h"
#include "procedural/noise/simplex_curl.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

TEST(SimplexNode, SumsOctavesOfTheNoise) {
    const TextureGraph graph = graph_of(R"({"node": "simplex_nd", "dimensions": 8,
        "signal": "value", "seed": 4, "octaves": 3, "lacunarity": 1.7, "gain": 0.6, "x4": 0.4,
        "x5": {"node": "coordinate", "direction": [0, 3, 0]}, "x6": -7.5, "x7": 2, "x8": 11})");
    const SimplexNoise noise{8, SimplexSignal::value};
    for (const Vec3d& p : random_points(100, 5.0, 1)) {
        double sum = 0.0;
        for (int k = 0; k < 3; ++k) {
            const double f = std::pow(1.7, k);
            sum +=
                std::pow(0.6, k) * noise.amplitude() *
                sample_simplex<double>(noise, 4u + std::uint32_t(k),
                                       {f * p.x, f * p.y, f * p.z, 0.4, 3.0 * p.y, -7.5, 2.0, 11.0})
                    .value;
        }
        EXPECT_NEAR(sample_of(graph, p).value, sum, 1e-12);
    }
}

TEST(SimplexNode, LeavesOutCoordinatesBeyondItsDimensions) {
    const TextureGraph flat = graph_of(R"({"node": "simplex_nd", "dimensions": 4, "x5": 3.3})");
    const TextureGraph same = graph_of(R"({"node": "simplex_nd", "dimensions": 4})");
    const TextureGraph deep =
        graph_of(R"({"node": "simplex_nd", "dimensions": 4, "x4": {"node": "coordinate"}})");
    double apart = 0.0;
    for (const Vec3d& p : random_points(50, 5.0, 2)) {
        EXPECT_EQ(sample_of(flat, p).value, sample_of(same, p).value);
        apart = std::max(apart, std::abs(sample_of(deep, p).value - sample_of(same, p).value));
    }
    EXPECT_GT(apart, 0.2);
}

TEST(SimplexNode, FadesWhereAFootprintCoversCells) {
    const TextureGraph one = graph_of(R"({"node": "simplex_nd", "octaves": 1})");
    const TextureGraph two = graph_of(R"({"node": "simplex_nd", "octaves": 2})");
    const TextureGraph steep = graph_of(
        R"({"node": "simplex_nd", "x5": {"node": "coordinate", "direction": [0, 900, 0]}})");
    const TextureGraph waves = graph_of(R"({"node": "simplex_nd", "signal": "wave", "waves": 9})");
    const auto footprint = [](double size) {
        return Footprint{{size, 0.0, 0.0}, {0.0, size, 0.0}};
    };
    for (const Vec3d& p : random_points(30, 5.0, 3)) {
        // Less than 2^-1.7 cells of the second octave, then more than 2^-1.3, then of the first.
        EXPECT_EQ(sample_of(two, p, footprint(0.15)).value, sample_of(two, p).value);
        EXPECT_EQ(sample_of(two, p, footprint(0.25)).value, sample_of(one, p).value);
        EXPECT_EQ(sample_of(one, p, footprint(0.45)).value, 0.0);
        EXPECT_EQ(sample_of(steep, p, footprint(1e-3)).value, 0.0);
        EXPECT_NE(sample_of(steep, p, {{1e-3, 0.0, 0.0}, {}}).value, 0.0);
        EXPECT_EQ(sample_of(waves, p, footprint(0.06)).value, 0.0);
        EXPECT_NE(sample_of(waves, p, footprint(0.03)).value, 0.0);
    }
}

TEST(FibreNode, StretchesCellsAlongItsDirection) {
    const TextureGraph graph = graph_of(R"({"node": "fibre", "direction": [0, 0, -4],
        "length": 2.5, "width": 0.2, "octaves": 2, "seed": 3})");
    for (const Vec3d& p : random_points(100, 5.0, 4)) {
        // The frame (-z, -y, -x); any turn about the direction would be fibres, too.
        double sum = 0.0;
        NoiseSpec noise{NoiseKind::perlin};
        for (int k = 0; k < 2; ++k) {
            noise.seed = 3u + std::uint32_t(k);
            const double f = std::exp2(k);
            sum += evaluate_noise(noise, {-f * p.z / 2.5, -f * p.y / 0.2, -f * p.x / 0.2}) / f;
        }
        EXPECT_NEAR(sample_of(graph, p).value, sum, 1e-12);
    }
}

/// Mean squared change of a graph's number over a step.
double change(const TextureGraph& graph, const Vec3d& step) {
    double sum = 0.0;
    for (const Vec3d& p : random_points(2000, 50.0, 5)) {
        const double away = sample_of(graph, p + step).value - sample_of(graph, p).value;
        sum += away * away / 2000.0;
    }
    return sum;
}

TEST(FibreNode, ChangesAsLittleAlongAsWidthSaysEvenWhereFibresStray) {
    const Vec3d along = Vec3d(1.0, 2.0, -1.0) / std::sqrt(6.0);
    const Vec3d across = Vec3d(2.0, -1.0, 0.0) / std::sqrt(5.0);
    for (const char* wave : {"0", "0.15"}) {
        const TextureGraph graph =
            graph_of(std::string(R"({"node": "fibre", "direction": [1, 2, -1], "length": 4,
            "width": 0.1, "octaves": 1, "wave": )") +
                     wave + "}");
        EXPECT_LT(20.0 * change(graph, 0.03 * along), change(graph, 0.03 * across)) << wave;
    }
}

TEST(FibreNode, TakesAnyDirection) {
    for (const char* direction : {"[0, 0, 0]", "[1e-300, 0, 0]", "[0, 1e6, 0]", "[-1, -1, -1]"}) {
        const TextureGraph graph = graph_of(
            std::string(R"({"node": "fibre", "wave": 0.3, "direction": )") + direction + "}");
        const Dual n = sample_of(graph, {0.31, -0.7, 1.9});
        EXPECT_TRUE(std::isfinite(n.value) && std::isfinite(glm::length(n.slope))) << direction;
        EXPECT_GT(glm::length(n.slope), 0.0) << direction;
    }
}

/// The point that a node of one input makes, with its derivatives.
std::array<Dual, 3> moved_point(const std::string& node, const Vec3d& p,
                                const Footprint& footprint = {}) {
    std::array<Dual, 3> result;
    for (int axis = 0; axis < 3; ++axis) {
        const char* directions[] = {"[1,0,0]", "[0,1,0]", "[0,0,1]"};
        result[std::size_t(axis)] =
            sample_of(graph_of("{" + node + R"(, "input": {"node": "coordinate", "direction": )" +
                               directions[axis] + "}}"),
                      p, footprint);
    }
    return result;
}

/// The end of the streamline through p after `time`, by 400 steps of Runge and Kutta's rule.
Vec3d along_streamline(Vec3d p, double time, std::uint32_t seed) {
    const double amplitude = simplex_curl_amplitude(3), h = time / 400.0;
    const auto field = [&](const Vec3d& q) {
        const auto v = sample_curl<double>(seed, {q.x, q.y, q.z}, {}).value;
        return amplitude * Vec3d(v[0], v[1], v[2]);
    };
    for (int i = 0; i < 400; ++i) {
        const Vec3d a = field(p), b = field(p + 0.5 * h * a), c = field(p + 0.5 * h * b),
                    d = field(p + h * c);
        p += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    return p;
}

TEST(CurlNode, FollowsStreamlines) {
    double worst[2] = {};
    for (const Vec3d& p : random_points(40, 10.0, 6)) {
        const Vec3d end = along_streamline(p, 0.4, 7);
        for (const int k : {0, 1}) {
            const auto q = moved_point(std::string(R"("node": "curl", "strength": 0.4, "seed": 7,
                "steps": )") + (k ? "16" : "4"),
                                       p);
            worst[k] =
                std::max(worst[k], glm::length(Vec3d(q[0].value, q[1].value, q[2].value) - end));
        }
        EXPECT_GT(glm::length(end - p), 1e-3);
    }
    EXPECT_LT(worst[0], 0.05);
    EXPECT_LT(worst[1], worst[0] / 10.0);  // 16 for a rule of second order
}

TEST(CurlNode, KeepsVolumes) {
    double worst = 0.0, stretch = 0.0;
    for (const Vec3d& p : random_points(100, 10.0, 8)) {
        const auto q = moved_point(R"("node": "curl", "strength": 0.25, "steps": 16, "octaves": 2,
            "time": 2.5)",
                                   p);
        const Mat3d jacobian(q[0].slope, q[1].slope, q[2].slope);
        worst = std::max(worst, std::abs(glm::determinant(jacobian) - 1.0));
        stretch = std::max(stretch, glm::length(q[0].slope));
    }
    EXPECT_LT(worst, 0.05);
    EXPECT_GT(stretch, 1.5);
}

TEST(CurlNode, StandsStillWhereAFootprintCoversItsCells) {
    for (const Vec3d& p : random_points(10, 10.0, 9)) {
        const auto q =
            moved_point(R"("node": "curl", "scale": 100)", p, {{0.01, 0.0, 0.0}, {0.0, 0.01, 0.0}});
        EXPECT_EQ(Vec3d(q[0].value, q[1].value, q[2].value), p);
    }
}

}  // namespace
}  // namespace burl
