// The table of `burl bench stability`, and the report of one case with all that reproduces it.
#include <fmt/format.h>

#include "app/bench/command.h"
#include "app/measure/report.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/recipe.h"
#include "atlas/base/json.h"
#include "tests/stability/stability.h"

namespace burl {

namespace {

Json row_json(const StabilityRow& row) {
    return {{"group", row.group},           {"arithmetic", row.arithmetic},
            {"cases", row.cases},           {"values", row.values},
            {"share", row.share},           {"error", row.error},
            {"largest_error", row.largest}, {"rms_error", row.rms},
            {"jump_share", row.jump_share}, {"seam_share", row.seam_share},
            {"input", row.input},           {"case", row.case_name}};
}

void print_rows(const std::vector<StabilityRow>& rows) {
    fmt::print("{:<33} {:<15} {:>6} {:>9} {:>8} {:>8} {:>8} {:>8}\n", "group", "arithmetic",
               "cases", "values", "share", "error", "jumps", "seams");
    for (const StabilityRow& row : rows) {
        fmt::print("{:<33} {:<15} {:>6} {:>9} {:>8.3g} {:>8.2g} {:>8.3g} {:>8.3g}\n", row.group,
                   row.arithmetic, row.cases, row.values, row.share, row.error, row.jump_share,
                   row.seam_share);
        if (!row.input.empty())
            fmt::print("    {}{}\n", row.input,
                       row.case_name.empty() ? "" : fmt::format(" (--case '{}')", row.case_name));
    }
}

Json numbers(const Vec3d& v) {
    return {v.x, v.y, v.z};
}

/// Returns a recipe whose solid space is the case's, so that `burl eval` takes the points of its
/// texels.
Json case_json(const StabilityCase& one) {
    Recipe recipe;
    recipe.name = one.input;
    recipe.texture = plain_graph(one.texture);
    recipe.solid.space = SolidSpace::object;
    Json spans = Json::array();
    for_each_span(one.solid, [&](const Span& span, const TexelMap& map, std::int64_t y) {
        spans.push_back({{"y", y},
                         {"texels", span.count},
                         {"start", numbers(one.map(map(span.x, y)))},
                         {"step", numbers(one.map.linear * map.step_x)},
                         {"down", numbers(one.map.linear * map.step_y)}});
    });
    return {{"recipe", Json::parse(to_json(recipe))}, {"spans", spans}};
}

void run_case(const BenchCommand& command, StabilityChoice choice) {
    const StabilityCase one = stability_case(command.one, choice);
    const Json input = case_json(one);
    Json rows = Json::array();
    for (const StabilityRow& row : case_errors(one)) rows.push_back(row_json(row));
    write_report(command, {{{"case", command.one}, {"input", input}, {"ways", rows}}});
    if (command.json) return;
    fmt::print("{}\nrecipe {}\n", one.input, input["recipe"].dump());
    for (const Json& span : input["spans"]) fmt::print("span {}\n", span.dump());
    for (const Json& row : rows)
        fmt::print("{:<15} share {:.3g}, jumps {:.3g}, seams {:.3g}: {}\n",
                   row["arithmetic"].get<std::string>(), row["share"].get<double>(),
                   row["jump_share"].get<double>(), row["seam_share"].get<double>(),
                   row["input"].get<std::string>());
}

}  // namespace

void run_stability_bench(const BenchCommand& command) {
    const StabilityChoice choice =
        command.thorough ? StabilityChoice::thorough : StabilityChoice::usual;
    if (!command.one.empty()) return run_case(command, choice);
    const std::vector<StabilityRow> rows = bench_stability(choice);
    if (report_rows(command, rows, row_json)) print_rows(rows);
}

}  // namespace burl
