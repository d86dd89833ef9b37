#include "app/bench/gl/economy.h"

#include <limits>
#include <memory>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "app/bench/command.h"
#include "app/bench/gl/view.h"
#include "app/bench/meshes.h"
#include "app/bench/synthesis.h"
#include "app/pipeline/pipeline.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

/// Marble with its octaves as separate terms, which can be edited one by one.
Recipe four_terms(std::uint32_t size) {
    Recipe recipe = sized_recipe("marble", size);
    take_apart(*plain_texture(recipe.texture));
    return recipe;
}

/// A texture as an editor shows it, and the recipe set by the sliders.
struct Shown {
    Pipeline pipeline{torus(6000)};
    Recipe recipe;

    explicit Shown(std::uint32_t size) : recipe(four_terms(size)) {
        pipeline.set_cache(std::numeric_limits<std::size_t>::max());
        show();
    }
    void show() {
        pipeline.set_recipe(recipe);
        pipeline.picture<Rgb8>();
    }
};

struct Edit {
    std::string name;
    std::function<void(Recipe&)> move;
};

/// The edits; each undoes at every second call what it did at the call before.
std::vector<Edit> edits() {
    return {{"colour",
             [](Recipe& r) {
                 auto& stops = plain_texture(r.texture)->colors.stops;
                 std::swap(stops[1].color, stops[2].color);
             }},
            {"amplitude of 1 of 4 terms",
             [](Recipe& r) {
                 double& a = plain_texture(r.texture)->noise[3].amplitude;
                 a = a == 0.05 ? 0.0625 : 0.05;
             }},
            {"phase of 1 of 4 terms",
             [](Recipe& r) {
                 double& x = plain_texture(r.texture)->noise[3].phase.x;
                 // This octave never shares its coordinates with another.
                 x = x == 0.5 ? 0.25 : 0.5;
             }},
            {"camera", [](Recipe&) {}}};
}

/// Returns the work of the synthesis since `runs_before`; none where it did not run.
SynthesisWork work_since(const Pipeline& pipeline, std::uint64_t runs_before) {
    const StageRecord& record = pipeline.records()[Stage::synthesis];
    return record.runs == runs_before ? SynthesisWork{} : record.last.work;
}

Json work_json(const SynthesisWork& work) {
    Json json{{"texels", work.texels}, {"octaves", work.octaves}};
    for (std::size_t k = 0; k < skip_names.size(); ++k) {
        const std::string name(skip_names[k]);
        if (work.texels_skipped[k] > 0) json["texels_skipped"][name] = work.texels_skipped[k];
        if (work.octaves_skipped[k] > 0) json["octaves_skipped"][name] = work.octaves_skipped[k];
    }
    return json;
}

Json view_json(const ViewBench& row) {
    return {{"part", "view"},
            {"scene", row.scene},
            {"atlas", row.atlas},
            {"size", row.size},
            {"cell", row.cell},
            {"views", row.views},
            {"tiles", row.tiles},
            {"texels_read_of_all_levels", row.read},
            {"texels_visible", row.visible},
            {"texels_synthesised", row.made},
            {"texels_whole", row.whole},
            {"synthesised_over_visible", row.made_over_visible()},
            {"synthesised_over_visible_worst", row.worst},
            {"ms_finding", 1e3 * row.seconds_find / row.views},
            {"ms_synthesis", 1e3 * row.seconds_make / row.views},
            {"ms_whole_synthesis", 1e3 * row.seconds_whole}};
}

Json edit_json(const EditBench& row) {
    return {{"part", "edit"},
            {"edit", row.time.name},
            {"seconds_median", row.time.median},
            {"times_whole", row.time.times_first},
            {"work", work_json(row.work)}};
}

Json spared_json(const SparedOctaves& row) {
    return {{"part", "distance"},
            {"recipe", row.recipe},
            {"level", row.level},
            {"octaves_skipped_share", row.share(Skip::band_limit)},
            {"work", work_json(row.work)}};
}

void print_views(const std::vector<ViewBench>& rows) {
    fmt::print("{:<20} {:<6} {:>4} {:>7} {:>9} {:>9} {:>6} {:>12} {:>6} {:>8} {:>8} {:>8}\n",
               "scene", "atlas", "cell", "tiles", "read %", "visible %", "made %", "made/visible",
               "worst", "find ms", "make ms", "whole ms");
    for (const ViewBench& row : rows) {
        const auto percent = [&](std::uint64_t texels) {
            return 100.0 * double(texels) / double(row.whole);
        };
        fmt::print("{:<20} {:<6} {:>4} {:>7.0f} {:>9.1f} {:>9.1f} {:>6.1f} {:>12.3f} {:>6.3f}",
                   row.scene, row.atlas, row.cell, double(row.tiles) / row.views, percent(row.read),
                   percent(row.visible), percent(row.made), row.made_over_visible(), row.worst);
        fmt::print(" {:>8.1f} {:>8.1f} {:>8.1f}\n", 1e3 * row.seconds_find / row.views,
                   1e3 * row.seconds_make / row.views, 1e3 * row.seconds_whole);
    }
}

