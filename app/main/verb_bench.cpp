// `burl bench`: run times that others can reproduce, as medians of paired runs.
#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include <CLI/CLI.hpp>

#include "app/base/version.h"
#include "app/bench/command.h"
#include "app/export/command_files.h"
#include "app/main/verbs.h"
#include "app/options/command_options.h"
#include "app/recipe/edit/images.h"

namespace burl {

namespace {

struct SuiteRun {
    std::string_view name;
    void (*run)(const BenchCommand&);
};

constexpr std::array suite_runs{
    SuiteRun{"atlas", run_atlas_bench},
    SuiteRun{"economy", run_economy_bench},
    SuiteRun{"editor", run_editor_bench},
    SuiteRun{"filter", run_filter_bench},
    SuiteRun{"forward", run_forward_bench},
    SuiteRun{"gl", run_gl_bench},
    SuiteRun{"kernels", run_kernels_bench},
    SuiteRun{"levels", run_levels_bench},
    SuiteRun{"mesh_io", run_mesh_io_bench},
    SuiteRun{"noise", run_noise_bench},
    SuiteRun{"open", run_open_bench},
    SuiteRun{"precision", run_precision_bench},
    SuiteRun{"resynthesis", run_resynthesis_bench},
    SuiteRun{"rivals", run_rivals_bench},
    SuiteRun{"scale", run_scale_bench},
    SuiteRun{"stability", run_stability_bench},
    SuiteRun{"synthesis", run_synthesis_bench},
    SuiteRun{"uv", run_uv_bench},
};

void check_bench_output(const BenchCommand& command) {
    CommandFiles files;
    files.read(files_of_mesh(command.file));
    RecipeImages images(ImageLimits{.named = command.named});
    for (const std::string& recipe : command.recipes)
        files.read(files_of_recipe(recipe, load_recipe(recipe, {}, images)));
    files.write(command.out);
}

}  // namespace

void add_bench(CLI::App& program) {
    auto* verb = program.add_subcommand("bench", "Time a suite; medians of paired runs");
    auto command = std::make_shared<BenchCommand>();
    verb->add_option(
            "suite", command->suite,
            "mesh_io, atlas, synthesis, resynthesis, levels, economy, filter, noise, forward, "
            "gl, kernels, open, precision, rivals, scale, stability, editor or uv")
        ->required()
        ->check(one_of(bench_suite_names()));
    verb->add_option("file", command->file,
                     "synthesis, resynthesis, levels, uv: a mesh to texture");
    verb->add_option("--size", command->size, bench_size_help());
    verb->add_option("--repeats", command->repeats, "Counted rounds")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    verb->add_flag("--large", command->large,
                   "atlas: also 1,000,000 faces, some minutes; scale: up to 10,000,000 "
                   "triangles and 16384 x 16384 texels, ten minutes and 5 GB");
    verb->add_option(
            "-r,--recipe", command->recipes,
            "synthesis, resynthesis, levels: preset or recipe file, may be repeated; marble, wood "
            "and clouds "
            "unless given")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    verb->add_flag_callback(
            "--allow-outside", [command] { command->named = NamedFiles::anywhere; },
            "Read images that lie outside of the folder of --recipe")
        ->needs("--recipe");
    verb->add_option("--simd", command->simd,
                     "Instruction set of the kernels instead of the best this machine has, as "
                     "AVX2");
    verb->add_option("--gl", command->gl,
                     "gl, economy, editor: osmesa (software) or egl (a graphics processor)")
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
        if (!command->out.empty()) check_bench_output(*command);
        std::ranges::find(suite_runs, command->suite, &SuiteRun::name)->run(*command);
    });
}

}  // namespace burl
