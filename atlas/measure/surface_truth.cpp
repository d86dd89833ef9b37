#include "atlas/measure/surface_truth.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "atlas/base/random_unit.h"
#include "atlas/solid/weights.h"

namespace burl {

namespace {

constexpr std::uint64_t grazing_seed = 1000;
constexpr std::uint32_t least_grazing_side = 32;  // texels

double surface_area(const Mesh& mesh) {
    const TriangleAreas areas = triangle_areas(mesh);
    double total = 0.0;
    for (const double area : areas.areas) total += area;
    return total * areas.unit * areas.unit;
}

LevelTruth level_truth(const Mesh& mesh, const SolidColor& f, std::span<const SurfacePoint> points,
                       double sigma, double detail, std::uint64_t seed,
                       const Elongation& elongation = {}) {
    LevelTruth truth;
    truth.means = surface_means(mesh, f, points, sigma, detail, seed, elongation);
    const std::vector<Vec3d> other =
        surface_means(mesh, f, points, sigma, detail, seed + 1, elongation);
    double squares = 0.0;
    for (std::size_t i = 0; i < other.size(); ++i) {
        const Vec3d difference = other[i] - truth.means[i];
        squares += mean_square(difference);
        truth.means[i] += 0.5 * difference;
    }
    if (!other.empty()) truth.noise = 0.5 * std::sqrt(squares / double(other.size()));
    return truth;
}

GrazingTruth grazing_truth(const Mesh& mesh, const SolidColor& f, const TruthOptions& options,
                           double texel) {
    GrazingTruth truth;
    truth.points = area_uniform_points(mesh, options.grazing_points, options.seed + 2);
    std::vector<Vec3d> across;
    for (std::size_t i = 0; i < truth.points.size(); ++i) {
        const double turn = random_unit(options.seed + grazing_seed, i);
        truth.axes.push_back(random_axes(mesh, truth.points[i].triangle, turn));
        across.push_back(truth.axes.back().across);
    }
    const std::uint32_t last = std::min(options.grazing_levels, options.levels);
    for (std::uint32_t l = 1; l <= last && (options.size >> l) >= least_grazing_side; ++l)
        truth.levels.push_back(level_truth(mesh, f, truth.points, std::ldexp(texel, int(l) - 1),
                                           options.detail, options.seed + grazing_seed + 100 * l,
                                           {grazing_stretch, across}));
    return truth;
}

}  // namespace

SurfaceTruth surface_truth(const Mesh& mesh, const SolidColor& f, const TruthOptions& options) {
    SurfaceTruth truth;
    truth.points = area_uniform_points(mesh, options.points, options.seed);
    truth.level_points = area_uniform_points(mesh, options.level_points, options.seed + 1);
    truth.values.resize(truth.points.size());
    tbb::parallel_for(std::size_t{0}, truth.points.size(),
                      [&](std::size_t i) { truth.values[i] = f(position(mesh, truth.points[i])); });
    truth.texel = std::sqrt(surface_area(mesh)) / double(options.size);
    for (std::uint32_t l = 1; l <= options.levels && (options.size >> l) > 0 && truth.texel > 0.0;
         ++l)
        truth.levels.push_back(l < options.first_level
                                   ? LevelTruth()
                                   : level_truth(mesh, f, truth.level_points,
                                                 std::ldexp(truth.texel, int(l) - 1),
                                                 options.detail, options.seed + 100 * l));
    if (truth.texel > 0.0) truth.grazing = grazing_truth(mesh, f, options, truth.texel);
    if (truth.texel > 0.0 && options.view_points > 0) {
        ViewOptions views;
        views.points = options.view_points;
        views.seed = options.seed;
        truth.views = sample_views(mesh, f, truth.texel, views);
    }
    return truth;
}

}  // namespace burl
