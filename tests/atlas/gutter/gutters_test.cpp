// Gutters of charts with any outline: against the analytic continuation of a developable surface,
// against the mesh itself, and against nearest edges by brute force.
#include "atlas/gutter/gutters.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

/// Some triangles of a mesh as one chart, all others as another far away.
struct Chart {
    Mesh mesh;
    EdgeNeighbours neighbours;
    std::vector<std::array<Vec2d, 3>> corners;
    std::vector<std::uint32_t> charts, triangles;

    /// `place` gives a corner's place from triangle and point, `takes` the chart's triangles.
    template <class Place, class Takes>
    Chart(Mesh m, const Place& place, const Takes& takes)
        : mesh(std::move(m)), neighbours(mesh.triangles, mesh.positions) {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            std::array<Vec2d, 3> at;
            for (std::size_t k = 0; k < 3; ++k) at[k] = place(t, mesh.triangles[t][k]);
            const bool taken = takes((at[0] + at[1] + at[2]) / 3.0, t);
            if (taken) triangles.push_back(t);
            charts.push_back(taken ? 0 : 1);
            if (!taken) at.fill(Vec2d(-1000.0));
            corners.push_back(at);
        }
    }

    ChartedMesh charted() const { return {mesh.triangles, mesh.positions, corners, charts}; }

    bool owns(const Vec2d& q) const {
        for (const std::uint32_t t : triangles) {
            bool inside = true;
            for (std::size_t k = 0; k < 3; ++k)
                inside = inside &&
                         cross(corners[t][(k + 1) % 3] - corners[t][k], q - corners[t][k]) >= 0.0;
            if (inside) return true;
        }
        return false;
    }

    /// The texels of a square of `size` that the chart does not own, in pieces of at most `most`.
    std::vector<TexelGap> gaps(std::uint32_t size, std::uint32_t most = 1000) const {
        std::vector<TexelGap> gaps;
        for (std::uint32_t y = 0; y < size; ++y)
            for (std::uint32_t x = 0; x < size; ++x) {
                if (owns({x + 0.5, y + 0.5})) continue;
                if (!gaps.empty() && gaps.back().y == y && gaps.back().x + gaps.back().count == x &&
                    gaps.back().count < most)
                    ++gaps.back().count;
                else
                    gaps.push_back({y, x, 1});
            }
        return gaps;
    }
};

/// Calls visit(x, y, point, triangle) for all texels of a gutter.
template <class Visit>
std::size_t visit_texels(const Gutter& gutter, const Visit& visit) {
    std::size_t count = 0;
    for (const GutterRun& run : gutter.runs)
        for (std::uint32_t x = run.x; x < run.x + run.count; ++x, ++count)
            visit(x, run.y, gutter.maps[run.map](x, run.y), gutter.triangles[run.map]);
    return count;
}

constexpr std::uint32_t columns = 48, rows = 40;
constexpr double height = 4.0;

/// A place on the unrolled tube, in texels of a map that is no isometry.
Vec2d texels_of(const Vec2d& flat) {
    return Vec2d(1.5, 2.25) + Vec2d(13.0 * flat.x + 2.0 * flat.y, 9.0 * flat.y);
}
Vec2d flat_of(const Vec2d& texels) {
    const Vec2d d = texels - Vec2d(1.5, 2.25);
    const double y = d.y / 9.0;
    return {(d.x - 2.0 * y) / 13.0, y};
}
const double chord = 2.0 * std::sin(std::numbers::pi / columns);

Vec3d on_tube(const Vec2d& flat) {
    const double column = std::floor(flat.x / chord), share = flat.x / chord - column;
    const auto corner = [&](double i) {
        const double angle = 2.0 * std::numbers::pi * i / columns;
        return Vec3d(std::cos(angle), std::sin(angle), flat.y);
    };
    return (1.0 - share) * corner(column) + share * corner(column + 1.0);
}

/// A chart with a ragged outline, concave and with a hole, on a tube.
Chart tube_chart() {
    return Chart(
        made::tube(columns, rows, height),
        [](std::uint32_t t, std::uint32_t p) {
            double column = p % columns;
            if (t / 2 % columns == columns - 1 && column == 0.0) column = columns;
            return texels_of({chord * column, height * double(p / columns) / rows});
        },
        [](const Vec2d& centre, std::uint32_t t) {
            const Vec2d d = flat_of(centre) - Vec2d(2.6, 2.0);
            const double angle = std::atan2(d.y, d.x), r = glm::length(d);
            return r > 0.25 && r < 1.1 + 0.35 * std::cos(5.0 * angle) && t % 17 != 3;
        });
}

TEST(Gutters, OfADevelopableChartAreItsAnalyticContinuation) {
    const Chart chart = tube_chart();
    const std::vector<ChartEdge> edges =
        chart_edges(chart.charted(), chart.neighbours, chart.triangles);
    const std::vector<TexelGap> gaps = chart.gaps(72);
    const Gutter gutter =
        fill_gutter(chart.charted(), chart.neighbours, edges, gaps, {0, 0, 72, 72}, {.reach = 8.0});
    const std::size_t filled = visit_texels(
        gutter, [&](std::uint32_t x, std::uint32_t y, const Vec3d& point, std::uint32_t triangle) {
            const Vec2d flat = flat_of({x + 0.5, y + 0.5});
            EXPECT_EQ(chart.charts[triangle], 0u);
            if (flat.y > 0.02 && flat.y < height - 0.02) {
                EXPECT_LT(glm::distance(point, on_tube(flat)), 1e-9) << x << ", " << y;
            }
        });
    EXPECT_GT(filled, 700u);
    EXPECT_LT(gutter.runs.size(), filled);
}

