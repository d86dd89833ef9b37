#include "procedural/bresenham/cell_walk.h"

#include <random>

#include <gtest/gtest.h>

namespace burl {
namespace {

/// The stretches that cover texels 0 to count - 1.
std::vector<CellStretch> stretches(const LatticeLine& line) {
    std::vector<CellStretch> list;
    for (CellWalk walk(line);; walk.advance()) {
        list.push_back(walk.stretch());
        if (walk.stretch().last >= std::int64_t(line.count)) return list;
    }
}

/// Every texel in its cell: exactly where float64 is exact, else up to the coordinate's rounding.
void expect_cells(const LatticeLine& line, bool exact) {
    std::int64_t at = 0;
    for (const CellStretch& stretch : stretches(line)) {
        ASSERT_EQ(stretch.first, at);
        ASSERT_GT(stretch.last, stretch.first);
        for (; at < std::min(stretch.last, std::int64_t(line.count)); ++at)
            for (int axis = 0; axis < 3; ++axis) {
                const double x = line.start[axis] + double(at) * line.step[axis];
                const auto cell = double(stretch.cell[std::size_t(axis)]);
                if (exact) {
                    ASSERT_EQ(std::floor(x), cell) << at << " " << axis;
                    continue;
                }
                const double slack =
                    1e-300 + 0x1p-51 * (std::abs(x) + std::abs(line.start[axis]) + std::abs(cell));
                ASSERT_GE(x - cell, -slack) << at << " " << axis;
                ASSERT_LE(x - cell, 1.0 + slack) << at << " " << axis;
            }
    }
}

/// Multiples of 1/64: their products with whole numbers are exact.
LatticeLine dyadic_line(std::mt19937& random, int reach) {
    LatticeLine line;
    for (int axis = 0; axis < 3; ++axis) {
        line.start[axis] = (int(random() % 1281) - 640) / 64.0;
        line.step[axis] =
            random() % 4 == 0 ? 0.0 : (int(random() % unsigned(2 * reach + 1)) - reach) / 64.0;
    }
    line.count = 1 + random() % 300;
    return line;
}

TEST(CellWalk, FindsTheFloorOfEveryCoordinate) {
    std::mt19937 random(1);
    for (const int reach : {1, 3, 20, 64, 500, 64'000})
        for (int i = 0; i < 200; ++i) expect_cells(dyadic_line(random, reach), true);
}

TEST(CellWalk, TakesLatticePlanesAsTheFloorDoes) {
    // From plane to plane, upwards and downwards, along one axis and with no step at all.
    expect_cells({{0.0, 3.0, -2.0}, {1.0, 0.0, 0.0}, 0.0, 20}, true);
    expect_cells({{0.0, 3.0, -2.0}, {-1.0, 0.0, 0.0}, 0.0, 20}, true);
    expect_cells({{0.0, 3.0, -2.0}, {-0.25, 0.25, -0.5}, 0.0, 50}, true);
    expect_cells({{0.0, -1.0, 5.0}, {0.0, 0.0, 0.0}, 0.0, 20}, true);
    const auto parallel = stretches({{0.5, 3.0, -2.0}, {0.0, -0.25, 0.0}, 0.0, 9});
    ASSERT_EQ(parallel.size(), 3u);
    EXPECT_EQ(parallel[0].cell, (std::array<std::int64_t, 3>{0, 3, -2}));
    EXPECT_EQ(parallel[0].last, 1);
    EXPECT_EQ(parallel[1].cell, (std::array<std::int64_t, 3>{0, 2, -2}));
    EXPECT_EQ(parallel[1].last, 5);
}

TEST(CellWalk, HasOneStretchPerCellEntered) {
    // Bresenham's line: 3 planes of x and 4 of y in between, never two at once.
    EXPECT_EQ(stretches({{0.5, 0.5, 0.5}, {3.0 / 97, 4.0 / 97, 0.0}, 0.0, 98}).size(), 8u);
    // A diagonal crosses three planes at once.
    EXPECT_EQ(stretches({{0.0, 0.0, 0.0}, {0.125, 0.125, 0.125}, 0.0, 64}).size(), 8u);
}

TEST(CellWalk, StandsRoundingAtPlanes) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 600; ++i) {
        LatticeLine line;
        line.count = 400;
        const double far = std::ldexp(1.0, int(random() % 40)),
                     pace = std::ldexp(1.0, -int(random() % 50));
        for (int axis = 0; axis < 3; ++axis) {
            // A plane, or next to it, or anywhere; steps that add up to a plane, or not.
            const double plane = std::round(far * unit(random));
            const double near = std::nextafter(plane, unit(random) < 0.0 ? -1e300 : 1e300);
            line.start[axis] = i % 3 == 0 ? plane : i % 3 == 1 ? near : far * unit(random);
            line.step[axis] =
                i % 2 == 0 ? 1.0 / (1.0 + double(random() % 200)) : pace * unit(random);
            if (random() % 2) line.step[axis] = -line.step[axis];
        }
        expect_cells(line, false);
    }
    for (const double step : {0.1, 0.3, 1.0 / 3.0, 1.0 / 49.0, 0.7})
        for (const double sign : {1.0, -1.0})
            expect_cells({{step, 0.0, 1.0 - step}, sign * Vec3d(step, -step, step), 0.0, 500},
                         false);
}

TEST(CellWalk, StandsStepsTooSmallToMove) {
    for (const double step : {1e-17, 1e-300, 5e-324, -1e-17, -1e-300, -5e-324})
        expect_cells({{3.0, 1e9, -0.0}, {step, step, step}, 0.0, 1000}, false);
}

TEST(CellWalk, DoesNotDependOnWhereItBegins) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 300; ++i) {
        LatticeLine line{{9 * unit(random), 9 * unit(random), 9 * unit(random)}, {}, 0.0, 300};
        const double pace = std::ldexp(1.0, 3 - int(random() % 12));
        for (int axis = 0; axis < 3; ++axis) line.step[axis] = pace * unit(random);
        for (const CellStretch& whole : stretches(line))
            for (const std::int64_t texel :
                 {whole.first, (whole.first + whole.last) / 2, whole.last - 1}) {
                LatticeLine cut = line;
                cut.first = double(texel);
                const CellStretch part = CellWalk(cut).stretch();
                ASSERT_EQ(part.first, whole.first);
                ASSERT_EQ(part.last, whole.last);
                ASSERT_EQ(part.cell, whole.cell);
            }
    }
}

}  // namespace
}  // namespace burl
