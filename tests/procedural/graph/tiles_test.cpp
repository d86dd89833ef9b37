// Patterns of tiles against brute force and closed forms.
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "procedural/graph/values.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

/// The value of a graph at points, with gradients.
class Evaluated {
  public:
    explicit Evaluated(std::string_view json) : evaluate_(graph_of(json)) {}
    Dual operator()(const Vec3d& p, const Footprint& footprint = {}) {
        GraphSample sample;
        evaluate_({&p, 1}, {&footprint, 1}, scratch_, {&sample, 1});
        return sample.channels[0];
    }

  private:
    GraphEvaluator evaluate_;
    GraphEvaluator::Scratch scratch_ = evaluate_.make_scratch();
};

std::string tile_node(std::string_view node, std::string_view gives, std::string_view more = "") {
    return fmt::format(R"({{"node": "{}", "gives": "{}"{}{}}})", node, gives,
                       more.empty() ? "" : ", ", more);
}

/// A convex tile: the distance to its border, and a name.
struct CountedTile {
    double edge = -1e9;
    std::array<int, 3> name{};
};

/// Sets `best` to the box with the corner `low` if the point lies deeper in it.
void keep_deepest(CountedTile& best, const Vec3d& p, const Vec3d& low, const Vec3d& size,
                  const std::array<int, 3>& name) {
    double edge = 1e9;
    for (int axis = 0; axis < 3; ++axis)
        if (size[axis] > 0.0)
            edge = std::min({edge, p[axis] - low[axis], low[axis] + size[axis] - p[axis]});
    if (edge > best.edge) best = {edge, name};
}

/// The box among those of twelve courses about the point that it lies in.
CountedTile counted_box(const Vec3d& p, const Vec3d& size, double offset) {
    CountedTile best;
    for (int j = -12; j <= 12; ++j)
        for (int i = -30; i <= 30; ++i)
            for (int k = size.z > 0.0 ? -30 : 0; k <= (size.z > 0.0 ? 30 : 0); ++k)
                keep_deepest(best, p,
                             {(i - offset * j) * size.x, j * size.y, (k - offset * j) * size.z},
                             size, {i, j, k});
    return best;
}

CountedTile counted_hexagon(const Vec3d& p, double width) {
    std::vector<std::array<int, 2>> all;
    for (int i = -24; i <= 24; ++i)
        for (int j = -24; j <= 24; ++j)
            if ((i + j) % 2 == 0) all.push_back({i, j});
    const auto middle = [&](const std::array<int, 2>& at) {
        return Vec3d(0.5 * width * at[0], 0.5 * std::numbers::sqrt3 * width * at[1], p.z);
    };
    const auto nearest = std::ranges::min_element(
        all, {}, [&](const auto& at) { return glm::distance(p, middle(at)); });
    double edge = 1e9;
    for (const auto& at : all) {
        if (at == *nearest) continue;
        const Vec3d own = middle(*nearest), other = middle(at);
        edge = std::min(edge, glm::dot(0.5 * (own + other) - p, glm::normalize(other - own)));
    }
    return {edge, {(*nearest)[0], (*nearest)[1], 0}};
}

/// The only one of the rectangles of two diagonal rows, repeated, that holds the point.
CountedTile counted_herringbone(const Vec3d& p, double width, int n) {
    CountedTile best;
    int holding = 0;
    for (int i = -30; i <= 30; ++i)
        for (int m = -8; m <= 8; ++m)
            for (const bool upright : {false, true}) {
                CountedTile tile;
                const Vec3d low =
                    upright ? Vec3d(i, i + 1 + 2 * n * m, 0) : Vec3d(i + 2 * n * m, i, 0);
                keep_deepest(tile, p, width * low,
                             width * (upright ? Vec3d(1, n, 0) : Vec3d(n, 1, 0)), {i, m, upright});
                holding += tile.edge > 0.0;
                if (tile.edge > best.edge) best = tile;
            }
    EXPECT_EQ(holding, 1);
    return best;
}

