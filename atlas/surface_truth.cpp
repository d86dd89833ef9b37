#include "atlas/surface_truth.h"

#include <cmath>

#include <tbb/parallel_for.h>

#include "atlas/weights.h"

namespace burl {

namespace {

double surface_area(const Mesh& mesh) {
    const TriangleAreas areas = triangle_areas(mesh);
    double total = 0.0;
    for (const double area : areas.areas) total += area;
    return total * areas.unit * areas.unit;
}

LevelTruth level_truth(const Mesh& mesh, const SolidFunction& f,
                       std::span<const SurfacePoint> points, double sigma, double detail,
                       std::uint64_t seed) {
    LevelTruth truth;
    truth.means = surface_means(mesh, f, points, sigma, detail, seed);
    const std::vector<double> other = surface_means(mesh, f, points, sigma, detail, seed + 1);
    double squares = 0.0;
    for (std::size_t i = 0; i < other.size(); ++i) {
        const double difference = other[i] - truth.means[i];
        squares += difference * difference;
        truth.means[i] += 0.5 * difference;
    }
    if (!other.empty()) truth.noise = 0.5 * std::sqrt(squares / double(other.size()));
    return truth;
}

}  // namespace

SurfaceTruth surface_truth(const Mesh& mesh, const SolidFunction& f, const TruthOptions& options) {
    SurfaceTruth truth;
    truth.points = area_uniform_points(mesh, options.points, options.seed);
    truth.level_points = area_uniform_points(mesh, options.level_points, options.seed + 1);
    truth.values.resize(truth.points.size());
    tbb::parallel_for(std::size_t{0}, truth.points.size(),
                      [&](std::size_t i) { truth.values[i] = f(position(mesh, truth.points[i])); });
    const double texel = std::sqrt(surface_area(mesh)) / double(options.size);
    for (std::uint32_t l = 1; l <= options.levels && (options.size >> l) > 0 && texel > 0.0; ++l)
        truth.levels.push_back(level_truth(mesh, f, truth.level_points,
                                           std::ldexp(texel, int(l) - 1), options.detail,
                                           options.seed + 100 * l));
    return truth;
}

}  // namespace burl
