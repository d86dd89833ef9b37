// Options of `burl bench` that a suite has no use for are refused in a sentence that names the
// suite and the option, and so are sizes beyond a suite's bounds.
#include "app/bench/command.h"

#include <hwy/highway.h>

#include "app/base/version.h"
#include "atlas/base/error.h"
#include "procedural/batch/texel_batch.h"
#include "procedural/numbers/simd_target.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

struct BadBench {
    const char* arguments;
    const char* says;
};

class BadBenchOptions : public testing::TestWithParam<BadBench> {};

TEST_P(BadBenchOptions, AreRefusedInASentence) {
    const test::Scratch scratch;
    const test::Outcome outcome =
        test::run_burl(scratch, fmt::format("bench {}", GetParam().arguments));
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    test::expect_one_sentence(outcome.err);
    EXPECT_NE(outcome.err.find(GetParam().says), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("--set"), std::string::npos) << outcome.err;
    EXPECT_EQ(scratch.files(), 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Program, BadBenchOptions,
    testing::Values(
        BadBench{"stability --size 64", "bench stability: --size does nothing"},
        BadBench{"stability --repeats 3", "bench stability: --repeats does nothing"},
        BadBench{"kernels --large", "bench kernels: --large does nothing"},
        BadBench{"scale --size 1000", "bench scale: --size does nothing"},
        BadBench{"noise --recipe marble", "bench noise: --recipe does nothing"},
        BadBench{"mesh_io --simd AVX2", "bench mesh_io: --simd does nothing"},
        BadBench{"plot F.json -o F.svg", "suite: plot is none of atlas, "},
        BadBench{"noise F.json", "only synthesis, resynthesis, levels, uv take a file"},
        BadBench{"filter --size 10000000",
                 "bench filter: --size 10000000 must be 8 to 4,096 texels"},
        BadBench{"synthesis --size 9000", "bench synthesis: --size 9000 must be 8 to 4,096 texels"},
        BadBench{"precision --size 5000", "bench precision: --size 5000 must be"},
        BadBench{"forward --size 2000", "bench forward: --size 2000 must be 2 to 1,024 texels"},
        BadBench{"kernels --size 20000", "bench kernels: --size 20000 must be 1 to 16,384 texels"},
        BadBench{"noise --size 100", "bench noise: --size 100 must be 1,024 to 10,000,000"},
        BadBench{"mesh_io --size 0", "bench mesh_io: --size 0 must be 12 to 10,000,000 faces"},
        BadBench{"atlas --size 100 --large", "bench atlas: --size names one number of faces"},
        BadBench{"noise --gl egl", "bench noise: --gl does nothing"},
        BadBench{"gl --size 5000", "bench gl: --size 5000 must be 8 to 4,096 texels"},
        BadBench{"economy --size 64",
                 "bench economy: --size 64 must be a power of two from 128 to 4,096 texels a side"},
        BadBench{"economy --size 160", "bench economy: --size 160 must be a power of two"},
        BadBench{"gl --gl metal", "--gl metal: it must be osmesa or egl"},
        BadBench{"noise --simd MMX", "--simd MMX: must be one of this machine's"},
        BadBench{"noise --size many", "--size"}, BadBench{"noise --repeats 0", "--repeats"},
        BadBench{"synthesis --recipe no-such-recipe", "no-such-recipe"}));

TEST(BenchOptions, AllowsWhatASuiteKnows) {
    BenchCommand command;
    command.suite = "atlas";
    command.size = 500;
    EXPECT_NO_THROW(check_bench(command, {"--size", "--repeats", "--json", "-o"}));
    command.suite = "synthesis";
    command.file = "mesh.obj";
    EXPECT_NO_THROW(check_bench(command, {"--size", "--simd", "--recipe"}));
    command.suite = "stability";
    command.file.clear();
    EXPECT_NO_THROW(check_bench(command, {"--json", "-o", "--simd"}));
    for (const std::string& suite : bench_suite_names())
        EXPECT_EQ(bench_size_help().find(suite + ": ") != std::string::npos,
                  suite != "stability" && suite != "scale");
}

TEST(SimdLimit, IsWhatTheKernelsThenRunOn) {
    const std::string best = simd_level();
    for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
        const std::string name = hwy::TargetName(left & -left);
        limit_simd(name);
        EXPECT_EQ(simd_level(), name);
        hwy::SetSupportedTargetsForTest(0);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
    EXPECT_EQ(simd_level(), best);
    EXPECT_THROW(limit_simd("AVX9"), Error);
    EXPECT_EQ(simd_level(), best);
}

}  // namespace
}  // namespace burl
