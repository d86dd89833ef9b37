#include "app/base/version.h"
#include "atlas/base/error.h"
#include "procedural/batch/texel_batch.h"
#include "procedural/numbers/simd_target.h"
#include "tests/benchmarks/micro_benchmarks.h"

namespace {

constexpr std::string_view simd_option = "--simd=";

/// Takes --simd=LEVEL from the command line, where Google Benchmark would not know it.
void take_simd(int& argc, char** argv) {
    int kept = 1;
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (argument.starts_with(simd_option))
            burl::limit_simd(std::string(argument.substr(simd_option.size())));
        else
            argv[kept++] = argv[i];
    }
    argc = kept;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        take_simd(argc, argv);
    } catch (const burl::Error& error) {
        fprintf(stderr, "burl_benchmarks: %s\n", error.what());
        return int(error.code());
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::AddCustomContext("simd", burl::simd_level());
    burl::register_stream_benchmarks();
    burl::register_color_benchmarks();
    burl::register_baseline_benchmarks();
    burl::register_map_benchmarks();
    benchmark::RunSpecifiedBenchmarks();
}
