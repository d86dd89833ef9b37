// `burl bench`: run times that others can reproduce, as medians of paired runs.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/base/messages.h"
#include "app/base/version.h"
#include "app/bench/atlas.h"
#include "app/bench/bench.h"
#include "app/bench/command.h"
#include "app/bench/filter.h"
#include "app/bench/forward.h"
#include "app/bench/gl/editor.h"
#include "app/bench/gl/editor_open.h"
#include "app/bench/gl/synthesis.h"
#include "app/bench/kernels.h"
#include "app/bench/levels.h"
#include "app/bench/noise.h"
#include "app/bench/options.h"
#include "app/bench/precision.h"
#include "app/bench/resynthesis.h"
#include "app/bench/synthesis.h"
#include "app/export/command_files.h"
#include "app/gl/device/context.h"
#include "app/main/verbs.h"
#include "app/measure/report.h"
#include "app/options/command_options.h"
#include "atlas/base/error.h"
#include "procedural/batch/texel_batch.h"
#include "procedural/numbers/simd_target.h"

namespace burl {

namespace {

Json row_json(const BenchRow& row) {
    return {{"name", row.name},
            {"unit", row.unit},
            {"units", row.units},
            {"seconds_median", row.median},
            {"seconds_lowest", row.lowest},
            {"seconds_highest", row.highest},
            {"ns_per_unit", row.ns_per_unit()}};
}

Json atlas_json(const AtlasBench& bench) {
    Json stages = Json::array();
    for (const StageBench& stage : bench.stages)
        stages.push_back({{"stage", stage.stage},
                          {"seconds_one_thread", stage.one_thread},
                          {"seconds_all_threads", stage.all_threads},
                          {"us_per_face", stage.one_thread * 1e6 / double(bench.faces)},
                          {"times_faster", stage.one_thread / stage.all_threads}});
    BenchResult layout{bench.stage("layout").time};
    layout.time.name = bench.kind;
    layout.time.unit = "face";
    layout.time.units = double(bench.faces);
    layout.time.group = fmt::format("{} faces", bench.faces);
    Json json = result_json(layout);
    json["times_first"] = nullptr;  // atlas kinds are timed one after another
    json["error_rms"] = std::pow(10.0, -bench.psnr / 20.0);
    json.update(Json{{"kind", bench.kind},
                     {"faces", bench.faces},
                     {"size", bench.size},
                     {"stages", stages},
                     {"coverage", bench.coverage},
                     {"psnr", bench.psnr},
                     {"rmse_levels_1_to_3", bench.rmse}});
    return json;
}

/// Prints an atlas in one line: times of layout and spans, and quality.
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
    if (!report_rows(command, rows, atlas_json)) return;
    print_atlases(rows);
}

Json filter_json(const FilterBench& row) {
    Json json = result_json(row.result);
    json.update(Json{{"texture", row.texture},
                     {"footprint_cells", row.footprint},
                     {"truth_noise", row.truth_noise}});
    return json;
}

void run_filter_bench(const BenchCommand& command) {
    const std::vector<FilterBench> rows =
        bench_filters(command.repeats, command.size == 0 ? 256 : command.size);
    if (!report_rows(command, rows, filter_json)) return;
    std::vector<BenchResult> results;
    for (const FilterBench& row : rows) results.push_back(row.result);
    fmt::print("{}", result_table(results));
}

/// Reports a suite whose rows have no columns of their own.
void report_results(const BenchCommand& command, const std::vector<BenchResult>& results) {
    if (report_rows(command, results, result_json)) fmt::print("{}", result_table(results));
}

SynthesisSubjects subjects_of(const BenchCommand& command) {
    SynthesisSubjects subjects;
    if (!command.recipes.empty()) subjects.recipes = command.recipes;
    if (command.size > 0) subjects.side = command.size;
    if (!command.file.empty()) subjects.mesh = MeshOptions{}.load(command.file);
    return subjects;
}

Json level_json(const LevelBench& row) {
    Json json = result_json({row.time});
    json.update(Json{{"recipe", row.recipe},
                     {"level", row.level},
                     {"rule", row.rule},
                     {"samples_of_level_0", row.samples},
                     {"rmse", row.rmse},
                     {"rmse_of_average", row.of_average},
                     {"truth_noise", row.truth_noise}});
    return json;
}

void run_levels_bench(const BenchCommand& command) {
    SynthesisSubjects subjects = subjects_of(command);
    if (command.size == 0) subjects.side = 512;
    const std::vector<LevelBench> rows = bench_levels(command.repeats, std::move(subjects));
    if (!report_rows(command, rows, level_json)) return;
    fmt::print("{:<26} {:<10} {:>8} {:>9} {:>8} {:>9} {:>9} {:>8}\n", "texture", "rule", "samples",
               "RMSE", "of avg", "truth +-", "ms", "of avg");
    for (const LevelBench& row : rows)
        fmt::print("{:<26} {:<10} {:>8.4f} {:>9.5f} {:>8.3f} {:>9.5f} {:>9.2f} {:>8.3f}\n",
                   printable(row.time.group), row.rule, row.samples, row.rmse, row.of_average,
                   row.truth_noise, row.time.median * 1e3, row.time.times_first);
}

Json precision_json(const PrecisionBench& row) {
    Json json = result_json({row.time, BenchError{row.max_error, row.rms_error}});
    json["psnr"] = std::isfinite(row.psnr) ? Json(row.psnr) : Json();
    if (row.coordinate_rms_error > 0.0) {
        json["coordinate_rms_error"] = row.coordinate_rms_error;
        json["coordinate_psnr"] = row.coordinate_psnr;
    }
    return json;
}

void run_precision_bench(const BenchCommand& command) {
    const std::vector<PrecisionBench> rows =
        bench_precision(command.repeats, command.size == 0 ? 512 : command.size);
    if (!report_rows(command, rows, precision_json)) return;
    fmt::print("{:<8} {:<11} {:>10} {:>10} {:>7} {:>9}   {}\n", "texture", "precision", "max error",
               "RMS error", "PSNR", "ns/texel", "coordinates alone: RMS, PSNR");
    for (const PrecisionBench& row : rows) {
        fmt::print("{:<8} {:<11} {:>10.3g} {:>10.3g} {:>7.2f} {:>9.1f}", row.texture, row.precision,
                   row.max_error, row.rms_error, row.psnr, row.time.ns_per_unit());
        if (row.coordinate_rms_error > 0.0)
            fmt::print(" {:>10.3g} {:>7.2f}", row.coordinate_rms_error, row.coordinate_psnr);
        fmt::print("\n");
    }
}

Json kernel_json(const KernelBench& row) {
    return {{"noise", row.noise},
            {"span", row.span},
            {"crossings_per_texel", row.crossings},
            {"ns_direct", row.direct},
            {"ns_share", row.share},
            {"ns_scanline", row.scanline},
            {"ns_auto", row.automatic},
            {"auto_over_best", row.automatic / row.best()}};
}

void run_kernel_bench(const BenchCommand& command) {
    const std::vector<KernelBench> rows =
        bench_kernels(command.repeats, command.size == 0 ? 16 : command.size);
    if (!report_rows(command, rows, kernel_json)) return;
    fmt::print("{:<26} {:>6} {:>15} {:>9} {:>9} {:>9} {:>9} {:>9}\n",
               "ns per texel, " + simd_level(), "span", "crossings/texel", "direct", "share",
               "scanline", "auto", "auto/best");
    for (const KernelBench& row : rows)
        fmt::print("{:<26} {:>6} {:>15.4f} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.3f}\n",
                   row.noise, row.span, row.crossings, row.direct, row.share, row.scanline,
                   row.automatic, row.automatic / row.best());
}

Json gl_json(const GlBench& row) {
    Json json = result_json(row.result);
    json.update(Json{{"octaves", row.octaves},
                     {"size", row.side},
                     {"passes", row.passes},
                     {"gpu_ms", row.parts.gpu * 1e3},
                     {"draw_ms", row.parts.draw * 1e3},
                     {"transfer_ms", row.parts.transfer * 1e3},
                     {"cold_ms",
                      {{"context", row.cold.context * 1e3},
                       {"compile", row.cold.compile * 1e3},
                       {"maps", row.cold.maps * 1e3},
                       {"draw", row.cold.draw * 1e3},
                       {"total", row.cold.total * 1e3}}}});
    return json;
}

void print_gl(const GlBenchReport& report) {
    fmt::print("{}\n", report.opengl);
    std::string group;
    for (const GlBench& row : report.rows) {
        const BenchRow& time = row.result.time;
        if (group != time.group)
            fmt::print("\n{:<26} {:>9} {:>8} {:>6} {:>8} {:>8} {:>8} {:>9} {:>9} {:>9} {:>9}\n",
                       time.group, "ms", "ns/texel", "passes", "GPU ms", "draw", "transfer",
                       "cold ms", "(compile)", "max error", "RMS");
        group = time.group;
        fmt::print("{:<26} {:>9.2f} {:>8.2f}", time.name, time.median * 1e3, time.ns_per_unit());
        fmt::print(" {:>6}", row.passes > 0 ? std::to_string(row.passes) : "");
        if (row.cold.total > 0.0)
            fmt::print(" {:>8.2f} {:>8.2f} {:>8.2f} {:>9.1f} {:>9.1f}", row.parts.gpu * 1e3,
                       row.parts.draw * 1e3, row.parts.transfer * 1e3, row.cold.total * 1e3,
                       row.cold.compile * 1e3);
        else
            fmt::print("{:>46}", "");
        if (row.result.error)
            fmt::print(" {:>9.3g} {:>9.3g}", row.result.error->max, row.result.error->rms);
        fmt::print("\n");
    }
}

void run_gl_bench(const BenchCommand& command) {
    GlBenchSubjects subjects;
    if (command.size > 0) subjects.sides = {std::uint32_t(command.size)};
    const GlBenchReport report = bench_gl(command.gl, command.repeats, subjects);
    const auto to_json = [&](const GlBench& row) {
        Json json = gl_json(row);
        json["opengl"] = report.opengl;
        return json;
    };
    if (report_rows(command, report.rows, to_json)) print_gl(report);
}

void run_editor_bench(const BenchCommand& command) {
    constexpr double drag_seconds = 4.0;
    const std::uint32_t side = command.size == 0 ? 1024 : std::uint32_t(command.size);
    const std::vector<EditorBench> rows = bench_editor("sample:teapot", side, drag_seconds);
    if (report_rows(command, rows, editor_bench_json)) fmt::print("{}", editor_bench_table(rows));
}

void run_open_bench(const BenchCommand& command) {
    const std::vector<OpenBench> rows{bench_open(command.size == 0 ? 1'000'000 : command.size)};
    if (report_rows(command, rows, open_bench_json)) fmt::print("{}", open_bench_table(rows[0]));
}

void check_bench_output(const BenchCommand& command) {
    CommandFiles files;
    files.read(files_of_mesh(command.file));
    for (const std::string& recipe : command.recipes)
        files.read(files_of_recipe(recipe, load_recipe(recipe)));
    files.write(command.out);
}

void run_bench(const BenchCommand& command) {
    if (!command.out.empty()) check_bench_output(command);
    if (command.suite == "atlas") return run_atlas_bench(command);
    if (command.suite == "editor") return run_editor_bench(command);
    if (command.suite == "open") return run_open_bench(command);
    if (command.suite == "economy") return run_economy_bench(command);
    if (command.suite == "gl") return run_gl_bench(command);
    if (command.suite == "filter") return run_filter_bench(command);
    if (command.suite == "noise")
        return report_results(
            command, bench_noise(command.repeats, command.size == 0 ? 65536 : command.size));
    if (command.suite == "synthesis")
        return report_results(command, bench_synthesis(command.repeats, subjects_of(command)));
    if (command.suite == "resynthesis")
        return report_results(command, bench_resynthesis(command.repeats, subjects_of(command)));
    if (command.suite == "levels") return run_levels_bench(command);
    if (command.suite == "precision") return run_precision_bench(command);
    if (command.suite == "forward") return run_forward_bench(command);
    if (command.suite == "kernels") return run_kernel_bench(command);
    if (command.suite == "stability") return run_stability_bench(command);
    const std::vector<BenchRow> rows =
        run_paired(bench_suite(command.suite, command.size), command.repeats);
    if (!report_rows(command, rows, row_json)) return;
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
    verb->add_option(
            "suite", command->suite,
            "mesh_io, atlas, synthesis, resynthesis, levels, economy, filter, noise, forward, "
            "gl, kernels, open, precision, stability or editor")
        ->required()
        ->check(one_of(bench_suite_names()));
    verb->add_option("file", command->file, "synthesis, resynthesis, levels: a mesh to texture");
    verb->add_option("--size", command->size, bench_size_help());
    verb->add_option("--repeats", command->repeats, "Counted rounds")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    verb->add_flag("--large", command->large, "atlas: also 1,000,000 faces, some minutes");
    verb->add_option(
            "-r,--recipe", command->recipes,
            "synthesis, resynthesis, levels: preset or recipe file, may be repeated; marble, wood "
            "and clouds "
            "unless given")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    verb->add_option("--simd", command->simd,
                     "Instruction set of the kernels instead of the best this machine has, as "
                     "AVX2");
    verb->add_option("--gl", command->gl,
                     "gl, economy: osmesa (software) or egl (a graphics processor)")
        ->capture_default_str();
    verb->add_flag("--thorough", command->thorough,
                   "stability: every case there is, some minutes and 2 GB");
    verb->add_option("--case", command->one,
                     "stability: one case, as the suite names its worst (\"coordinates/117\"): its "
                     "recipe, its texels and every kernel's error");
    verb->add_flag("--json", command->json, "Print JSON on stdout");
    verb->add_option("-o,--output", command->out, "Also write the JSON to this file");
    verb->callback([command, verb] {
        std::vector<std::string> given;
        for (const char* option : {"-o", "--size", "--repeats", "--large", "--recipe", "--simd",
                                   "--gl", "--json", "--thorough", "--case"})
            if (verb->count(option) > 0) given.emplace_back(option);
        check_bench(*command, given);
        if (!command->simd.empty()) limit_simd(command->simd);
        run_bench(*command);
    });
}

}  // namespace burl
