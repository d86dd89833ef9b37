// `burl bench`: run times anyone can repeat, as medians of paired runs.
#include <fmt/format.h>

#include "app/bench.h"
#include "app/bench_atlas.h"
#include "app/bench_filter.h"
#include "app/bench_forward.h"
#include "app/bench_precision.h"
#include "app/export.h"
#include "app/report.h"
#include "app/verbs.h"
#include "atlas/error.h"
#include "procedural/noise_kernels.h"

namespace burl {

namespace {

struct BenchCommand {
    std::string suite, out;
    std::size_t size = 0;
    int repeats = 5;
    bool large = false, json = false;
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

/// To the file asked for, and to stdout.
void write_report(const BenchCommand& command, const Json& rows) {
    const Json report = {{"suite", command.suite},
                         {"repeats", command.repeats},
                         {"rows", rows},
                         {"versions", versions_json()}};
    if (!command.out.empty()) write_json(command.out, report);
    if (command.json) write_json("-", report);
}

Json atlas_json(const AtlasBench& bench) {
    Json stages = Json::array();
    for (const StageBench& stage : bench.stages)
        stages.push_back({{"stage", stage.stage},
                          {"seconds_one_thread", stage.one_thread},
                          {"seconds_all_threads", stage.all_threads},
                          {"us_per_face", stage.one_thread * 1e6 / double(bench.faces)},
                          {"times_faster", stage.one_thread / stage.all_threads}});
    return {{"kind", bench.kind},
            {"faces", bench.faces},
            {"size", bench.size},
            {"stages", stages},
            {"coverage", bench.coverage},
            {"psnr", bench.psnr},
            {"rmse_levels_1_to_3", bench.rmse}};
}

/// One line: its layout and spans, and its quality.
void print_atlas(const AtlasBench& bench) {
    const double us = 1e6 / double(bench.faces);
    const StageBench &layout = bench.stage("layout"), &spans = bench.stage("spans");
    fmt::print("  {:<8} {:>11.3f} {:>8.3f} {:>7.2f} {:>8.3f} {:>9.3f} {:>6.1f}", bench.kind,
               layout.one_thread * 1e3, layout.one_thread * us,
               layout.one_thread / layout.all_threads, spans.one_thread * us, bench.coverage,
               bench.psnr);
    for (const double rmse : bench.rmse) fmt::print(" {:>7.4f}", rmse);
    for (const StageBench& stage : bench.stages)
        if (stage.part_of_layout) fmt::print("  {} {:.3f}", stage.stage, stage.one_thread * us);
    fmt::print("\n");
}

void print_atlases(const std::vector<AtlasBench>& rows) {
    std::size_t faces = 0;
    for (const AtlasBench& row : rows) {
        if (row.faces != faces)
            fmt::print(
                "{}{} faces, {} x {} texels, connectivity {:.3f} us/face\n"
                "  {:<8} {:>11} {:>8} {:>7} {:>8} {:>9} {:>6} {:>7} {:>7} {:>7}\n",
                faces == 0 ? "" : "\n", row.faces, row.size, row.size,
                row.stage("connectivity").one_thread * 1e6 / double(row.faces), "atlas",
                "layout ms", "us/face", "faster", "spans", "coverage", "L0 dB", "L1", "L2", "L3");
        faces = row.faces;
        print_atlas(row);
    }
}

void run_atlas_bench(const BenchCommand& command) {
    std::vector<std::size_t> faces{1'000, 10'000, 100'000};
    if (command.large) faces.push_back(1'000'000);
    if (command.size > 0) faces = {command.size};
    const std::vector<AtlasBench> rows = bench_atlases(faces, command.repeats);
    Json list = Json::array();
    for (const AtlasBench& row : rows) list.push_back(atlas_json(row));
    write_report(command, list);
    if (command.json) return;
    print_atlases(rows);
}

Json filter_json(const FilterBench& row) {
    return {{"texture", row.texture},         {"footprint_cells", row.footprint},
            {"filter", row.filter},           {"rmse", row.rmse},
            {"truth_noise", row.truth_noise}, {"ns_per_texel", row.ns_per_texel},
            {"times_none", row.cost}};
}

void run_filter_bench(const BenchCommand& command) {
    const std::vector<FilterBench> rows =
        bench_filters(command.repeats, command.size == 0 ? 256 : command.size);
    Json list = Json::array();
    for (const FilterBench& row : rows) list.push_back(filter_json(row));
    write_report(command, list);
    if (command.json) return;
    fmt::print("{:<10} {:>9} {:<16} {:>9} {:>11} {:>9} {:>10}\n", "texture", "footprint", "filter",
               "RMSE", "truth noise", "ns/texel", "times none");
    for (const FilterBench& row : rows)
        fmt::print("{:<10} {:>9.3f} {:<16} {:>9.6f} {:>11.6f} {:>9.1f} {:>10.2f}\n", row.texture,
                   row.footprint, row.filter, row.rmse, row.truth_noise, row.ns_per_texel,
                   row.cost);
}

Json precision_json(const PrecisionBench& row) {
    Json json{{"texture", row.texture},     {"precision", row.precision},
              {"max_error", row.max_error}, {"rms_error", row.rms_error},
              {"psnr", row.psnr},           {"ns_per_texel", row.ns_per_texel}};
    if (row.coordinate_rms_error > 0.0) {
        json["coordinate_rms_error"] = row.coordinate_rms_error;
        json["coordinate_psnr"] = row.coordinate_psnr;
    }
    return json;
}

void run_precision_bench(const BenchCommand& command) {
    const std::vector<PrecisionBench> rows =
        bench_precision(command.repeats, command.size == 0 ? 512 : command.size);
    Json list = Json::array();
    for (const PrecisionBench& row : rows) list.push_back(precision_json(row));
    write_report(command, list);
    if (command.json) return;
    fmt::print("{:<8} {:<11} {:>10} {:>10} {:>7} {:>9}   {}\n", "texture", "precision", "max error",
               "RMS error", "PSNR", "ns/texel", "coordinates alone: RMS, PSNR");
    for (const PrecisionBench& row : rows) {
        fmt::print("{:<8} {:<11} {:>10.3g} {:>10.3g} {:>7.2f} {:>9.1f}", row.texture, row.precision,
                   row.max_error, row.rms_error, row.psnr, row.ns_per_texel);
        if (row.coordinate_rms_error > 0.0)
            fmt::print(" {:>10.3g} {:>7.2f}", row.coordinate_rms_error, row.coordinate_psnr);
        fmt::print("\n");
    }
}

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

/// A table per function: a line per method, and in it cell(row) for every step.
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

/// Largest error at the cells' first, second, third, fifth ... and last texel.
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

void run_forward_bench(const BenchCommand& command) {
    if (command.size > batch_capacity)
        throw Error(ExitCode::usage,
                    fmt::format("bench forward: --size {} is too large, the cubes' faces have at "
                                "most {} texels a side",
                                command.size, batch_capacity));
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

void run_bench(const BenchCommand& command) {
    if (!command.out.empty()) check_side_output(command.out, "", {});
    if (command.suite == "atlas") return run_atlas_bench(command);
    if (command.suite == "filter") return run_filter_bench(command);
    if (command.suite == "precision") return run_precision_bench(command);
    if (command.suite == "forward") return run_forward_bench(command);
    const std::vector<BenchRow> rows =
        run_paired(bench_suite(command.suite, command.size), command.repeats);
    Json list = Json::array();
    for (const BenchRow& row : rows) list.push_back(row_json(row));
    write_report(command, list);
    if (command.json) return;
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
    std::vector<std::string> suites = bench_suites();
    suites.insert(suites.end(), {"atlas", "filter", "forward", "precision"});
    verb->add_option("suite", command->suite,
                     "mesh_io, atlas, synthesis, filter, forward or precision")
        ->required()
        ->check(CLI::IsMember(suites));
    verb->add_option(
            "--size", command->size,
            "Faces (mesh_io, atlas) or texels per side (synthesis, filter, precision, "
            "forward's cubes: at most 1,024); atlas: 1,000 to 100,000 unless one number is "
            "given")
        ->check(CLI::Range(std::size_t{2}, std::size_t{10'000'000}));
    verb->add_option("--repeats", command->repeats, "Counted rounds")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    verb->add_flag("--large", command->large, "atlas: also 1,000,000 faces, some minutes");
    verb->add_flag("--json", command->json, "Print JSON on stdout");
    verb->add_option("-o,--output", command->out, "Also write the JSON to this file");
    verb->callback([command] { run_bench(*command); });
}

}  // namespace burl
