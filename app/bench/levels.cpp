#include "app/bench/levels.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/base/messages.h"
#include "app/bench/command.h"
#include "app/bench/meshes.h"
#include "app/measure/metric_texture.h"
#include "app/recipe/lattice_check.h"
#include "atlas/base/json.h"
#include "atlas/solid/level.h"

namespace burl {

namespace {

constexpr std::uint32_t last = 5;
constexpr std::array rules{"average", "direct:64", "direct:16", "direct:4", "direct:1"};

/// Returns the texels synthesised for a level by a rule, as a multiple of those of level 0.
double samples_of(Pipeline& pipeline, const LevelRule& rule, std::uint32_t level) {
    if (!rule.direct) return 1.0;
    const std::uint32_t size = pipeline.recipe().atlas.size;
    const double side = level_size(size, source_level(pipeline.mesh_atlas(), rule, level));
    return std::pow(side / size, 2.0);
}

void add_rules(Pipeline& pipeline, const SurfaceTruth& truth, int repeats,
               std::vector<LevelBench>& rows) {
    const Image<RgbF> texture = pipeline.synthesize<RgbF>();
    std::vector<std::vector<double>> errors;  // indexed by rule, then by level
    for (const char* name : rules)
        errors.push_back(level_errors(
            pipeline.atlas(), pipeline.levels(texture, last, level_rule_named(name)), truth));
    for (std::uint32_t level = 1; level <= truth.levels.size(); ++level) {
        std::vector<BenchCase> cases;
        const std::string group = fmt::format("{}, level {}", pipeline.recipe().name, level);
        for (const char* name : rules) {
            const LevelRule rule = level_rule_named(name);
            const double side = level_size(pipeline.recipe().atlas.size, level);
            cases.push_back({name, side * side, "texel",
                             [&pipeline, level, rule] { pipeline.level(level, rule); }, group});
        }
        const std::vector<BenchRow> times = run_paired(cases, repeats);
        for (std::size_t i = 0; i < rules.size(); ++i) {
            const double rmse = errors[i][level - 1], average = errors[0][level - 1];
            rows.push_back({pipeline.recipe().name, level, rules[i],
                            samples_of(pipeline, level_rule_named(rules[i]), level), rmse,
                            truth.levels[level - 1].noise, average > 0.0 ? rmse / average : 1.0,
                            times[i]});
        }
    }
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

}  // namespace

std::vector<LevelBench> bench_levels(int repeats, SynthesisSubjects subjects, std::size_t points) {
    Pipeline pipeline(subjects.mesh ? std::move(*subjects.mesh) : torus(6000));
    pipeline.set_threads(1);
    std::vector<LevelBench> rows;
    for (const std::string& name : subjects.recipes) {
        const Recipe recipe = sized_recipe(name, subjects.side, subjects.named);
        check_lattice(recipe, pipeline.mesh());
        pipeline.set_recipe(recipe);
        add_rules(pipeline, level_truth(pipeline, 1, last, points), repeats, rows);
    }
    return rows;
}

void run_levels_bench(const BenchCommand& command) {
    const std::vector<LevelBench> rows = bench_levels(command.repeats, subjects_of(command, 512));
    if (!report_rows(command, rows, level_json)) return;
    fmt::print("{:<26} {:<10} {:>8} {:>9} {:>8} {:>9} {:>9} {:>8}\n", "texture", "rule", "samples",
               "RMSE", "of avg", "truth +-", "ms", "of avg");
    for (const LevelBench& row : rows)
        fmt::print("{:<26} {:<10} {:>8.4f} {:>9.5f} {:>8.3f} {:>9.5f} {:>9.2f} {:>8.3f}\n",
                   printable(row.time.group), row.rule, row.samples, row.rmse, row.of_average,
                   row.truth_noise, row.time.median * 1e3, row.time.times_first);
}

}  // namespace burl
