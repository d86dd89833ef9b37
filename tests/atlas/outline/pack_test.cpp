// Packing: outlines stay apart by the gutter, inside the texture, in cells of their own, at one
// scale.
#include "atlas/outline/pack.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace burl {
namespace {

using Polygon = std::vector<Vec2d>;

double area_of(const Polygon& p) {
    double sum = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += 0.5 * cross(p[i], p[(i + 1) % p.size()]);
    return sum;
}

/// Stars of random size and form.
std::vector<Polygon> stars(std::size_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(0.3, 1.0);
    std::vector<Polygon> result;
    for (std::size_t i = 0; i < count; ++i) {
        Polygon p;
        const double size = 0.2 + any(random);
        for (int k = 0; k < 12; ++k) {
            const double a = std::numbers::pi * k / 6.0, r = size * any(random);
            p.emplace_back(5.0 + r * std::cos(a), -3.0 + r * std::sin(a));
        }
        result.push_back(std::move(p));
    }
    return result;
}

std::vector<Outline> outlines_of(const std::vector<Polygon>& polygons) {
    std::vector<Outline> result;
    for (const Polygon& p : polygons) result.push_back({p, area_of(p)});
    return result;
}

double distance_to_edge(const Vec2d& q, const Vec2d& a, const Vec2d& b) {
    const double t = std::clamp(glm::dot(q - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::distance(q, a + t * (b - a));
}

bool is_inside(const Vec2d& q, const Polygon& p) {
    bool inside = false;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2d &a = p[i], &b = p[(i + 1) % p.size()];
        if ((a.y <= q.y) != (b.y <= q.y) && q.x < a.x + (q.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

std::vector<Polygon> placed(const std::vector<Polygon>& polygons, const PackedOutlines& packing) {
    std::vector<Polygon> result = polygons;
    for (std::size_t i = 0; i < result.size(); ++i)
        for (Vec2d& q : result[i]) q = packing.outlines[i](q);
    return result;
}

TEST(PackOutlines, OutlinesStayApartByTheGutter) {
    for (const std::uint32_t size : {256u, 500u, 1024u}) {
        const auto polygons = stars(24, size);
        const auto packing = pack_outlines(outlines_of(polygons), size);
        ASSERT_TRUE(packing);
        const auto at = placed(polygons, *packing);
        const double half = 0.25 * packing->cell;
        for (std::size_t i = 0; i < at.size(); ++i)
            for (const Vec2d& q : at[i]) {
                EXPECT_TRUE(q.x >= half - 1e-9 && q.y >= half - 1e-9);
                EXPECT_TRUE(q.x <= size - half + 1e-9 && q.y <= size - half + 1e-9);
                for (std::size_t j = 0; j < at.size(); ++j) {
                    if (j == i) continue;
                    EXPECT_FALSE(is_inside(q, at[j]));
                    for (std::size_t k = 0; k < at[j].size(); ++k)
                        EXPECT_GE(distance_to_edge(q, at[j][k], at[j][(k + 1) % at[j].size()]),
                                  2.0 * half * 0.95);
                }
            }
    }
}

TEST(PackOutlines, TurnsKeepFormAndScale) {
    const auto polygons = stars(10, 3);
    const auto packing = pack_outlines(outlines_of(polygons), 512);
    ASSERT_TRUE(packing);
    const auto at = placed(polygons, *packing);
    for (std::size_t i = 0; i < at.size(); ++i) {
        EXPECT_NEAR(area_of(at[i]), packing->scale * packing->scale * area_of(polygons[i]),
                    1e-9 * area_of(at[i]));
        EXPECT_NEAR(glm::distance(at[i][0], at[i][5]),
                    packing->scale * glm::distance(polygons[i][0], polygons[i][5]), 1e-9);
    }
}

TEST(PackOutlines, CellsBelongToOneOutline) {
    const auto polygons = stars(30, 8);
    const auto packing = pack_outlines(outlines_of(polygons), 1024);
    ASSERT_TRUE(packing);
    ASSERT_EQ(packing->cell, 8u);
    const auto at = placed(polygons, *packing);
    const std::uint32_t side = 1024 / packing->cell;
    std::vector<int> owner(side * side, -1);
    for (int i = 0; i < int(at.size()); ++i)
        for (std::uint32_t y = 0; y < 1024; ++y)
            for (std::uint32_t x = 0; x < 1024; ++x)
                if (is_inside({x + 0.5, y + 0.5}, at[std::size_t(i)])) {
                    int& cell = owner[y / packing->cell * side + x / packing->cell];
                    ASSERT_TRUE(cell == -1 || cell == i);
                    cell = i;
                }
}

TEST(PackOutlines, SquaresFillTheTexture) {
    std::vector<Polygon> squares(4, Polygon{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    const auto packing = pack_outlines(outlines_of(squares), 1024);
    ASSERT_TRUE(packing);
    // Four squares of 64 cells a side, less a quarter of a cell round each.
    EXPECT_GT(packing->scale, 500.0);
    EXPECT_LE(packing->scale, 508.0);
}

TEST(PackOutlines, RandomOutlinesCoverMostOfTheTexture) {
    const auto polygons = stars(60, 5);
    const auto outlines = outlines_of(polygons);
    double area = 0.0;
    for (const Outline& o : outlines) area += o.area;
    const auto packing = pack_outlines(outlines, 1024);
    ASSERT_TRUE(packing);
    EXPECT_GT(packing->scale * packing->scale * area, 0.5 * 1024 * 1024);
    const auto again = pack_outlines(outlines, 1024);
    for (std::size_t i = 0; i < outlines.size(); ++i)
        EXPECT_EQ(again->outlines[i].origin, packing->outlines[i].origin);
}

TEST(PackOutlines, NothingFitsWhereCellsAreTooFew) {
    const std::vector<Polygon> many(17, Polygon{{0, 0}, {1, 0}, {0, 1}});
    EXPECT_FALSE(pack_outlines(outlines_of(many), 4));
    EXPECT_TRUE(pack_outlines(outlines_of(many), 16));
    EXPECT_FALSE(pack_outlines({}, 16));
}

}  // namespace
}  // namespace burl
