// Span maps against the spans they show.
#include "procedural/maps/point_map.h"

#include <gtest/gtest.h>

#include "procedural/batch/point_map.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

TEST(SpanMapTest, EveryTexelKnowsItsSpan) {
    const SolidAtlas solid = SyntheticAtlas{50, 16}.make(2);
    const TexelArea area{5, 7, 40, 36};
    const Image<MapTexel> map = fill_span_map(solid, area, 2);
    ASSERT_EQ(map.width(), 40u);
    ASSERT_EQ(map.height(), 36u);
    for (std::uint32_t y = 0; y < 36; ++y)
        for (std::uint32_t x = 0; x < 40; ++x) {
            MapTexel expected(no_owner, 0, 0, 0);
            for (const Span& span : solid.row(y + 7))
                if (x + 5 >= span.x && x + 5 < span.x + span.count)
                    expected = {span.map, span.x, span.count, 0};
            EXPECT_EQ(map(x, y), expected) << x << " " << y;
        }
}

TEST(SpanMapTest, PartsAreOfTheirWholeSpans) {
    SolidAtlas solid = SyntheticAtlas{8, 8}.make(2);
    solid.wholes.assign(solid.spans.size(), {0, 8});
    for (Span& span : solid.spans) span.x += 3, span.count -= 4;
    const Image<MapTexel> map = fill_span_map(solid, {0, 0, 8, 8}, 1);
    EXPECT_EQ(map(2, 5), MapTexel(no_owner, 0, 0, 0));
    EXPECT_EQ(map(3, 5), MapTexel(0, 0, 8, 0));
    EXPECT_EQ(map(6, 5), MapTexel(0, 0, 8, 0));
    EXPECT_EQ(map(7, 5), MapTexel(no_owner, 0, 0, 0));
}

}  // namespace
}  // namespace burl
