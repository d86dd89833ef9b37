#include "app/bake/report.h"

#include <gtest/gtest.h>

#include "atlas/base/json.h"

namespace burl {
namespace {

std::string summary_of(const Json& report) {
    testing::internal::CaptureStdout();
    print_summary(report, {"a.glb"});
    return testing::internal::GetCapturedStdout();
}

TEST(Report, SummarySaysHowManyAtlasesThereAre) {
    Json report = {{"mesh", {{"triangles", 12}}}, {"seconds", {{"total", 0.5}}}};
    report["atlas"] = {{"kind", "chart"},
                       {"width", 64},
                       {"height", 32},
                       {"coverage", 0.5},
                       {"relative_scale", 0.75}};
    const std::string one =
        "a.glb: 12 triangles, chart atlas 64 x 32, coverage 50.0 %, relative scale 0.75, 0.50 s";
    EXPECT_EQ(summary_of(report), one + "\n");
    report["others"] = {Json::object(), Json::object()};
    EXPECT_EQ(summary_of(report), one + "; the first of 3 atlases\n");
}

}  // namespace
}  // namespace burl
