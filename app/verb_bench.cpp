// `burl bench`: run times anyone can repeat, as medians of paired runs.
#include <fmt/format.h>

#include "app/bench.h"
#include "app/export.h"
#include "app/report.h"
#include "app/verbs.h"

namespace burl {

namespace {

struct BenchCommand {
    std::string suite, out;
    std::size_t size = 0;
    int repeats = 5;
    bool json = false;
};

Json row_json(const BenchRow& row) {
    return {{"name", row.name},
            {"unit", row.unit},
            {"units", row.units},
            {"seconds_median", row.median},
            {"seconds_lowest", row.lowest},
            {"seconds_highest", row.highest},
            {"ns_per_unit", row.ns_per_unit()}};
}

void run_bench(const BenchCommand& command) {
    if (!command.out.empty()) check_side_output(command.out, "", {});
    const std::vector<BenchRow> rows =
        run_paired(bench_suite(command.suite, command.size), command.repeats);
    Json list = Json::array();
    for (const BenchRow& row : rows) list.push_back(row_json(row));
    const Json report = {{"suite", command.suite},
                         {"repeats", command.repeats},
                         {"rows", list},
                         {"versions", versions_json()}};
    if (!command.out.empty()) write_json(command.out, report);
    if (command.json) {
        write_json("-", report);
        return;
    }
    fmt::print("{:<36} {:>12} {:>12} {:>12} {:>14}\n", command.suite, "median ms", "lowest",
               "highest", "ns/unit");
    for (const BenchRow& row : rows) {
        fmt::print("{:<36} {:>12.3f} {:>12.3f} {:>12.3f} {:>9.2f} /{}\n", row.name,
                   row.median * 1e3, row.lowest * 1e3, row.highest * 1e3, row.ns_per_unit(),
                   row.unit);
    }
}

}  // namespace

void add_bench(CLI::App& program) {
    auto* verb = program.add_subcommand("bench", "Time a suite; medians of paired runs");
    auto command = std::make_shared<BenchCommand>();
    verb->add_option("suite", command->suite, "mesh_io, atlas or synthesis")
        ->required()
        ->check(CLI::IsMember(bench_suites()));
    verb->add_option("--size", command->size,
                     "Faces (mesh_io, atlas) or texels per side (synthesis)")
        ->check(CLI::Range(std::size_t{2}, std::size_t{10'000'000}));
    verb->add_option("--repeats", command->repeats, "Counted rounds")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    verb->add_flag("--json", command->json, "Print JSON on stdout");
    verb->add_option("-o,--output", command->out, "Also write the JSON to this file");
    verb->callback([command] { run_bench(*command); });
}

}  // namespace burl
