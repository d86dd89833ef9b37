// The tables of `burl bench forward`: forward differences beside direct evaluation.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/bench/command.h"
#include "app/bench/forward.h"

namespace burl {

namespace {

Json forward_json(const ForwardBench& row) {
    return {{"function", row.function},
            {"method", row.method},
            {"step_cells", row.step},
            {"ns_per_texel", row.ns_per_texel},
            {"error", row.error},
            {"cells_per_texel", row.cells_per_texel},
            {"runs_per_texel", row.runs_per_texel}};
}

Json cube_json(const CubeBench& row) {
    return {{"texture", row.texture},
            {"method", row.method},
            {"milliseconds", row.milliseconds},
            {"error", row.error},
            {"texels_with_other_codes", row.other_codes},
            {"largest_code_step", row.largest_step},
            {"cells", row.cells},
            {"runs", row.runs}};
}

Json growth_json(const GrowthBench& row) {
    Json errors = Json::array();
    for (const auto& [texel, largest] : row.errors)
        errors.push_back({{"texel_of_cell", texel}, {"error", largest}});
    return {{"noise", row.noise},
            {"frequency", row.frequency},
            {"precision", row.precision},
            {"errors", errors}};
}

/// Prints a table per function, with a line per method and a column cell(row) per step.
template <class Cell>
void print_steps(const std::vector<ForwardBench>& rows, const char* what, Cell&& cell) {
    std::string function, method;
    for (const ForwardBench& row : rows) {
        if (row.function != function) {
            fmt::print("\n{}: {}, by cells per texel\n{:<26}", row.function, what, "");
            for (const ForwardBench& one : rows)
                if (one.function == row.function && one.method == row.method)
                    fmt::print(" {:>8}", fmt::format("1/{:.0f}", 1.0 / one.step));
            method.clear();
        }
        if (row.method != method) fmt::print("\n{:<26}", row.method);
        fmt::print(" {:>8}", cell(row));
        function = row.function;
        method = row.method;
        if (&row == &rows.back() || (&row)[1].function != function) fmt::print("\n");
    }
}

void print_cubes(const std::vector<CubeBench>& rows) {
    fmt::print("\n{:<16} {:<26} {:>9} {:>9} {:>12} {:>5} {:>8} {:>8}\n", "three faces", "method",
               "ms", "error", "other codes", "by", "cells", "runs");
    for (const CubeBench& row : rows)
        fmt::print("{:<16} {:<26} {:>9.3f} {:>9.1e} {:>12} {:>5} {:>8} {:>8}\n", row.texture,
                   row.method, row.milliseconds, row.error, row.other_codes, row.largest_step,
                   row.cells, row.runs);
}

/// Prints the largest errors by the index of the texel in its cell.
void print_growth(const std::vector<GrowthBench>& rows) {
    double frequency = 0.0;
    for (const GrowthBench& row : rows) {
        if (row.frequency != frequency) {
            fmt::print("\n{:<18}", fmt::format("frequency {:g}, texel", row.frequency));
            for (const auto& error : row.errors) fmt::print(" {:>8}", error.texel);
            fmt::print("\n");
        }
        frequency = row.frequency;
        fmt::print("{:<8} {:<9}  ", row.noise, row.precision);
        for (const auto& error : row.errors) fmt::print(" {:>8.1e}", error.largest);
        fmt::print("\n");
    }
}

}  // namespace

void run_forward_bench(const BenchCommand& command) {
    const std::vector<ForwardBench> rows = bench_forward(command.repeats);
    const std::vector<CubeBench> cubes =
        bench_forward_cubes(command.repeats, command.size == 0 ? 256 : command.size);
    const std::vector<GrowthBench> growth = bench_forward_growth();
    Json list = Json::array();
    for (const ForwardBench& row : rows) list.push_back(forward_json(row));
    for (const CubeBench& row : cubes) list.push_back(cube_json(row));
    for (const GrowthBench& row : growth) list.push_back(growth_json(row));
    write_report(command, list);
    if (command.json) return;
    print_steps(rows, "ns per texel",
                [](const ForwardBench& row) { return fmt::format("{:.2f}", row.ns_per_texel); });
    print_steps(rows, "largest error",
                [](const ForwardBench& row) { return fmt::format("{:.1e}", row.error); });
    print_cubes(cubes);
    print_growth(growth);
}

}  // namespace burl
