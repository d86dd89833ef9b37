// `--kernel forward`, `reference` and `scanline`: what they bake, and what they refuse.
#include <gtest/gtest.h>

#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

constexpr const char* tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

class ForwardBake : public testing::Test {
  protected:
    Scratch scratch_;
    std::string mesh_ = scratch_.write("t.obj", tetrahedron), out_ = scratch_ / "o.png";

    Outcome bake(const std::string& options) {
        return run_burl(scratch_,
                        fmt::format("bake '{}' -o '{}' -s 64 -a area -q {}", mesh_, out_, options));
    }
    /// The bytes it writes.
    std::string baked(const std::string& options) {
        const Outcome outcome = bake(options);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return slurp(out_);
    }
};

TEST_F(ForwardBake, IsTheBakeInFloat64) {
    for (const char* recipe : {"bresenham-marble", "planet"}) {
        const std::string options = fmt::format("-r {} --depth 16 ", recipe);
        const std::string forward = baked(options + "--kernel forward");
        EXPECT_EQ(forward, baked(options + "--precision float64"));
        EXPECT_NE(forward, baked(options));
    }
}

TEST_F(ForwardBake, DoesNotDependOnThreads) {
    const std::string options = "-r bresenham-wood --depth 16 --kernel forward ";
    EXPECT_EQ(baked(options + "-j 1"), baked(options + "-j 3"));
}

TEST_F(ForwardBake, AddsInThePrecisionAskedFor) {
    const std::string options = "-r bresenham-wood --depth 16 --kernel forward ";
    EXPECT_EQ(baked(options + "--precision float64"), baked(options));
    EXPECT_NE(baked(options + "--precision float32"), baked(options));
}

TEST_F(ForwardBake, RefusesInOneSentenceWhatHasNoPolynomial) {
    struct Refusal {
        const char *options, *says;
    };
    for (const auto& [options, says] :
         {Refusal{"-r checks", "other nodes than a color_map over a field"},
          {"--set texture.input.noise.0.kind=perlin", "only value noise"},
          {"--set texture.input.noise.0.time=1", "four dimensions"},
          {"--set texture.input.noise.0.sum=turbulence", "|n| is no polynomial"},
          {"--filter exact", "filters need f besides the scan line"},
          {"--set filter.octaves=fade", "filters need f besides the scan line"},
          {"--precision fixed:8.8", "not in fixed:I.F"},
          {"--animate texture.input.noise.0.time=0:1 --frames 3", "four dimensions"}}) {
        const Outcome outcome = bake(fmt::format("--kernel forward {}", options));
        EXPECT_EQ(outcome.exit_code, 1) << options << "\n" << outcome.err;
        expect_one_sentence(outcome.err);
        EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err;
        EXPECT_FALSE(fs::exists(out_)) << options;
    }
}

using ReferenceBake = ForwardBake;

TEST_F(ReferenceBake, IsTheBakeInFloat64) {
    for (const char* options : {"-r clouds --depth 16 ", "-r wood --filter exact "}) {
        const std::string reference = baked(fmt::format("{}--kernel reference", options));
        EXPECT_EQ(reference, baked(fmt::format("{}--precision float64", options)));
        EXPECT_EQ(reference,
                  baked(fmt::format("{}--kernel reference --precision float64", options)));
    }
}

TEST_F(ReferenceBake, RefusesAnotherPrecision) {
    for (const char* options :
         {"--precision float32", "--precision fixed:8.8", "--set precision.kind=float32"}) {
        const Outcome outcome = bake(fmt::format("--kernel reference {}", options));
        EXPECT_EQ(outcome.exit_code, 1) << options << "\n" << outcome.err;
        expect_one_sentence(outcome.err);
        EXPECT_NE(outcome.err.find("another precision"), std::string::npos) << outcome.err;
        EXPECT_FALSE(fs::exists(out_)) << options;
    }
}

TEST_F(ReferenceBake, ScanlineIsDirectButForRounding) {
    const auto made = [&](const std::string& kernel) {
        return baked("-r noise --depth 16 --set precision.kind=float32 --kernel " + kernel);
    };
    EXPECT_EQ(made("direct"), made("share"));
    EXPECT_NE(made("direct"), made("scanline"));
}

}  // namespace
}  // namespace burl::test
