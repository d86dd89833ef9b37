#include "atlas/lookup_errors.h"

#include <cmath>

#include "atlas/bilinear.h"
#include "atlas/chart_borders.h"
#include "atlas/metric_foreign.h"
#include "atlas/metric_mismatch.h"

namespace burl {

namespace {

constexpr std::size_t seam_samples = 50000;
constexpr std::uint64_t seam_seed = 3;

/// Root mean square of what it was given.
class MeanSquare {
  public:
    void add(double value) {
        squares_ += value * value;
        ++count_;
    }
    double root() const { return count_ == 0 ? 0.0 : std::sqrt(squares_ / double(count_)); }
    std::size_t count() const { return count_; }

  private:
    double squares_ = 0.0;
    std::size_t count_ = 0;
};

double decibel(double rmse) {
    return -20.0 * std::log10(rmse);
}

Image<float> rounded_to_8bit(const Image<float>& image) {
    Image<float> result = image;
    for (std::size_t y = 0; y < result.height(); ++y)
        for (float& value : result.row(y)) value = std::round(value * 255.0f) / 255.0f;
    return result;
}

double rmse(const Atlas& atlas, const Image<float>& level, std::span<const SurfacePoint> points,
            std::span<const double> truth) {
    const double scale = double(level.width()) / atlas.options.size;
    MeanSquare errors;
    for (std::size_t i = 0; i < points.size(); ++i)
        errors.add(bilinear(level, place(atlas, points[i]) * scale) - truth[i]);
    return errors.root();
}

void measure_seams(const Atlas& atlas, const Image<float>& image, const ChartBorders& borders,
                   const SurfaceTruth& truth, LookupErrors& errors) {
    MeanSquare seam, interior;
    for (std::size_t i = 0; i < truth.points.size(); ++i) {
        const Vec2d at = place(atlas, truth.points[i]);
        (borders.near(at) ? seam : interior).add(bilinear(image, at) - truth.values[i]);
    }
    errors.seam_rmse = seam.root();
    errors.interior_rmse = interior.root();
    if (!truth.points.empty())
        errors.seam_points = double(seam.count()) / double(truth.points.size());
}

}  // namespace

LookupErrors measure_lookups(const Mesh& mesh, const Atlas& atlas, const TextureValues& texture,
                             std::span<const MeshEdge> edges, const SurfaceTruth& truth) {
    LookupErrors errors;
    measure_seams(atlas, texture.values, ChartBorders(atlas, edges), truth, errors);
    const std::vector<std::uint32_t> charts = measure_charts(mesh, atlas, edges).of_triangle;
    const SeamPoints seams = seam_points(mesh, atlas, edges, seam_samples, seam_seed);
    Image<float> level = texture.values;
    for (std::uint32_t l = 0; l <= truth.levels.size(); ++l) {
        if (l > 0) level = halve(level);
        const auto& points = l == 0 ? truth.points : truth.level_points;
        const auto& values = l == 0 ? truth.values : truth.levels[l - 1].means;
        LevelError error;
        error.level = l;
        error.rmse = rmse(atlas, level, points, values);
        error.rmse_8bit = rmse(atlas, rounded_to_8bit(level), points, values);
        error.truth_noise = l == 0 ? 0.0 : truth.levels[l - 1].noise;
        error.mismatch = mismatch(seams, level, atlas.options.size);
        const ForeignShare share = foreign_share(atlas, texture, charts, truth.level_points, l);
        error.foreign = share.foreign;
        error.other_chart = share.other_chart;
        errors.levels.push_back(error);
    }
    errors.psnr = decibel(errors.levels[0].rmse);
    errors.psnr_8bit = decibel(errors.levels[0].rmse_8bit);
    return errors;
}

}  // namespace burl