/// A node's distances, numbers and weights are those of the counted tiles.
template <class Counted>
void expect_tiles(std::string_view node, const std::string& more, double joint,
                  const Counted& counted) {
    const std::string all = fmt::format(R"({}, "joint": {})", more, joint);
    Evaluated edge(tile_node(node, "edge", all)), id(tile_node(node, "id", all)),
        tile(tile_node(node, "tile", all)), u(tile_node(node, "u", all)),
        v(tile_node(node, "v", all));
    std::map<std::array<int, 3>, double> ids;
    std::set<double> numbers;
    for (const Vec3d& p : random_points(400, 2.0, 11)) {
        const CountedTile expected = counted(p);
        const Dual away = edge(p);
        EXPECT_NEAR(away.value, expected.edge - 0.5 * joint, 1e-12) << node;
        EXPECT_NEAR(glm::length(away.slope), 1.0, 1e-12) << node;
        EXPECT_EQ(tile(p).value, away.value >= 0.0 ? 1.0 : 0.0) << node;
        const double number = id(p).value;
        EXPECT_EQ(ids.try_emplace(expected.name, number).first->second, number) << node;
        numbers.insert(number);
        for (const double place : {u(p).value, v(p).value}) {
            EXPECT_GE(place, 0.0) << node;
            EXPECT_LE(place, 1.0) << node;
        }
    }
    EXPECT_EQ(numbers.size(), ids.size()) << node;
    EXPECT_GT(ids.size(), 20u) << node;
}

TEST(Tiles, AreThoseThatAreCounted) {
    expect_tiles("tiles", R"("width": 0.5, "height": 0.6)", 0.07, [](const Vec3d& p) {
        return counted_box(p, {0.5, 0.6, 0.0}, 0.0);
    });
    expect_tiles("bricks", R"("width": 0.8, "height": 0.3, "offset": 0.3)", 0.05,
                 [](const Vec3d& p) {
                     return counted_box(p, {0.8, 0.3, 0.0}, 0.3);
                 });
    expect_tiles("bricks", R"("width": 0.8, "height": 0.3, "depth": 0.6)", 0.05,
                 [](const Vec3d& p) {
                     return counted_box(p, {0.8, 0.3, 0.6}, 0.5);
                 });
    expect_tiles("hexagons", R"("width": 0.6)", 0.04,
                 [](const Vec3d& p) { return counted_hexagon(p, 0.6); });
    for (const int n : {1, 2, 3, 5})
        expect_tiles("herringbone", fmt::format(R"("width": 0.25, "ratio": {})", n), 0.03,
                     [n](const Vec3d& p) { return counted_herringbone(p, 0.25, n); });
}

TEST(Tiles, PlanksAreBricksMovedAtRandom) {
    Evaluated u(tile_node("planks", "u", R"("width": 2, "height": 0.5)")),
        edge(tile_node("planks", "edge", R"("width": 2, "height": 0.5, "joint": 0)"));
    std::set<double> starts;
    for (int course = -20; course < 20; ++course) {
        const double y = 0.5 * course + 0.25, start = u({0.0, y, 3.0}).value;
        starts.insert(start);
        for (const double x : {-3.1, 0.4, 7.7}) {
            const double place = start + 0.5 * x - std::floor(start + 0.5 * x);
            EXPECT_NEAR(u({x, y, 3.0}).value, place, 1e-12);
            EXPECT_NEAR(edge({x, y, 3.0}).value, std::min(0.25, 2.0 * std::min(place, 1.0 - place)),
                        1e-12);
        }
    }
    EXPECT_EQ(starts.size(), 40u);
}

struct Shared {
    std::string_view node, more;
    double share;
};

/// Joints' shares of the plane, by the tiles' areas.
const std::array shared_tiles{
    Shared{"tiles", R"("width": 0.5, "height": 2, "joint": 0.1)", 0.4 * 1.9 / (0.5 * 2)},
    Shared{"bricks", R"("width": 1, "height": 0.4, "joint": 0.05)", 0.95 * 0.35 / 0.4},
    Shared{"bricks", R"("width": 1, "height": 0.4, "depth": 0.5, "joint": 0.05)",
           0.95 * 0.35 * 0.45 / (0.4 * 0.5)},
    Shared{"planks", R"("width": 4, "height": 0.5, "joint": 0.05)", 3.95 * 0.45 / (4 * 0.5)},
    Shared{"hexagons", R"("width": 0.5, "joint": 0.1)", 0.64},
    Shared{"herringbone", R"("width": 0.5, "joint": 0.1, "ratio": 3)", 0.4 * 1.4 / (0.5 * 1.5)}};

TEST(Tiles, JointsTakeTheirShareOfThePlane) {
    for (const Shared& all : shared_tiles) {
        Evaluated tile(tile_node(all.node, "tile", all.more));
        double sum = 0.0, count = 0.0;
        for (const Vec3d& p : random_points(100000, 200.0, 13)) sum += tile(p).value, ++count;
        EXPECT_NEAR(sum / count, all.share, 0.006) << all.node;
        // A wide footprint sees that share, too.
        const Footprint wide{{61.7, -40.3, 77.7}, {52.1, 83.9, -90.3}};
        for (const Vec3d& p : random_points(20, 5.0, 17))
            EXPECT_NEAR(tile(p, wide).value, all.share, 0.02) << all.node;
    }
}

