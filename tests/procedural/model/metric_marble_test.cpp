// The measuring texture against values of a second implementation (Python, from the 2002 paper's
// reference program and the formula in metric_marble.h).
#include "procedural/model/metric_marble.h"

#include <gtest/gtest.h>

namespace burl {
namespace {

TEST(MetricMarble, AgreesWithASecondImplementation) {
    EXPECT_NEAR(metric_marble({0.0, 0.0, 0.0}), 0.8675616637124992, 1e-12);
    EXPECT_NEAR(metric_marble({0.5, -0.25, 0.125}), 0.8731659424181152, 1e-12);
    EXPECT_NEAR(metric_marble({-0.7, 0.3, 0.6}), 0.9811467201620794, 1e-12);
    EXPECT_NEAR(metric_marble({0.1, 0.9, -0.4}), 0.9853377861723375, 1e-12);
}

}  // namespace
}  // namespace burl
