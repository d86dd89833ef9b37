// `burl bake --synth gl-multipass`, run as a program.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "atlas/base/json.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

using test::Outcome;
using test::run_burl;
using test::Scratch;
using testing::HasSubstr;

class MultipassBake : public GlTest {
  protected:
    Outcome bake(const std::string& options, const std::string& recipe = "marble") const {
        return run_burl(scratch_,
                        fmt::format("bake sample:cube --recipe {} --size 64 --json -o '{}' {}",
                                    recipe, scratch_ / "cube.png", options));
    }
    Scratch scratch_;
};

TEST_F(MultipassBake, ReportsPassesBitsAndSeconds) {
    const Outcome outcome =
        bake("--synth gl-multipass --gl-precision 8 --gl-randomizer bits --gl-equalize");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(outcome.out)["synthesis"];
    EXPECT_EQ(report["precision"], "8");
    EXPECT_EQ(report["randomizer"], "bits");
    EXPECT_EQ(report["equalized"], true);
    ASSERT_EQ(report["octaves"].size(), 4u);
    int passes = 2;  // index and colours
    for (const auto& octave : report["octaves"]) passes += octave["passes"].get<int>();
    EXPECT_EQ(report["passes"], passes);
    EXPECT_THAT(report["octaves"][3]["bits"].get<std::string>(),
                testing::MatchesRegex("[1-7].[1-7]"));
    for (const char* part : {"draw", "gpu", "transfer", "maps", "compile"})
        EXPECT_TRUE(report["seconds"].contains(part)) << part;
}

TEST_F(MultipassBake, RefusesInOneSentence) {
    const auto refused = [&](const std::string& options, const std::string& why,
                             const std::string& recipe = "marble") {
        const Outcome outcome = bake(options, recipe);
        EXPECT_EQ(outcome.exit_code, 1) << options;
        test::expect_one_sentence(outcome.err);
        EXPECT_THAT(outcome.err, HasSubstr(why));
    };
    refused("--gl-precision 16f", "--synth gl-multipass");
    refused("--synth gl-multipass --gl-randomizer bits", "--gl-precision 8");
    refused("--synth gl-multipass --gl-equalize", "--gl-randomizer bits");
    refused("--synth gl-multipass --filter exact", "filters");
    refused("--synth gl-multipass", "color_map", "checks");
    refused("--synth gl-multipass --set texture.input.noise.0.fade=quintic", "smooth");
    refused("--synth gl-multipass --kernel scanline", "--kernel scanline");
}

}  // namespace
}  // namespace burl
