#include "app/bench/atlas.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "app/bench/command.h"
#include "app/bench/meshes.h"
#include "app/measure/metric_texture.h"
#include "app/measure/metrics_report.h"
#include "atlas/base/json.h"
#include "atlas/blocks/pairing.h"
#include "atlas/blocks/quad_cells.h"
#include "atlas/blocks/quad_tree.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/measure/atlas_measures.h"
#include "atlas/measure/lookup_errors.h"
#include "atlas/measure/surface_points.h"
#include "procedural/model/metric_marble.h"

namespace burl {

namespace {

using tbb::global_control;

int all_threads() {
    return int(global_control::active_value(global_control::max_allowed_parallelism));
}

/// Adds a stage twice: on one thread and on all.
void add_stage(std::vector<BenchCase>& cases, const std::string& stage,
               const std::function<void()>& run) {
    for (const int threads : {1, all_threads()})
        cases.push_back({stage, 1.0, "run", [run, threads] {
                             const global_control limit(global_control::max_allowed_parallelism,
                                                        std::size_t(threads));
                             run();
                         }});
}

/// A mesh with the inputs of all its atlases and the reference for their quality.
struct AtlasSubject {
    AtlasSubject(std::size_t faces, std::size_t points)
        : mesh(bumpy_sphere(faces)),
          connectivity(build_connectivity(mesh)),
          size(bench_texture(mesh.triangles.size())) {
        TruthOptions options;
        options.size = size;
        options.points = points;
        options.level_points = points;
        options.levels = 3;
        options.grazing_levels = 0;
        options.view_points = view_points;
        truth = surface_truth(mesh, grey(metric_marble), options);
    }

    Mesh mesh;
    Connectivity connectivity;
    std::uint32_t size;
    SurfaceTruth truth;
};

void add_quad_stages(std::vector<BenchCase>& cases, const AtlasSubject& subject,
                     const AtlasOptions& options) {
    constexpr double most_cost = 1.5;  // limit used by atlas/blocks/layout_quad.cpp
    const auto opposite = std::make_shared<std::vector<std::int32_t>>(
        opposite_half_edges(subject.mesh, subject.connectivity));
    const auto pairs = [&subject, opposite, options] {
        return make_quad_cells(subject.mesh, *opposite, options.weight, most_cost);
    };
    const auto cells = std::make_shared<std::vector<QuadCell>>(pairs());
    add_stage(cases, "pairs", [pairs] { pairs(); });
    add_stage(cases, "tree", [cells, options] {
        plan_quad_tree(*cells, options, {halve_by_place, true});
    });
}

std::vector<BenchCase> stages_of(const AtlasSubject& subject, const MeshAtlas& atlas,
                                 const AtlasOptions& options) {
    std::vector<BenchCase> cases;
    add_stage(cases, "connectivity", [&subject] { build_connectivity(subject.mesh); });
    add_stage(cases, "layout",
              [&subject, options] { build_atlas(subject.mesh, subject.connectivity, options); });
    if (options.kind == AtlasKind::quad) add_quad_stages(cases, subject, options);
    add_stage(cases, "spans", [&subject, &atlas] {
        rasterize(subject.mesh, atlas, atlas.mesh(subject.mesh).positions);
    });
    return cases;
}

/// Measures coverage and lookup errors, at the same surface points for all kinds of atlas.
void add_quality(AtlasBench& bench, const AtlasSubject& subject, const MeshAtlas& atlas) {
    const Mesh& mesh = atlas.mesh(subject.mesh);
    const SolidAtlas solid = rasterize(subject.mesh, atlas, mesh.positions);
    bench.coverage = measure(mesh, atlas.atlas(), solid).coverage;
    SurfaceTruth truth = subject.truth;
    truth.points = refined_points(subject.mesh, atlas, std::move(truth.points));
    truth.level_points = refined_points(subject.mesh, atlas, std::move(truth.level_points));
    truth.views.points = refined_points(subject.mesh, atlas, std::move(truth.views.points));
    const LookupErrors errors =
        measure_lookups(mesh, atlas.atlas(), fill_texture(solid, grey(metric_marble)),
                        mesh_edges(mesh, build_connectivity(mesh)), truth, in_8bit_srgb());
    bench.psnr = errors.psnr;
    bench.views = errors.views;
    for (std::size_t l = 1; l < errors.levels.size(); ++l)
        bench.rmse.push_back(errors.levels[l].rmse);
}

AtlasBench bench_atlas(const AtlasSubject& subject, AtlasKind kind, int repeats) {
    AtlasOptions options;
    options.kind = kind;
    options.size = subject.size;
    const MeshAtlas atlas = build_atlas(subject.mesh, subject.connectivity, options);
    AtlasBench bench;
    bench.kind = to_string(kind);
    bench.faces = subject.mesh.triangles.size();
    bench.size = subject.size;
    const std::vector<BenchRow> rows = run_paired(stages_of(subject, atlas, options), repeats);
    for (std::size_t i = 0; i + 1 < rows.size(); i += 2)
        bench.stages.push_back({rows[i].name, rows[i].median, rows[i + 1].median, rows[i],
                                rows[i].name == "pairs" || rows[i].name == "tree"});
    add_quality(bench, subject, atlas);
    return bench;
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
                     {"rmse_levels_1_to_3", bench.rmse},
                     {"sampled_views", views_json(bench.views)}});
    return json;
}