void print_edits(const std::vector<EditBench>& rows) {
    fmt::print("\n{:<28} {:>10} {:>12} {:>12} {:>12}\n", "edit", "ms", "times whole", "texels",
               "octaves");
    for (const EditBench& row : rows)
        fmt::print("{:<28} {:>10.3f} {:>12.3f} {:>12} {:>12}\n", row.time.name,
                   1e3 * row.time.median, row.time.times_first, row.work.texels, row.work.octaves);
}

void print_spared(const std::vector<SparedOctaves>& rows) {
    fmt::print("\n{:<28} {:>6} {:>14} {:>14}\n", "octaves beyond a texel", "level", "octaves left",
               "skipped %");
    for (const SparedOctaves& row : rows)
        fmt::print("{:<28} {:>6} {:>14} {:>14.1f}\n", row.recipe, row.level, row.work.octaves,
                   100.0 * row.share(Skip::band_limit));
}

}  // namespace

std::vector<EditBench> bench_edits(int repeats, std::uint32_t size) {
    const auto plain = std::make_shared<Pipeline>(torus(6000));
    plain->set_recipe(four_terms(size));
    plain->solid();
    const double texels = double(size) * double(size);
    auto work = std::make_shared<std::vector<SynthesisWork>>();
    std::vector<BenchCase> cases;
    const auto add = [&](const std::string& name, auto run) {
        const std::size_t k = cases.size();
        work->emplace_back();
        cases.push_back({name, texels, "texel", [run, work, k] { (*work)[k] = run(); }, "edits"});
    };
    add("whole texture", [plain] {
        plain->synthesize<Rgb8>();
        return plain->records()[Stage::synthesis].last.work;
    });
    for (const Edit& edit : edits()) {
        const auto shown = std::make_shared<Shown>(size);  // every case drags one slider only
        add(edit.name, [shown, move = edit.move] {
            const std::uint64_t runs = shown->pipeline.records()[Stage::synthesis].runs;
            move(shown->recipe);
            shown->show();
            return work_since(shown->pipeline, runs);
        });
    }
    std::vector<EditBench> rows;
    for (const BenchRow& row : run_paired(cases, repeats)) rows.push_back({row, {}});
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].work = (*work)[k];
    return rows;
}

double SparedOctaves::share(Skip skip) const {
    const std::uint64_t all =
        std::accumulate(work.octaves_skipped.begin(), work.octaves_skipped.end(), work.octaves);
    return all == 0 ? 0.0 : double(work.octaves_skipped[unsigned(skip)]) / double(all);
}

SparedOctaves spared_by_band_limit(const std::string& name, std::uint32_t size,
                                   std::uint32_t level) {
    Recipe recipe = sized_recipe(name, size);
    recipe.filter.band_limit = true;
    Pipeline pipeline(sample_mesh("sample:teapot"));
    pipeline.set_recipe(recipe);
    SparedOctaves result{name, level};
    fill_texture<Rgb8>(pipeline.solid(level), recipe, {}, {{}, &result.work});
    return result;
}

void run_economy_bench(const BenchCommand& command) {
    const auto size = std::uint32_t(command.size_or(1024));
    const std::vector<ViewBench> views = bench_views(command.gl, {.size = size});
    const std::vector<EditBench> edits = bench_edits(command.repeats, size);
    std::vector<SparedOctaves> far;
    const std::vector<std::uint32_t> levels = bench_levels_seen(command.gl, size);
    for (const char* recipe : {"clouds", "planet", "marble"})
        for (const std::uint32_t level : levels)
            far.push_back(spared_by_band_limit(recipe, size, level));
    Json rows = Json::array();
    for (const ViewBench& row : views) rows.push_back(view_json(row));
    for (const EditBench& row : edits) rows.push_back(edit_json(row));
    for (const SparedOctaves& row : far) rows.push_back(spared_json(row));
    write_report(command, rows);
    if (command.json) return;
    print_views(views);
    print_edits(edits);
    print_spared(far);
}

}  // namespace burl
