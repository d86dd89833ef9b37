#pragma once
// The command line of `burl bench`: its suites, the options that each accepts, and how each reports
// its results.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "atlas/base/json.h"
#include "atlas/base/named_files.h"

namespace burl {

/// The parsed command line.
struct BenchCommand {
    std::string suite, file, out;
    std::vector<std::string> recipes;      ///< recipes to use; empty: the suite's default
    NamedFiles named = NamedFiles::below;  ///< where the images of recipes may lie
    std::string simd;                      ///< instruction set; empty: the machine's best
    std::string gl = "osmesa";             ///< OpenGL platform (app/gl/device/context.h)
    /// The suite's size (--size); 0: its default.
    std::size_t size = 0;
    int repeats = 5;
    bool large = false, json = false;
    bool thorough = false;  ///< stability: whether all cases are run
    std::string one{};      ///< stability: the case of --case

    std::size_t size_or(std::size_t usual) const { return size == 0 ? usual : size; }
};

/// Checks the options given on the command line (with their dashes): options without effect are
/// refused, and so are sizes that a suite cannot hold in memory or in its batches. Throws
/// Error(usage).
void check_bench(const BenchCommand& command, const std::vector<std::string>& given);

/// Returns the help for --size: unit, bounds and default of each suite.
std::string bench_size_help();

/// Returns the names of the suites, sorted.
std::vector<std::string> bench_suite_names();

/// Writes the suite's rows with a description of the machine and the library versions, to the
/// output file if there is one, and to stdout with --json.
void write_report(const BenchCommand& command, const Json& rows);

/// Reports to_json(row) of every row through write_report(). Returns whether tables should be
/// printed, too.
template <class Rows, class ToJson>
bool report_rows(const BenchCommand& command, const Rows& rows, const ToJson& to_json) {
    Json list = Json::array();
    for (const auto& row : rows) list.push_back(to_json(row));
    write_report(command, list);
    return !command.json;
}

/// Reports a suite whose rows have no columns of their own, and prints their table.
void report_results(const BenchCommand& command, std::span<const BenchResult> results);

// Each function runs the suite of its name, prints its tables and writes the report.
void run_atlas_bench(const BenchCommand& command);
void run_filter_bench(const BenchCommand& command);
void run_forward_bench(const BenchCommand& command);
void run_kernels_bench(const BenchCommand& command);
void run_levels_bench(const BenchCommand& command);
void run_mesh_io_bench(const BenchCommand& command);
void run_noise_bench(const BenchCommand& command);
void run_precision_bench(const BenchCommand& command);
void run_resynthesis_bench(const BenchCommand& command);
void run_rivals_bench(const BenchCommand& command);
void run_scale_bench(const BenchCommand& command);
void run_synthesis_bench(const BenchCommand& command);
void run_uv_bench(const BenchCommand& command);
// Defined in app/bench/gl.
void run_economy_bench(const BenchCommand& command);
void run_editor_bench(const BenchCommand& command);
void run_gl_bench(const BenchCommand& command);
void run_open_bench(const BenchCommand& command);
// Defined in tests/stability, which a program that calls it links (burl_stability).
void run_stability_bench(const BenchCommand& command);

}  // namespace burl
