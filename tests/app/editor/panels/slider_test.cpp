// Where values lie along a slider.
#include "app/editor/widgets/slider.h"

#include <gtest/gtest.h>

namespace burl {
namespace {

TEST(Slider, PlacesValuesByDifferencesOrByFactors) {
    EXPECT_DOUBLE_EQ(share_of(2.5, {2.0, 4.0}, SliderScale::linear), 0.25);
    EXPECT_DOUBLE_EQ(share_of(0.0, {-1.0, 3.0}, SliderScale::linear), 0.25);
    EXPECT_DOUBLE_EQ(share_of(1.0, {0.01, 100.0}, SliderScale::logarithmic), 0.5);
    EXPECT_DOUBLE_EQ(share_of(0.1, {0.01, 100.0}, SliderScale::logarithmic), 0.25);
    for (const SliderScale scale : {SliderScale::linear, SliderScale::logarithmic}) {
        EXPECT_EQ(share_of(1.0, {1.0, 8.0}, scale), 0.0);
        EXPECT_EQ(share_of(8.0, {1.0, 8.0}, scale), 1.0);
        EXPECT_EQ(share_of(0.5, {1.0, 8.0}, scale), 0.0);
        EXPECT_EQ(share_of(99.0, {1.0, 8.0}, scale), 1.0);
    }
    EXPECT_EQ(share_of(5.0, {5.0, 5.0}, SliderScale::linear), 0.0) << "a range of no length";
}

}  // namespace
}  // namespace burl