/// The geometric mean of all rows of views for a sampler.
double typical(const std::vector<ViewError>& views, std::size_t sampler) {
    double sum = 0.0;
    for (const ViewError& view : views) sum += std::log(view.rmse[sampler]);
    return views.empty() ? 0.0 : std::exp(sum / double(views.size()));
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
    fmt::print(" {:>7.4f} {:>7.4f}", typical(bench.views, 0), typical(bench.views, 4));
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
                "  {:<8} {:>11} {:>8} {:>7} {:>8} {:>9} {:>6} {:>7} {:>7} {:>7} {:>7} {:>7}\n",
                faces == 0 ? "" : "\n", row.faces, row.size, row.size,
                row.stage("connectivity").one_thread * 1e6 / double(row.faces), "atlas",
                "layout ms", "us/face", "faster", "spans", "coverage", "L0 dB", "L1", "L2", "L3",
                "views", "16x");
        faces = row.faces;
        print_atlas(row);
    }
}

}  // namespace

const StageBench& AtlasBench::stage(std::string_view name) const {
    return *std::ranges::find(stages, name, &StageBench::stage);
}

std::uint32_t bench_texture(std::size_t faces) {
    const auto texels = static_cast<std::uint32_t>(std::ceil(12.5 * double(faces)));
    const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(double(texels))));
    return std::min(std::bit_ceil(side), max_atlas_size);
}

std::vector<AtlasBench> bench_atlases(std::span<const std::size_t> faces, int repeats,
                                      std::size_t points) {
    std::vector<AtlasBench> result;
    for (const std::size_t count : faces) {
        const AtlasSubject subject(count, points);
        for (const AtlasKind kind : {AtlasKind::uniform, AtlasKind::area, AtlasKind::length,
                                     AtlasKind::quad, AtlasKind::patch, AtlasKind::chart})
            result.push_back(bench_atlas(subject, kind, repeats));
    }
    return result;
}

void run_atlas_bench(const BenchCommand& command) {
    std::vector<std::size_t> faces{1'000, 10'000, 100'000};
    if (command.large) faces.push_back(1'000'000);
    if (command.size > 0) faces = {command.size};
    const std::vector<AtlasBench> rows = bench_atlases(faces, command.repeats);
    if (!report_rows(command, rows, atlas_json)) return;
    print_atlases(rows);
}

}  // namespace burl
