#pragma once
// The command line of `burl bench`, and the report of every suite.
#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/measure/report.h"

namespace burl {

/// The parsed command line.
struct BenchCommand {
    std::string suite, file, out;
    std::vector<std::string> recipes;  ///< recipes to use; empty: the suite's default
    std::string simd;                  ///< instruction set; empty: the machine's best
    std::string gl = "osmesa";         ///< OpenGL platform (app/gl/device/context.h)
    /// The suite's size (--size); 0: its default.
    std::size_t size = 0;
    int repeats = 5;
    bool large = false, json = false;
    bool thorough = false;  ///< stability: whether all cases are run
    std::string one{};      ///< stability: the case of --case
};

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

/// Runs the suite `forward`, prints its tables and writes the report.
void run_forward_bench(const BenchCommand& command);
/// Runs the suite `economy`, prints its tables and writes the report.
void run_economy_bench(const BenchCommand& command);
/// Runs the suite `stability`, or one of its cases, prints and writes the report. Defined by the
/// library burl_stability (tests/stability/), which the program links: app/ includes no tests.
void run_stability_bench(const BenchCommand& command);

}  // namespace burl
