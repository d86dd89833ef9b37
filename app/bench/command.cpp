#include "app/bench/command.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

#include <fmt/format.h>

#include "app/measure/report.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "procedural/batch/texel_batch.h"

namespace burl {

namespace {

/// A suite's name and the options that it accepts.
struct Suite {
    std::string_view name;
    std::string_view options;    ///< accepted options besides -o, which every suite has
    std::string_view size_of{};  ///< unit of --size; empty: --size is not accepted
    std::size_t least = 0, most = 0;
    std::string_view otherwise{};  ///< size without --size, for the help
    bool halved = false;           ///< whether --size must be a power of two, for quad atlases

    std::string bounds() const;
};

/// Sizes are bounded from above by memory (a filter or an error takes some 100 bytes per texel),
/// and from below by the meshes' triangles.
constexpr std::array suites{
    Suite{"atlas", "--repeats --large --json", "faces", 12, 10'000'000, "1,000 to 100,000"},
    Suite{"economy", "--repeats --json --simd --gl", "texels a side", 128, 4096, "1,024", true},
    Suite{"editor", "--json --simd --gl", "texels a side", 64, 4096, "1,024"},
    Suite{"filter", "--repeats --json --simd", "texels a side", 8, 4096, "256"},
    Suite{"forward", "--repeats --json --simd", "texels a side of the cubes' faces", 2,
          batch_capacity, "256"},
    Suite{"gl", "--repeats --json --simd --gl", "texels a side", 8, 4096, "256 and 1,024"},
    Suite{"kernels", "--repeats --json --simd", "texels of a span", 1, 16384, "16"},
    Suite{"levels", "--repeats --json --simd --recipe", "texels a side", 64, 4096, "512"},
    Suite{"mesh_io", "--repeats --json", "faces", 12, 10'000'000, "1,000,000"},
    Suite{"noise", "--repeats --json --simd", "samples, in batches of 1,024", batch_capacity,
          10'000'000, "65,536"},
    Suite{"open", "--json --simd", "faces", 12, 10'000'000, "1,000,000"},
    Suite{"precision", "--repeats --json --simd", "texels a side", 8, 4096, "512"},
    Suite{"resynthesis", "--repeats --json --simd --recipe", "texels a side", 8, 4096, "1,024"},
    Suite{"rivals", "--repeats --json --simd", "texels a side", 32, batch_capacity, "512"},
    Suite{"scale", "--large --json"},
    Suite{"stability", "--json --simd --thorough --case"},
    Suite{"synthesis", "--repeats --json --simd --recipe", "texels a side", 8, 4096, "1,024"},
    Suite{"uv", "--json", "texels a side", 16, 4096, "512"},
};

/// The suites that take a mesh file.
constexpr std::array<std::string_view, 4> with_files{"synthesis", "resynthesis", "levels", "uv"};

bool has_word(std::string_view words, std::string_view word) {
    return fmt::format(" {} ", words).find(fmt::format(" {} ", word)) != std::string::npos;
}

/// Formats 4096 as "4,096".
std::string grouped(std::size_t number) {
    if (number < 1000) return std::to_string(number);
    return fmt::format("{},{:03}", grouped(number / 1000), number % 1000);
}

/// Returns the accepted sizes, such as "a power of two from 128 to 4,096".
std::string Suite::bounds() const {
    const std::string range = fmt::format("{} to {}", grouped(least), grouped(most));
    return halved ? "a power of two from " + range : range;
}

void check_option(const Suite& suite, const std::string& option) {
    if (option == "-o" || has_word(suite.options, option)) return;
    if (option == "--size" && !suite.size_of.empty()) return;
    throw Error(ExitCode::usage,
                fmt::format("bench {0}: {1} does nothing there, leave it out", suite.name, option));
}

void check_size(const Suite& suite, std::size_t size) {
    const bool bounded = size >= suite.least && size <= suite.most;
    if (bounded && (!suite.halved || std::has_single_bit(size))) return;
    throw Error(ExitCode::usage, fmt::format("bench {}: --size {} must be {} {}", suite.name, size,
                                             suite.bounds(), suite.size_of));
}

void check_files(const BenchCommand& command) {
    const bool takes_mesh = std::ranges::find(with_files, command.suite) != with_files.end();
    if (!takes_mesh && !command.file.empty())
        throw Error(ExitCode::usage, fmt::format("bench {}: only {} take a file, {}", command.suite,
                                                 fmt::join(with_files, ", "), command.file));
}

}  // namespace

void check_bench(const BenchCommand& command, const std::vector<std::string>& given) {
    const Suite& suite = *std::ranges::find(suites, command.suite, &Suite::name);
    for (const std::string& option : given) check_option(suite, option);
    const bool sized = std::ranges::find(given, "--size") != given.end();
    if (sized) check_size(suite, command.size);
    if (sized && command.large)
        throw Error(ExitCode::usage,
                    "bench atlas: --size names one number of faces and --large adds one to the "
                    "usual three, give one of them");
    check_files(command);
}

std::string bench_size_help() {
    std::string text;
    for (const Suite& suite : suites) {
        if (suite.size_of.empty()) continue;
        if (!text.empty()) text += "; ";
        text += fmt::format("{}: {}, {}, {} unless given", suite.name, suite.size_of,
                            suite.bounds(), suite.otherwise);
    }
    return text;
}

std::vector<std::string> bench_suite_names() {
    std::vector<std::string> names;
    for (const Suite& suite : suites) names.emplace_back(suite.name);
    return names;
}

void write_report(const BenchCommand& command, const Json& rows) {
    const Json report = {{"suite", command.suite},
                         {"repeats", command.repeats},
                         {"machine", machine_json()},
                         {"rows", rows},
                         {"versions", versions_json()}};
    if (!command.out.empty()) write_json(command.out, report);
    if (command.json) write_json("-", report);
}

void report_results(const BenchCommand& command, std::span<const BenchResult> results) {
    if (report_rows(command, results, result_json)) fmt::print("{}", result_table(results));
}

}  // namespace burl