TEST(Tiles, NoJointsLeaveNoTrace) {
    for (const char* node : {"tiles", "bricks", "planks", "hexagons", "herringbone"}) {
        Evaluated tile(tile_node(node, "tile", R"("joint": 0)"));
        for (const Vec3d& p : random_points(200, 3.0, 19)) {
            EXPECT_EQ(tile(p).value, 1.0) << node;
            EXPECT_NEAR(tile(p, {{0.2, 0.1, 0}, {-0.1, 0.3, 0}}).value, 1.0, 1e-12) << node;
        }
    }
}

/// The mean over the footprint's parallelogram, n x n midpoints.
double counted_mean(Evaluated& tile, const Vec3d& p, const Footprint& footprint, int n) {
    double sum = 0.0;
    for (int i = 0; i < n * n; ++i)
        sum += tile(p + ((i % n + 0.5) / n - 0.5) * footprint.u +
                    ((i / n + 0.5) / n - 0.5) * footprint.v)
                   .value;
    return sum / (n * n);
}

TEST(Tiles, FootprintsAlongOneAxisHaveTheExactMean) {
    for (const char* node : {"tiles", "bricks", "planks"}) {
        Evaluated tile(tile_node(node, "tile", R"("height": 0.6, "joint": 0.15)"));
        for (const Vec3d& p : random_points(40, 3.0, 23)) {
            const Footprint along{{0.9, 0, 0}, {0, 0, 0.3}}, up{{0, 0, 0.1}, {0, 0.07, 0}};
            EXPECT_NEAR(tile(p, along).value, counted_mean(tile, p, along, 100), 0.011) << node;
            if (std::abs(p.y / 0.6 - std::round(p.y / 0.6)) > 0.07) {  // within one course
                EXPECT_NEAR(tile(p, up).value, counted_mean(tile, p, up, 100), 0.011) << node;
            }
        }
    }
}

/// The errors over footprints of all sizes that docs/reference/nodes.md states.
TEST(Tiles, FootprintsHaveNearlyTheMean) {
    for (const Shared& all : shared_tiles) {
        if (all.more.find("depth") != std::string_view::npos) continue;
        Evaluated tile(tile_node(all.node, "tile", all.more));
        for (const double size : {0.03, 0.1, 0.3, 1.0}) {
            double squares = 0.0, worst = 0.0;
            const auto points = random_points(60, 3.0, 29);
            for (const Vec3d& p : points) {
                const Footprint footprint{size * Vec3d(0.8, 0.6, 0), size * Vec3d(-0.6, 0.8, 0)};
                const double away =
                    std::abs(tile(p, footprint).value - counted_mean(tile, p, footprint, 24));
                squares += away * away, worst = std::max(worst, away);
            }
            const double rms = std::sqrt(squares / double(points.size()));
            const bool boxes = all.node != "hexagons" && all.node != "herringbone";
            EXPECT_LT(rms, boxes ? 0.05 : 0.1) << all.node << size;
            EXPECT_LT(worst, boxes ? 0.15 : 0.25) << all.node << size;
        }
    }
}

TEST(Tiles, ValuesAreThoseWithGradients) {
    std::vector<std::string> all;
    for (const char* node : {"tiles", "bricks", "planks", "hexagons", "herringbone"})
        for (const char* gives : {"tile", "edge", "id", "u", "v"})
            all.push_back(tile_node(node, gives, R"("seed": 4294967295)"));
    for (const char* gives : {"distance", "edge", "id"}) all.push_back(tile_node("cells", gives));
    for (const char* shape : {"disk", "square", "ring", "star", "leaf"})
        for (const char* gives : {"shape", "edge", "id"})
            all.push_back(tile_node("scatter", gives, fmt::format(R"("shape": "{}")", shape)));
    for (const std::string& json : all) {
        // Far away, where float32 would have no fraction left.
        const std::string far = R"({"node": "transform", "translate": [1048576, -1048576, 2097152],
            "input": )" + json + "}";
        for (const std::string& graph : {json, far}) {
            Evaluated exact(graph);
            const GraphValues values(graph_of(graph));
            GraphValues::Scratch scratch = values.make_scratch();
            std::set<double> different;
            for (const Vec3d& p : random_points(300, 5.0, 43)) {
                const double expected = exact(p).value;
                EXPECT_NEAR(values(p, scratch).x, expected, 1e-9) << graph;
                different.insert(expected);
            }
            EXPECT_GT(different.size(), 1u) << graph;
        }
    }
}

}  // namespace
}  // namespace burl
