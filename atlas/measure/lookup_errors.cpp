#include "atlas/measure/lookup_errors.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <tbb/parallel_for.h>

#include "atlas/base/sharp_level.h"
#include "atlas/measure/lookup.h"
#include "atlas/measure/seams.h"

namespace burl {

namespace {

Image<std::uint32_t> to_charts(const Image<std::uint32_t>& triangles,
                               std::span<const std::uint32_t> charts) {
    Image<std::uint32_t> result(triangles.width(), triangles.height(), no_triangle);
    for (std::size_t y = 0; y < triangles.height(); ++y)
        for (std::size_t x = 0; x < triangles.width(); ++x)
            if (triangles(x, y) != no_triangle) result(x, y) = charts[triangles(x, y)];
    return result;
}

/// Share of the texels under texel (x, y) of a level `count` texels wide that are not `chart`'s.
double other_share(const Image<std::uint32_t>& owner, std::uint32_t chart, std::size_t x,
                   std::size_t y, std::size_t count) {
    const std::size_t size = owner.width();
    const auto first = [&](std::size_t i) { return i * size / count; };
    const auto end = [&](std::size_t i) { return ((i + 1) * size + count - 1) / count; };
    const std::size_t width = end(x) - first(x), height = end(y) - first(y);
    std::size_t others = width * height;
    for (std::size_t j = first(y); j < end(y); ++j) {
        const auto row = owner.row(j).subspan(first(x), width);
        others -= std::size_t(std::count(row.begin(), row.end(), chart));
    }
    return double(others) / double(width * height);
}

double other_weight(const Image<std::uint32_t>& owner, std::uint32_t chart, const Vec2d& at,
                    std::size_t count) {
    const BilinearTaps t =
        bilinear_taps(at * (double(count) / double(owner.width())), count, count);
    double others = 0.0;
    for (std::size_t j : {0u, 1u})
        for (std::size_t i : {0u, 1u}) {
            const double weight = t.weight_x[i] * t.weight_y[j];
            if (weight > 0.0) others += weight * other_share(owner, chart, t.x[i], t.y[j], count);
        }
    return others;
}

constexpr std::size_t seam_samples = 50000;
constexpr std::uint64_t seam_seed = 3;

/// Accumulates the root mean square of colour differences.
class MeanSquare {
  public:
    void add(const Vec3d& difference) {
        squares_ += mean_square(difference);
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

Image<Vec3f> stored(const Image<Vec3f>& image, const StoredValue& in_8bit) {
    Image<Vec3f> result = image;
    tbb::parallel_for(std::size_t{0}, result.height(), [&](std::size_t y) {
        for (Vec3f& value : result.row(y))
            for (int k = 0; k < 3; ++k) value[k] = float(in_8bit(double(value[k])));
    });
    return result;
}

MipChain<Vec3f> stored_chain(const Image<Vec3f>& image, const StoredValue& in_8bit) {
    MipChain<Vec3f> chain;
    chain.levels.push_back(stored(image, in_8bit));
    while (chain.levels.back().width() > 1)
        chain.levels.push_back(stored(halve(chain.levels.back()), in_8bit));
    return chain;
}

/// Sharpens levels 1 and up and stores them by `in_8bit`, if there is any.
void sharpen_levels(MipChain<Vec3f>& chain, const StoredValue& in_8bit = {}) {
    for (Image<Vec3f>& level : std::span(chain.levels).subspan(1)) {
        sharpen(level);
        if (in_8bit) level = stored(level, in_8bit);
    }
}

/// Lookups of one chain of levels at points of the surface.
struct Lookups {
    const Mesh& mesh;
    const Atlas& atlas;
    const SurfaceTruth& truth;
    const MipChain<Vec3f>& chain;

    double plain(std::uint32_t l) const {
        const auto& points = l == 0 ? truth.points : truth.level_points;
        const auto& values = l == 0 ? truth.values : truth.levels[l - 1].means;
        return lookup_rmse(atlas, chain.levels[l], points, values);
    }

    double grazing(std::uint32_t l) const {
        const double sigma = std::ldexp(truth.texel, int(l) - 1);
        const GrazingTruth& grazing = truth.grazing;
        std::vector<Vec3d> seen(grazing.points.size());
        tbb::parallel_for(std::size_t{0}, seen.size(), [&](std::size_t i) {
            const SurfacePoint& point = grazing.points[i];
            const auto in_texture = [&](const Vec3d& v) {
                return mapped(mesh, atlas, point.triangle, v);
            };
            const FootprintAxes& axes = grazing.axes[i];
            seen[i] = anisotropic(chain, place(atlas, point),
                                  texel_footprint(in_texture(grazing_stretch * sigma * axes.along),
                                                  in_texture(sigma * axes.across)));
        });
        MeanSquare errors;
        for (std::size_t i = 0; i < seen.size(); ++i)
            errors.add(seen[i] - grazing.levels[l - 1].means[i]);
        return errors.root();
    }
};

void measure_seams(const Atlas& atlas, const Image<Vec3f>& image, const ChartBorders& borders,
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

/// Measures the errors of all levels stored as floats, and everything else that does not depend on
/// storage in 8 bits.
void measure_levels(const Lookups& lookups, const TextureValues& texture,
                    std::span<const MeshEdge> edges, LookupErrors& errors) {
    const auto& [mesh, atlas, truth, chain] = lookups;
    const std::vector<std::uint32_t> charts = measure_charts(mesh, atlas, edges).of_triangle;
    const SeamPoints seams = seam_points(mesh, atlas, edges, seam_samples, seam_seed);
    for (std::uint32_t l = 0; l <= truth.levels.size(); ++l) {
        LevelError error;
        error.level = l;
        error.rmse = lookups.plain(l);
        error.truth_noise = l == 0 ? 0.0 : truth.levels[l - 1].noise;
        error.mismatch = mismatch(seams, chain.levels[l], atlas.options.size);
        const ForeignShare share = foreign_share(atlas, texture, charts, truth.level_points, l);
        error.foreign = share.foreign;
        error.other_chart = share.other_chart;
        if (l > 0 && l <= truth.grazing.levels.size())
            error.grazing =
                GrazingError{lookups.grazing(l), 0.0, truth.grazing.levels[l - 1].noise};
        errors.levels.push_back(error);
    }
}

void measure_8bit(const Lookups& lookups, LookupErrors& errors) {
    for (LevelError& error : errors.levels) {
        error.rmse_8bit = lookups.plain(error.level);
        if (error.grazing) error.grazing->rmse_8bit = lookups.grazing(error.level);
    }
}

}  // namespace

ForeignShare foreign_share(const Atlas& atlas, const TextureValues& texture,
                           std::span<const std::uint32_t> charts,
                           std::span<const SurfacePoint> points, std::uint32_t level) {
    ForeignShare share;
    if (points.empty()) return share;
    const Image<std::uint32_t> owner = to_charts(texture.owner, charts);
    const Image<std::uint32_t> shown = to_charts(texture.shown, charts);
    const std::size_t count = std::max<std::size_t>(1, owner.width() >> level);
    std::vector<ForeignShare> each(points.size());
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
        const Vec2d at = place(atlas, points[i]);
        const std::uint32_t chart = charts[points[i].triangle];
        each[i] = {other_weight(owner, chart, at, count), other_weight(shown, chart, at, count)};
    });
    for (const ForeignShare& one : each) {
        share.foreign += one.foreign / double(points.size());
        share.other_chart += one.other_chart / double(points.size());
    }
    return share;
}

double lookup_rmse(const Atlas& atlas, const Image<Vec3f>& level,
                   std::span<const SurfacePoint> points, std::span<const Vec3d> values) {
    const double scale = double(level.width()) / atlas.options.size;
    MeanSquare errors;
    for (std::size_t i = 0; i < points.size(); ++i)
        errors.add(bilinear(level, place(atlas, points[i]) * scale) - values[i]);
    return errors.root();
}

std::vector<ViewError> view_errors(const Mesh& mesh, const Atlas& atlas,
                                   const MipChain<Vec3f>& chain, const SampledViews& views) {
    std::vector<ViewError> errors;
    for (const ViewRow& row : views.rows) {
        using Squares = std::array<double, view_samplers.size()>;
        std::vector<Squares> squares(views.points.size());
        tbb::parallel_for(std::size_t{0}, squares.size(), [&](std::size_t i) {
            const SurfacePoint& point = views.points[i];
            const PixelSteps steps = views.steps(i, row);
            const Vec2d at = place(atlas, point);
            const TexelSteps texels{mapped(mesh, atlas, point.triangle, steps.x),
                                    mapped(mesh, atlas, point.triangle, steps.y)};
            for (std::size_t k = 0; k < view_samplers.size(); ++k)
                squares[i][k] =
                    mean_square(view_samplers[k].lookup(chain, at, texels) - row.means[i]);
        });
        ViewError error{row.minification, row.tilt, {}, row.noise};
        for (std::size_t k = 0; k < view_samplers.size(); ++k) {
            double sum = 0.0;
            for (const Squares& one : squares) sum += one[k];
            error.rmse[k] = squares.empty() ? 0.0 : std::sqrt(sum / double(squares.size()));
        }
        errors.push_back(error);
    }
    return errors;
}

LookupErrors measure_lookups(const Mesh& mesh, const Atlas& atlas, const TextureValues& texture,
                             std::span<const MeshEdge> edges, const SurfaceTruth& truth,
                             const StoredValue& in_8bit, bool sharp) {
    LookupErrors errors;
    errors.sharp = sharp;
    measure_seams(atlas, texture.values, ChartBorders(atlas, edges), truth, errors);
    MipChain<Vec3f> chain = build_mip_chain(texture.values);
    if (sharp) sharpen_levels(chain);
    measure_levels({mesh, atlas, truth, chain}, texture, edges, errors);
    errors.views = view_errors(mesh, atlas, chain, truth.views);
    MipChain<Vec3f> in_codes = stored_chain(texture.values, in_8bit);
    if (sharp) sharpen_levels(in_codes, in_8bit);
    measure_8bit({mesh, atlas, truth, in_codes}, errors);
    errors.psnr = decibel(errors.levels[0].rmse);
    errors.psnr_8bit = decibel(errors.levels[0].rmse_8bit);
    return errors;
}

}  // namespace burl
