// The plot of a report: what is marked, what cannot be drawn, and that labels keep apart.
#include "app/bench/plot.h"

#include <cstdio>
#include <random>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/bench/svg_text.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++n;
    return n;
}

Json row(const char* group, const char* method, Json ns, Json error) {
    return {{"group", group},
            {"method", method},
            {"unit", "texel"},
            {"ns_median", ns},
            {"error_rms", error}};
}

TEST(BenchPlot, MarksWhatNothingBeatsInBoth) {
    const Json report{
        {"suite", "test"},
        {"rows",
         Json::array({row("a<b", "quick & rough", 1.0, 0.1), row("a<b", "slow", 10.0, 0.01),
                      row("a<b", "slow and rough", 12.0, 0.05), row("a<b", "exact", 100.0, 0.0),
                      row("a<b", "no figure", 2.0, nullptr), row("a<b", "untimed", nullptr, 0.1),
                      row("c", "slow", 3.0, 0.2)})}};
    const std::string svg = bench_plot(report, "test.json");
    // quick, slow, exact, and slow again in the other panel, where it is alone.
    EXPECT_EQ(count(svg, "stroke=\"#000000\" stroke-width=\"1.4\""), 4u);
    EXPECT_EQ(count(svg, "stroke-width=\"0.7\""), 2u + 5u) << "those beaten, and the legend";
    EXPECT_NE(svg.find("quick &amp; rough"), std::string::npos);
    EXPECT_NE(svg.find("a&lt;b"), std::string::npos);
    EXPECT_EQ(svg.find("untimed"), std::string::npos);
    EXPECT_EQ(count(svg, ">0</text>"), 1u) << "the place of what has no error";
    EXPECT_EQ(count(svg, ">?</text>"), 1u);
    EXPECT_EQ(count(svg, "RMS error"), 2u);
    EXPECT_EQ(count(svg, "<g "), count(svg, "</g>"));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(BenchPlot, RefusesWhatItCannotDraw) {
    const std::vector<Json> wrong{Json::array(),
                                  Json{{"rows", 3}},
                                  Json{{"rows", Json::array()}},
                                  Json{{"rows", Json::array({1, 2})}},
                                  Json{{"rows", Json::array({row("g", "m", 1.0, nullptr)})}},
                                  Json{{"rows", Json::array({row("g", "m", -1.0, 0.1)})}},
                                  Json{{"rows", Json::array({row("g", "m", "fast", "good")})}}};
    for (const Json& report : wrong) {
        try {
            bench_plot(report, "wrong.json");
            FAIL() << report;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::invalid_file);
            EXPECT_TRUE(std::string(error.what()).starts_with("wrong.json: ")) << error.what();
        }
    }
    // Extremes are drawn.
    EXPECT_GT(
        bench_plot(
            Json{{"rows", Json::array({row("g", "m", 1e300, 1e-300), row("g", "n", 1e-3, 1e9)})}},
            "far.json")
            .size(),
        1000u);
}

/// Numbers of a path's points, in order.
std::vector<double> path_numbers(const std::string& svg, std::size_t at) {
    std::vector<double> numbers;
    std::string path = svg.substr(at, svg.find('"', at) - at);
    for (char& c : path) c = c == 'M' || c == 'L' ? ' ' : c;
    std::istringstream stream(path);
    for (double x = 0.0; stream >> x;) numbers.push_back(x);
    return numbers;
}

