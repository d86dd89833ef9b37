#pragma once
// What `burl bench` was asked for, and the report that every suite ends with.
#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/measure/report.h"

namespace burl {

/// `size`: 0 is the suite's own.
struct BenchCommand {
    std::string suite, file, out;
    std::vector<std::string> recipes;  ///< empty: the suite's own
    std::string simd;                  ///< empty: the machine's best
    std::string gl = "osmesa";         ///< where OpenGL comes from (app/gl/device/context.h)
    std::size_t size = 0;
    int repeats = 5;
    bool large = false, json = false;
    bool thorough = false;  ///< stability
    std::string one{};      ///< its --case
};

/// Writes the suite's rows with the machine and the versions: to the file asked for, and to stdout
/// with --json.
void write_report(const BenchCommand& command, const Json& rows);

/// write_report of to_json(row) for every row; whether tables are wanted on stdout, too.
template <class Rows, class ToJson>
bool report_rows(const BenchCommand& command, const Rows& rows, const ToJson& to_json) {
    Json list = Json::array();
    for (const auto& row : rows) list.push_back(to_json(row));
    write_report(command, list);
    return !command.json;
}

/// The suite `forward`: runs it, prints and reports.
void run_forward_bench(const BenchCommand& command);
/// The suite `economy`.
void run_economy_bench(const BenchCommand& command);
/// The suite `stability`, or one of its cases.
void run_stability_bench(const BenchCommand& command);

}  // namespace burl
