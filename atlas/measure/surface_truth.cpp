#include "atlas/measure/surface_truth.h"

#include <algorithm>
#include <bit>
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

/// The last level that textures of the options' size have.
std::uint32_t last_level(const TruthOptions& options) {
    return std::min(options.levels, std::uint32_t(std::bit_width(options.size)) - 1);
}

/// The last level with grazing footprints; 0 without any.
std::uint32_t last_grazing(const TruthOptions& options) {
    std::uint32_t last = 0;
    while (last < std::min(options.grazing_levels, options.levels) &&
           (options.size >> (last + 1)) >= least_grazing_side)
        ++last;
    return last;
}

ViewOptions view_options(const TruthOptions& options) {
    ViewOptions views;
    views.points = options.view_points;
    views.seed = options.seed;
    return views;
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
    for (std::uint32_t l = 1; l <= last_grazing(options); ++l)
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
    for (std::uint32_t l = 1; l <= last_level(options) && truth.texel > 0.0; ++l)
        truth.levels.push_back(l < options.first_level
                                   ? LevelTruth()
                                   : level_truth(mesh, f, truth.level_points,
                                                 std::ldexp(truth.texel, int(l) - 1),
                                                 options.detail, options.seed + 100 * l));
    if (truth.texel > 0.0) truth.grazing = grazing_truth(mesh, f, options, truth.texel);
    if (truth.texel > 0.0 && options.view_points > 0)
        truth.views = sample_views(mesh, f, truth.texel, view_options(options));
    return truth;
}

double truth_calls(const Mesh& mesh, const TruthOptions& options) {
    const double texel = std::sqrt(surface_area(mesh)) / double(options.size);
    double calls = double(options.points);
    if (!(texel > 0.0)) return calls;
    const auto add = [&](std::uint32_t level, std::size_t points, double stretch) {
        calls += 2.0 * surface_mean_calls(mesh, points, std::ldexp(texel, int(level) - 1),
                                          options.detail, stretch);
    };
    for (std::uint32_t l = options.first_level; l <= last_level(options); ++l)
        add(l, options.level_points, 1.0);
    for (std::uint32_t l = 1; l <= last_grazing(options); ++l)
        add(l, options.grazing_points, grazing_stretch);
    return calls + view_calls(view_options(options));
}

}  // namespace burl