TEST(BenchPlot, DrawsStepsAsCurves) {
    const auto step = [](const char* method, double cells, double ns, double error) {
        return Json{{"function", "smooth"},
                    {"method", method},
                    {"step_cells", cells},
                    {"ns_per_texel", ns},
                    {"error", error}};
    };
    const Json report{
        {"suite", "forward"},
        {"rows", Json::array({step("exact", 0.1, 100.0, 0.0), step("exact", 1.0, 100.0, 0.0),
                              step("quick", 1.0, 10.0, 1e-3), step("quick", 0.1, 1.0, 1e-5),
                              Json{{"texture", "cube"}, {"milliseconds", 3.0}}, Json(4)})}};
    const std::string svg = bench_plot(report, "forward.json");
    EXPECT_EQ(count(svg, "font-weight=\"bold\">smooth</text>"), 2u) << "times, and errors";
    EXPECT_EQ(count(svg, ">ns per texel<"), 1u);
    EXPECT_EQ(count(svg, ">largest error<"), 1u);
    // What has no error has no curve there.
    EXPECT_EQ(count(svg, "stroke-width=\"1.2\""), 3u);
    EXPECT_EQ(count(svg, "stroke-width=\"0.7\""), 6u + 2u) << "points, and the legend";
    // Sorted by step: x and time grow along the second curve, which is ten times as far down.
    const std::size_t first = svg.find("<path d=\"M") + 9;
    const std::vector<double> slow = path_numbers(svg, first),
                              quick = path_numbers(svg, svg.find("<path d=\"M", first) + 9);
    ASSERT_EQ(slow.size(), 4u);
    ASSERT_EQ(quick.size(), 4u);
    EXPECT_EQ(slow[1], slow[3]);
    EXPECT_LT(quick[0], quick[2]);
    EXPECT_NEAR(quick[1] - quick[3], quick[3] - slow[3], 0.2) << "a decade each";
    EXPECT_EQ(count(svg, "<g "), count(svg, "</g>"));
    EXPECT_EQ(svg.find("nan"), std::string::npos);

    const Json kernels{{"rows", Json::array({{{"noise", "perlin"},
                                              {"crossings_per_texel", 0.5},
                                              {"ns_direct", 3.0},
                                              {"ns_share", 2.0}}})}};
    const std::string pair = bench_plot(kernels, "kernels.json");
    EXPECT_NE(pair.find(">share</text>"), std::string::npos);
    EXPECT_NE(pair.find("lattice planes a texel crosses"), std::string::npos);
}

TEST(BenchPlot, DrawsSharesAsBars) {
    const auto group = [](const char* name, Json share, double error) {
        return Json{{"group", name}, {"cases", 3}, {"share", share}, {"error", error}};
    };
    const Json report{{"suite", "stability"},
                      {"rows", Json::array({group("far", 0.1, 1e-9), group("near & far", 1.0, 1e-7),
                                            group("too much", 10.0, 1e-6), group("jumps", 0.0, 0.0),
                                            group("unknown", nullptr, 0.0)})}};
    const std::string svg = bench_plot(report, "stability.json");
    EXPECT_EQ(count(svg, "<rect y="), 4u);
    EXPECT_EQ(count(svg, "fill=\"#D55E00\""), 1u) << "the one beyond what is allowed";
    EXPECT_EQ(count(svg, ">none</text>"), 1u);
    EXPECT_NE(svg.find("near &amp; far"), std::string::npos);
    EXPECT_EQ(svg.find("unknown"), std::string::npos);
    std::vector<double> widths;
    for (std::size_t at = svg.find("<rect y="); at != std::string::npos;
         at = svg.find("<rect y=", at + 1))
        widths.push_back(std::stod(svg.substr(svg.find("width=\"", at) + 7)));
    EXPECT_NEAR(widths[2] - widths[1], widths[1] - widths[0], 0.2) << "decades are alike";
    EXPECT_EQ(widths[3], 0.0);
}

TEST(SvgLabels, KeepApartAndInside) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(5.0, 195.0);
    SvgLabels labels({0, 0, 200, 200});
    std::vector<SvgBox> boxes;
    for (int i = 0; i < 60; ++i) {
        const double x = 100 + (place(random) - 100) * (i < 30 ? 0.1 : 1.0), y = place(random);
        const std::string text = std::to_string(i);
        const std::string svg = labels.place(x, y, text);
        double cx = 0.0, cy = 0.0;
        const std::size_t at = svg.find("<text x=");
        ASSERT_NE(at, std::string::npos) << i;
        ASSERT_EQ(std::sscanf(svg.c_str() + at, "<text x=\"%lf\" y=\"%lf\"", &cx, &cy), 2) << svg;
        const double half = 0.45 * svg_width(text.size());
        boxes.push_back({cx - half, cy - 8, cx + half, cy - 1});
        EXPECT_GT(boxes.back().left, -1.0);
        EXPECT_LT(boxes.back().right, 201.0);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(boxes[i].overlaps(boxes[j])) << i << j;
}

}  // namespace
}  // namespace burl
