// burl-edit as a program: under a display of its own (Xvfb) and without one, the same pixels; and
// one sentence where there is neither.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "app/image/image_io.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

constexpr const char* script = R"({"burl_input": 1, "size": [640, 400], "steps": [
    {"settle": true}, {"click": "tab:Parameters"}, {"wait": 2},
    {"drag": "solid.scale", "by": [30, 0]}, {"events": [{"move": [1, 1]}]},
    {"settle": true}, {"wait": 3}, {"screenshot": "end"}]})";

/// Plays the script; its pictures go into a folder of this name, which it makes.
test::Outcome play(const test::Scratch& scratch, const std::string& shots,
                   const std::string& more = "", const std::string& prefix = "") {
    return test::run_program(
        scratch, "burl-edit",
        fmt::format(
            "sample:cube --recipe marble --light headlight --set atlas.size=64 --set atlas.tries=1 "
            "--script '{}' "
            "--screenshot-dir '{}' --exit {}",
            scratch / "s.json", scratch / shots, more),
        prefix);
}

TEST(EditDesktop, AWindowShowsWhatIsDrawnWithoutOne) {
    if (std::system("command -v xvfb-run >/dev/null") != 0) GTEST_SKIP() << "xvfb is not installed";
    const test::Scratch scratch;
    scratch.write("s.json", script);
    const test::Outcome unseen = play(scratch, "unseen", "--unseen");
    ASSERT_EQ(unseen.exit_code, 0) << unseen.err;
    // Drivers of displays leave some strings behind, in libraries that are gone by the time the
    // leak checker looks; the same script without a window is checked above.
    const test::Outcome seen = play(scratch, "seen", "",
                                    "ASAN_OPTIONS=detect_leaks=0 xvfb-run -a -s '-screen 0 "
                                    "800x600x24'");
    ASSERT_EQ(seen.exit_code, 0) << seen.err;
    const Image<Rgb8> a = read_png(scratch / "unseen/end.png");
    const Image<Rgb8> b = read_png(scratch / "seen/end.png");
    ASSERT_EQ(a.width(), 640u);
    ASSERT_EQ(b.width(), 640u);
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i)
        different += a.pixels()[i] == b.pixels()[i] ? 0 : 1;
    EXPECT_LT(different, 100u);
}

TEST(EditDesktop, WithoutADisplayItSaysSo) {
    const test::Scratch scratch;
    const test::Outcome run =
        test::run_program(scratch, "burl-edit", "sample:cube", "env -u DISPLAY -u WAYLAND_DISPLAY");
    EXPECT_EQ(run.exit_code, 5);
    EXPECT_NE(run.err.find("no window can be opened"), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
}

TEST(EditDesktop, AnUnknownOptionIsAWrongCommandLine) {
    const test::Scratch scratch;
    const test::Outcome run = test::run_program(scratch, "burl-edit", "--nonsense");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.err.find("--nonsense"), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
    EXPECT_EQ(test::run_program(scratch, "burl-edit", "--recipie oak").err,
              "burl-edit: there is no option --recipie; did you mean --recipe? "
              "burl-edit --help lists the options\n");
    EXPECT_EQ(test::run_program(scratch, "burl-edit", "a.obj b.obj").err,
              "burl-edit: nothing takes \"b.obj\"; burl-edit --help lists the options\n");
    EXPECT_EQ(test::run_program(scratch, "burl-edit", "--help").exit_code, 0);
    const test::Outcome manual = test::run_program(scratch, "burl-edit", "--manual nope");
    EXPECT_EQ(manual.exit_code, 1);
    EXPECT_EQ(manual.err, "burl-edit: --manual nope: must be man, bash, zsh or fish\n");
}

TEST(EditDesktop, TwoRecipesAreAWrongCommandLine) {
    const test::Scratch scratch;
    const test::Outcome run = test::run_program(scratch, "burl-edit", "my.json --recipe oak");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.err.find("my.json is a recipe, and --recipe names another"), std::string::npos)
        << run.err;
}

TEST(EditDesktop, ARecipeAloneIsShownOnTheTeapot) {
    const test::Scratch scratch;
    scratch.write("s.json", R"({"burl_input": 1, "size": [400, 300], "steps": [
        {"settle": true}, {"wait": 2}, {"screenshot": "end"}]})");
    scratch.write("r.json", R"({"burl": 1, "texture": {"node": "constant", "value": "#804020"},
        "atlas": {"size": 64, "tries": 1}})");
    const auto shown = [&](const std::string& what, const std::string& name) {
        const test::Outcome run =
            test::run_program(scratch, "burl-edit",
                              fmt::format("{} --script '{}' --screenshot-dir '{}' --exit --unseen",
                                          what, scratch / "s.json", scratch / name));
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return read_png(scratch / (name + "/end.png"));
    };
    const std::string recipe = fmt::format("'{}'", (scratch / "r.json"));
    EXPECT_EQ(shown(recipe, "alone"), shown("sample:teapot --recipe " + recipe, "both"));
}

TEST(EditDesktop, AScriptThatIsWrongIsNamed) {
    const test::Scratch scratch;
    scratch.write("s.json", R"({"burl_input": 1, "steps": [{"clack": "x"}]})");
    const test::Outcome run = play(scratch, "x", "--unseen");
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_NE(run.err.find("steps.0"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace burl
