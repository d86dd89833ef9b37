// The command `burl bench economy` with its tables and its JSON.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/bench/command.h"
#include "app/bench/economy.h"
#include "app/bench/gl/view.h"

namespace burl {

namespace {

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

void run_economy_bench(const BenchCommand& command) {
    const auto size = std::uint32_t(command.size == 0 ? 1024 : command.size);
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
