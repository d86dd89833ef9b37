#include "app/bench/scale.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <functional>

#include <fmt/format.h>

#include "app/bake/material.h"
#include "app/bench/command.h"
#include "app/bench/meshes.h"
#include "app/image/image_io.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/json.h"
#include "atlas/base/memory.h"

namespace burl {

namespace {

/// A number of bytes of /proc/self/status, such as "VmRSS"; 0 where there is none.
double bytes_told(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(name + ":")) return 1024.0 * std::stod(line.substr(name.size() + 1));
    return 0.0;
}

/// Has the system count the peak of resident memory anew.
void forget_peak() {
    return_freed_memory();
    std::ofstream("/proc/self/clear_refs") << 5;
}

/// Runs stages of a bake, and adds what they take to their series.
class ScaleRuns {
  public:
    explicit ScaleRuns(std::string unit) : unit_(std::move(unit)) {}

    /// Memory that is resident now is not counted from here on.
    void begin() {
        return_freed_memory();
        before_ = bytes_told("VmRSS");
    }

    void run(const std::string& stage, std::size_t units, const std::function<void()>& work) {
        forget_peak();
        const std::clock_t start = std::clock();
        work();
        const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
        const double peak = std::max(bytes_told("VmHWM") - before_, 0.0);
        series_of(stage).points.push_back({double(units), seconds, peak});
    }

    std::vector<ScaleSeries> series() { return std::move(series_); }

  private:
    ScaleSeries& series_of(const std::string& stage) {
        const auto found = std::ranges::find(series_, stage, &ScaleSeries::stage);
        if (found != series_.end()) return *found;
        return series_.emplace_back(ScaleSeries{stage, unit_});
    }

    std::string unit_;
    double before_ = 0.0;
    std::vector<ScaleSeries> series_;
};

Recipe recipe_of(const std::string& name, AtlasKind kind, std::uint32_t side) {
    Recipe recipe = load_recipe(name);
    recipe.atlas.kind = kind;
    recipe.atlas.size = side;
    return recipe;
}

/// Layouts and solid points of meshes of the sizes.
std::vector<ScaleSeries> over_triangles(const ScaleSizes& sizes) {
    ScaleRuns runs("triangle");
    for (const std::size_t faces : sizes.faces)
        for (const AtlasKind kind : {AtlasKind::quad, AtlasKind::patch, AtlasKind::chart}) {
            runs.begin();
            Pipeline pipeline(bumpy_sphere(faces));
            pipeline.set_recipe(recipe_of("marble", kind, sizes.side));
            const std::size_t count = pipeline.mesh().triangles.size();
            const std::string name(to_string(kind));
            if (kind == AtlasKind::quad)
                runs.run("connectivity", count, [&] { pipeline.connectivity(); });
            else
                pipeline.connectivity();
            runs.run(name + " layout", count, [&] { pipeline.mesh_atlas(); });
            runs.run(name + " points", count, [&] { pipeline.solid(); });
        }
    return runs.series();
}

/// Textures and materials of the sizes.
std::vector<ScaleSeries> over_texels(const ScaleSizes& sizes) {
    const BenchFolder folder;
    ScaleRuns runs("texel");
    for (const std::uint32_t side : sizes.sides) {
        runs.begin();
        Pipeline pipeline(bumpy_sphere(sizes.mesh));
        pipeline.set_recipe(recipe_of("marble", AtlasKind::chart, side));
        pipeline.mesh_atlas();
        const std::size_t count = std::size_t(side) * side;
        runs.run("points", count, [&] { pipeline.solid(); });
        Image<Rgb8> image;
        runs.run("synthesis", count, [&] { image = pipeline.synthesize<Rgb8>(); });
        runs.run("write", count, [&] { write_png((folder.path / "a.png").string(), image); });
        image = {};
        pipeline.set_recipe(recipe_of("moss", AtlasKind::chart, side));
        MaterialAsked asked;
        asked.packing = Packing::separate;
        asked.levels = std::uint32_t(std::log2(side));
        runs.run("material", count, [&] { bake_material(pipeline, asked); });
    }
    return runs.series();
}

Json scale_json(const ScaleSeries& series) {
    Json points = Json::array();
    for (const ScalePoint& point : series.points)
        points.push_back({{"units", point.units},
                          {"processor_seconds", point.seconds},
                          {"peak_bytes", point.peak_bytes}});
    return {{"stage", series.stage},
            {"unit", series.unit},
            {"points", points},
            {"exponent", series.exponent()},
            {"bytes_per_unit", series.bytes_per_unit()}};
}

/// Prints the series: per size the processor's time for a unit, in the end how it grows and what a
/// unit takes.
void print_scale(const std::vector<ScaleSeries>& all) {
    std::string unit;
    for (const ScaleSeries& series : all) {
        if (series.unit != unit) {
            fmt::print("{}{:<16}", unit.empty() ? "" : "\n", "ns/" + series.unit);
            for (const ScalePoint& point : series.points) fmt::print(" {:>11.0f}", point.units);
            fmt::print(" {:>9} {:>12} {:>9}\n", "exponent", "bytes/" + series.unit, "peak MB");
        }
        unit = series.unit;
        fmt::print("{:<16}", series.stage);
        for (const ScalePoint& point : series.points)
            fmt::print(" {:>11.1f}", point.seconds * 1e9 / point.units);
        fmt::print(" {:>9.2f} {:>12.0f} {:>9.0f}\n", series.exponent(), series.bytes_per_unit(),
                   series.points.back().peak_bytes / 1e6);
    }
}

}  // namespace

double log_log_slope(std::span<const double> x, std::span<const double> y) {
    const auto count = double(x.size());
    double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += std::log(x[i]) / count;
        mean_y += std::log(y[i]) / count;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = std::log(x[i]) - mean_x;
        xx += dx * dx;
        xy += dx * (std::log(y[i]) - mean_y);
    }
    return xy / xx;
}

double ScaleSeries::exponent() const {
    std::vector<double> x, y;
    for (const ScalePoint& point : points) {
        x.push_back(point.units);
        y.push_back(std::max(point.seconds, 1e-9));
    }
    return log_log_slope(x, y);
}

double ScaleSeries::bytes_per_unit() const {
    const ScalePoint &least = points.front(), &most = points.back();
    return (most.peak_bytes - least.peak_bytes) / (most.units - least.units);
}

std::vector<ScaleSeries> bench_scale(const ScaleSizes& sizes) {
    std::vector<ScaleSeries> all = over_triangles(sizes);
    std::ranges::move(over_texels(sizes), std::back_inserter(all));
    return all;
}

void run_scale_bench(const BenchCommand& command) {
    ScaleSizes sizes;
    if (command.large) {
        sizes.faces = {1'250'000, 2'500'000, 5'000'000, 10'000'000};
        sizes.side = 4096;
        sizes.sides = {2048, 4096, 8192, 16384};
    }
    const std::vector<ScaleSeries> all = bench_scale(sizes);
    if (report_rows(command, all, scale_json)) print_scale(all);
}

}  // namespace burl
