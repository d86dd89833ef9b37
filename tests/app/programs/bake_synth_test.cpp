// `burl bake --synth`: the host's bytes through OpenGL, and what it refuses.
#include <gmock/gmock.h>

#include "atlas/base/json.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

using test::Outcome;
using test::run_burl;
using test::Scratch;
using testing::HasSubstr;

/// Skipped where there is no OpenGL.
class BakeSynth : public GlTest {
  protected:
    Outcome bake(const std::string& name, const std::string& options) {
        return run_burl(scratch,
                        "bake sample:cube -s 64 --quiet -o '" + scratch / name + "' " + options);
    }
    Scratch scratch;
};

TEST_F(BakeSynth, OpenGlWritesTheHostsBytesAndSaysWhatItDid) {
    ASSERT_EQ(bake("host.png", "--synth host").exit_code, 0);
    const Outcome drawn = bake("gl.png", "--synth gl --report '" + scratch / "gl.json" + "'");
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
    EXPECT_EQ(test::slurp(scratch / "host.png"), test::slurp(scratch / "gl.png"));
    const auto report = nlohmann::json::parse(test::slurp(scratch / "gl.json"))["synthesis"];
    EXPECT_THAT(report["by"].get<std::string>(), HasSubstr("OSMesa"));
    EXPECT_EQ(report["passes"], 1);
    EXPECT_GT(report["seconds"]["compile"].get<double>(), 0.0);
}

TEST_F(BakeSynth, AutoIsTheHostOnSoftwareOpenGl) {
    const Outcome baked = bake("a.png", "--synth auto --report '" + scratch / "a.json" + "'");
    ASSERT_EQ(baked.exit_code, 0) << baked.err;
    EXPECT_FALSE(nlohmann::json::parse(test::slurp(scratch / "a.json")).contains("synthesis"));
}

TEST_F(BakeSynth, AutoIsTheHostForAMaterialsPictures) {
    const Outcome refused = bake("a.png", "-r oak --synth gl");
    EXPECT_EQ(refused.exit_code, int(ExitCode::usage));
    EXPECT_THAT(refused.err, HasSubstr("--synth gl: the recipe's material varies"));
    for (const char* platform : {"osmesa", "egl"}) {
        const std::string by_auto = std::string("-r oak --synth auto --force --gl ") + platform;
        ASSERT_EQ(bake("a.png", by_auto).exit_code, 0) << platform;
        ASSERT_EQ(bake("host.png", "-r oak").exit_code, 0);
        for (const char* end : {".png", "_roughness.png"})
            EXPECT_EQ(test::slurp(scratch / std::string("a") + end),
                      test::slurp(scratch / std::string("host") + end))
                << platform << end;
    }
}

TEST_F(BakeSynth, OpenGlThatNobodyAskedForIsRefused) {
    for (const char* options : {"--gl osmesa", "--gl egl --synth host"}) {
        const Outcome refused = bake("a.png", options);
        EXPECT_EQ(refused.exit_code, int(ExitCode::usage)) << options;
        EXPECT_THAT(refused.err, HasSubstr("--synth")) << options;
    }
    EXPECT_EQ(bake("a.png", "--gl osmesa --synth gl").exit_code, 0);
}

TEST_F(BakeSynth, WhatOpenGlCannotDoIsRefusedOrLeftToTheHost) {
    for (const char* option : {"--precision float64", "--kernel scanline", "--kernel forward"}) {
        const Outcome refused = bake("b.png", std::string("--synth gl ") + option);
        EXPECT_NE(refused.exit_code, 0) << option;
        EXPECT_THAT(refused.err, HasSubstr("--synth gl")) << option;
        EXPECT_EQ(bake("b.png", std::string("--synth auto ") + option).exit_code, 0) << option;
    }
}

}  // namespace
}  // namespace burl
