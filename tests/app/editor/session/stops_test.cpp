// Edits of stops leave maps that recipes accept, and a stop added changes no colour.
#include "app/editor/session/stops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "procedural/color/srgb.h"
#include "procedural/model/texture.h"

namespace burl {
namespace {

const std::vector<ColorStop> three{{0.1, {0, 0, 0}}, {0.5, {255, 0, 0}}, {0.9, {255, 255, 255}}};

TEST(EditStops, AMovedStopStaysBetweenItsNeighboursWhereItMust) {
    EXPECT_EQ(with_stop_moved_between(three, 1, 0.6)[1].position, 0.6);
    EXPECT_EQ(with_stop_moved_between(three, 1, 0.95)[1].position, 0.9);
    EXPECT_EQ(with_stop_moved_between(three, 1, -3.0)[1].position, 0.1);
    EXPECT_EQ(with_stop_moved_between(three, 0, -3.0)[0].position, 0.0);
    EXPECT_EQ(with_stop_moved_between(three, 2, 3.0)[2].position, 1.0);
}

/// Every stop to every place: the same stops but for one position, in order, and the index is that
/// of the stop moved. Its colour says which it is.
TEST(EditStops, AMovedStopPassesOthers) {
    for (std::size_t stop = 0; stop < three.size(); ++stop)
        for (const double place : {-1.0, 0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0, 2.0}) {
            std::size_t at = stop;
            const std::vector<ColorStop> moved = with_stop_moved(three, at, place);
            ASSERT_EQ(moved.size(), three.size());
            EXPECT_EQ(moved[at].color, three[stop].color);
            EXPECT_EQ(moved[at].position, std::clamp(place, 0.0, 1.0));
            EXPECT_TRUE(std::ranges::is_sorted(moved, {}, &ColorStop::position));
            for (std::size_t other = 0; other < three.size(); ++other) {
                const auto kept = std::ranges::count(moved, three[other]);
                EXPECT_TRUE(other == stop || kept == 1) << stop << ' ' << place;
            }
        }
    std::size_t at = 0;
    with_stop_moved(three, at, 0.5);
    EXPECT_EQ(at, 1u) << "past the stop that it meets on its way up";
}

TEST(EditStops, AnAddedStopChangesNoColour) {
    for (const Wrap wrap : {Wrap::clamp, Wrap::repeat}) {
        const ColorMap before{wrap, three};
        for (const double place : {0.0, 0.05, 0.3, 0.5, 0.77, 1.0}) {
            std::size_t at = 99;
            const ColorMap after{wrap, with_stop_added(before, place, at)};
            ASSERT_EQ(after.stops.size(), 4u);
            EXPECT_EQ(after.stops[at].position, place);
            for (std::size_t i = 1; i < 4; ++i)
                EXPECT_LE(after.stops[i - 1].position, after.stops[i].position);
            const auto a = map_colors(before, 101), b = map_colors(after, 101);
            for (std::size_t i = 0; i < a.size(); ++i) {
                EXPECT_LE(std::abs(a[i].r - b[i].r), 2) << place << ' ' << i;
                EXPECT_LE(std::abs(a[i].g - b[i].g), 2) << place << ' ' << i;
                EXPECT_LE(std::abs(a[i].b - b[i].b), 2) << place << ' ' << i;
            }
        }
    }
}

TEST(EditStops, AnAddedStopKeepsColourAndAlpha) {
    const ColorMap before{Wrap::clamp,
                          {{0.0, {255, 0, 0}, 0}, {0.6, {0, 80, 255}, 200}, {1.0, {9, 9, 9}, 255}}};
    for (const double place : {0.0, 0.05, 0.3, 0.7, 1.0}) {
        std::size_t at = 99;
        const ColorMap after{Wrap::clamp, with_stop_added(before, place, at)};
        for (double f = 0.0; f <= 1.0; f += 0.0625) {
            const Vec3d away = glm::abs(evaluate_color(after, f) - evaluate_color(before, f));
            EXPECT_LT(std::max({away.x, away.y, away.z}), 0.01) << place << ' ' << f;
            EXPECT_NEAR(evaluate_color(alpha_map(after), f).x,
                        evaluate_color(alpha_map(before), f).x, 0.5001 / 255.0)
                << place << ' ' << f;
        }
    }
    EXPECT_EQ(with_stop_moved_between(before.stops, 1, 0.5)[1].alpha, 200);
}

TEST(EditStops, MapColorsShowWhatLiesBehind) {
    const ColorMap map{Wrap::clamp, {{0.0, {255, 0, 0}, 0}, {1.0, {255, 255, 255}, 255}}};
    const auto colors = map_colors(map, 2, {10, 200, 30});
    EXPECT_EQ(colors[0], (Rgb8{10, 200, 30}));
    EXPECT_EQ(colors[1], (Rgb8{255, 255, 255}));
}

TEST(EditStops, TheLastStopStays) {
    std::vector<ColorStop> stops = three;
    stops = with_stop_removed(stops, 1);
    EXPECT_EQ(stops, (std::vector<ColorStop>{three[0], three[2]}));
    stops = with_stop_removed(stops, 0);
    stops = with_stop_removed(stops, 0);
    EXPECT_EQ(stops, std::vector<ColorStop>{three[2]});
}

TEST(EditStops, MapColorsAreTheDefinitions) {
    const ColorMap map{Wrap::clamp, three};
    const auto colors = map_colors(map, 11);
    for (std::size_t i = 0; i < 10; ++i) {
        const Vec3d exact = evaluate_color(map, double(i) / 10.0);
        EXPECT_NEAR(srgb_encode(exact.x) * 255.0, colors[i].r, 0.5001);
        EXPECT_NEAR(srgb_encode(exact.y) * 255.0, colors[i].g, 0.5001);
    }
}

}  // namespace
}  // namespace burl