TEST(Gutters, NearestEdgesAreThoseOfBruteForce) {
    const Chart chart = tube_chart();
    const std::vector<ChartEdge> edges =
        chart_edges(chart.charted(), chart.neighbours, chart.triangles);
    for (const double reach : {3.0, 9.5}) {
        const std::vector<TexelGap> gaps = chart.gaps(72);
        const std::vector<std::uint32_t> nearest = nearest_edges(edges, gaps, reach);
        std::size_t i = 0, found = 0;
        for (const TexelGap& gap : gaps)
            for (std::uint32_t x = gap.x; x < gap.x + gap.count; ++x, ++i) {
                const Vec2d q(x + 0.5, gap.y + 0.5);
                double least = std::numeric_limits<double>::infinity();
                for (const ChartEdge& edge : edges)
                    least = std::min(least, glm::distance(q, edge.nearest(q)));
                if (std::abs(least - reach) < 1e-9) continue;
                EXPECT_EQ(nearest[i] != no_edge, least < reach);
                if (nearest[i] == no_edge) continue;
                const ChartEdge& edge = edges[nearest[i]];
                EXPECT_LT(glm::distance(q, edge.nearest(q)), least + 1e-9);
                EXPECT_LE(cross(edge.b - edge.a, q - edge.a), 1e-9);  // on the outer side
                ++found;
            }
        EXPECT_EQ(i, nearest.size());
        EXPECT_GT(found, 300u);
    }
}

TEST(Gutters, ChartEdgesAreTheBordersOfCharts) {
    const Chart chart = tube_chart();
    std::set<std::uint32_t> expected;
    const Connectivity connectivity = made::neighbours_by_brute_force(chart.mesh);
    for (const std::uint32_t t : chart.triangles)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::int32_t n = connectivity.neighbours[t][k];
            if (n < 0 || chart.charts[std::size_t(n)] != 0) expected.insert(3 * t + k);
        }
    std::set<std::uint32_t> found;
    for (const ChartEdge& e : chart_edges(chart.charted(), chart.neighbours, chart.triangles))
        found.insert(e.edge);
    EXPECT_EQ(found, expected);
}

TEST(Gutters, OfASphereLieOnTheMesh) {
    const Mesh ball = made::ball(4);
    const Chart chart(
        ball,
        [&](std::uint32_t, std::uint32_t p) {
            return Vec2d(32.0) + 22.0 * Vec2d(ball.positions[p]);
        },
        [&](const Vec2d& centre, std::uint32_t t) {
            const bool above = ball.positions[ball.triangles[t][0]].z > 0.0;
            return above && glm::distance(centre, Vec2d(32.0)) < 15.0;
        });
    const std::vector<ChartEdge> edges =
        chart_edges(chart.charted(), chart.neighbours, chart.triangles);
    const std::vector<TexelGap> gaps = chart.gaps(64);
    const Gutter gutter = fill_gutter(chart.charted(), chart.neighbours, edges, gaps,
                                      {0, 0, 64, 64}, {.reach = 12.0});
    double lowest = 1.0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3d> points;
    const std::size_t filled = visit_texels(
        gutter, [&](std::uint32_t x, std::uint32_t y, const Vec3d& point, std::uint32_t) {
            EXPECT_TRUE(made::lies_on(ball, point, 1e-12)) << x << ", " << y;
            lowest = std::min(lowest, point.z);
            points[{x, y}] = point;
        });
    EXPECT_GT(filled, 800u);
    EXPECT_LT(lowest, 0.25);  // walks lead well beyond the chart
    // Texels do not depend on how the gaps are cut into runs.
    const Gutter cut = fill_gutter(chart.charted(), chart.neighbours, edges, chart.gaps(64, 1),
                                   {0, 0, 64, 64}, {.reach = 12.0});
    EXPECT_EQ(cut.runs.size(), filled);
    visit_texels(cut, [&](std::uint32_t x, std::uint32_t y, const Vec3d& point, std::uint32_t) {
        EXPECT_LT(glm::distance(point, points.at({x, y})), 1e-6);
    });
}

/// Flat squares whose neighbours lie in the same plane are one map each.
TEST(Gutters, GoOnWithOneMapInAPlane) {
    Mesh mesh = made::grid(20, 20);
    for (Vec3d& p : mesh.positions) p.z = 0.0;
    const auto chart_of = [&](std::uint32_t open) {
        return Chart(
            mesh, [&](std::uint32_t, std::uint32_t p) { return 60.0 * Vec2d(mesh.positions[p]); },
            [&](const Vec2d& c, std::uint32_t) {
                return c.x > 15 && c.x < 45 && c.y > (open ? 0.0 : 15) && c.y < 45;
            });
    };
    for (const std::uint32_t open : {0u, 1u}) {
        const Chart chart = chart_of(open);
        const std::vector<ChartEdge> edges =
            chart_edges(chart.charted(), chart.neighbours, chart.triangles);
        const Gutter gutter = fill_gutter(chart.charted(), chart.neighbours, edges, chart.gaps(60),
                                          {0, 0, 60, 60}, {.reach = 8.0});
        visit_texels(gutter, [&](std::uint32_t x, std::uint32_t y, const Vec3d& point, auto) {
            EXPECT_LT(glm::distance(point, Vec3d((x + 0.5) / 60, (y + 0.5) / 60, 0.0)), 1e-7);
        });
        EXPECT_LT(gutter.runs.size(), 400u);
    }
}

}  // namespace
}  // namespace burl
