// `burl bake --no-skip`, `--cache` and the stages of its report.
#include <fmt/format.h>

#include "atlas/base/json.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run_burl;
using test::Scratch;

/// The report's stages of an animation of one term's amplitude; its pictures lie beside it.
json animate(const Scratch& scratch, const std::string& name, const std::string& options = "") {
    const Outcome outcome =
        run_burl(scratch, fmt::format("bake sample:cube -s 64 -o '{}' --json --animate "
                                      "texture.input.noise.0.amplitude=0.5:0.7 --frames 3 {}",
                                      scratch / (name + ".png"), options));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out)["stages"];
}

std::string frames(const Scratch& scratch, const std::string& name) {
    std::string bytes;
    for (int i = 1; i <= 3; ++i)
        bytes += test::slurp(scratch / fmt::format("{}.{:04}.png", name, i));
    return bytes;
}

TEST(BakeEconomy, ReportsWhatStagesDidAndSpared) {
    const Scratch scratch;
    const json stages = animate(scratch, "kept");
    EXPECT_EQ(stages["layout"]["runs"], 1);
    EXPECT_EQ(stages["layout"]["kept"], 2);
    EXPECT_EQ(stages["layout"]["triangles"]["skipped"],
              2 * stages["layout"]["triangles"]["done"].get<int>());
    const json& synthesis = stages["synthesis"];
    EXPECT_EQ(synthesis["runs"], 3);
    EXPECT_EQ(synthesis["bytes"]["done"], 3 * 64 * 64 * 3);
    const auto texels = synthesis["texels"]["done"].get<std::uint64_t>();
    EXPECT_EQ(synthesis["octaves"]["done"].get<std::uint64_t>(), 4 * texels / 3);
    EXPECT_EQ(synthesis["octaves"]["skipped_by"]["kept-terms"].get<std::uint64_t>(),
              8 * texels / 3);

    const json bare = animate(scratch, "bare", "--no-skip kept-terms --no-skip stages");
    EXPECT_EQ(bare["layout"]["runs"], 3);
    EXPECT_FALSE(bare["synthesis"]["octaves"]["skipped_by"].contains("kept-terms"));
    const json small = animate(scratch, "small", "--cache 0");
    EXPECT_EQ(small["layout"]["runs"], 1);
    EXPECT_EQ(small["synthesis"]["octaves"]["done"].get<std::uint64_t>(), 4 * texels);
    EXPECT_EQ(frames(scratch, "kept"), frames(scratch, "bare"));
    EXPECT_EQ(frames(scratch, "kept"), frames(scratch, "small"));
    EXPECT_GT(frames(scratch, "kept").size(), 1000u);
}

TEST(BakeEconomy, RefusesASkipThatThereIsNot) {
    const Scratch scratch;
    const Outcome outcome =
        run_burl(scratch, "bake sample:cube -o '" + scratch / "a.png" + "' --no-skip thinking");
    EXPECT_EQ(outcome.exit_code, 1);
    test::expect_one_sentence(outcome.err);
    EXPECT_EQ(scratch.files(), 0u);
}

}  // namespace
}  // namespace burl
