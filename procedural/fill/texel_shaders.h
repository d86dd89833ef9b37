#pragma once
// Shaders of batches of texels, one class per filter: the colour at the texel's centre, averaged
// over the texel by the colour map's integral, or from several samples in it
// (docs/reference/filtering.md). Evaluating f and colouring it are two steps, so that f can be
// cached from one colour map to the next.
#include <algorithm>
#include <optional>
#include <tuple>
#include <vector>

#include "procedural/batch/sample_pattern.h"
#include "procedural/color/filtered_colors.h"
#include "procedural/color/pixel_encoder.h"
#include "procedural/color/point_colors.h"
#include "procedural/color/stream_encoder.h"
#include "procedural/field/corner_samples.h"
#include "procedural/field/sampler.h"
#include "procedural/field/stream_filter.h"

namespace burl {

/// A batch of texels with the buffers of its shader.
struct ShadedBatch : FieldBatch {
    ColorBuffers point_colors;
    std::vector<double> weights;  ///< per texel: sum of the samples' weights
    std::vector<Vec3d> colors;

    CornerBuffers corners;
    FilterBuffers filter;
    bool filtered[batch_capacity];  ///< per texel: whether `means` has its colour
    std::tuple<std::vector<Rgb16>, std::vector<RgbF>> means;
};

// A shader's shade() colours a batch, and pixel() gives one of its texels or pixels() a run of
// them. A shader for which the field's values at the texels' centres are not enough has sample(),
// which evaluates the batch instead of FieldSampler::values.

/// The shader that stores the field.
class FieldCopy {
  public:
    using Pixel = float;
    void shade(ShadedBatch&) const {}
    float pixel(const ShadedBatch& batch, std::size_t at) const { return float(batch.field[at]); }
    float background(double f) const { return float(f); }
};

/// Colours at texel centres, computed in pixels().
template <class P>
class PointColor {
  public:
    using Pixel = P;
    explicit PointColor(const ColorMap& map) : colors_(map) {}
    void shade(ShadedBatch& batch) const {
        std::fill_n(batch.filtered, batch.count, false);
        std::get<std::vector<P>>(batch.means).resize(batch_capacity);
    }
    static void set(ShadedBatch& batch, std::size_t at, P pixel) {
        batch.filtered[at] = true;
        std::get<std::vector<P>>(batch.means)[at] = pixel;
    }
    void pixels(const ShadedBatch& batch, std::size_t at, std::size_t count, P* pixels) const {
        const std::vector<P>& means = std::get<std::vector<P>>(batch.means);
        for (std::size_t j = at; j < at + count; ++j)
            *pixels++ = batch.filtered[j] ? means[j] : background(batch.field[j]);
    }
    P background(double f) const { return colors_(f); }

  private:
    PointColors<P> colors_;
};

/// Colours at texel centres in 8 bits, by table.
template <>
class PointColor<Rgb8> {
  public:
    using Pixel = Rgb8;
    explicit PointColor(const ColorMap& map) : colors_(map) {}
    void shade(ShadedBatch& batch) const {
        colors_.look_up(batch.field, batch.count, batch.point_colors);
    }
    /// Replaces the colour of texel `at`.
    static void set(ShadedBatch& batch, std::size_t at, Rgb8 pixel) {
        batch.point_colors.codes[at].color = pixel;
    }
    void pixels(const ShadedBatch& batch, std::size_t at, std::size_t count, Rgb8* pixels) const {
        colors_.pixels(batch.field, at, count, batch.point_colors, pixels);
    }
    Rgb8 background(double f) const { return colors_(f); }

  private:
    PointColors<Rgb8> colors_;
};

/// The map averaged over the values of f in a texel, to first order. `Point` colours the texels
/// over which the map is straight.
template <class Point>
class FilteredColor {
  public:
    using Pixel = typename Point::Pixel;
    FilteredColor(const ColorMap& map, FilterKind kind)
        : kind_(kind), filtered_(map, kind), point_(map) {
        if (filtered_.exact()) stream_.emplace(MapPieces(map), kind != FilterKind::exact);
    }

    void sample(const FieldSampler& sampler, ShadedBatch& batch) const {
        if (kind_ == FilterKind::trapezoid2) {
            sampler.values(batch);
            average_with_corners(sampler, batch, batch.corners);
        } else {
            sampler.values_and_slopes(batch);
        }
    }
    void shade(ShadedBatch& batch) const {
        if (stream_) fill_means(batch);
    }
    void pixels(const ShadedBatch& batch, std::size_t at, std::size_t count, Pixel* pixels) const {
        if (stream_) return point_.pixels(batch, at, count, pixels);
        const auto& [u, v] = batch.slopes;
        for (std::size_t j = at; j < at + count; ++j)
            *pixels++ = encode_(filtered_(batch.field[j], double(u[j]), double(v[j])));
    }
    Pixel background(double f) const { return point_.background(f); }

  private:
    void fill_means(ShadedBatch& batch) const {
        point_.shade(batch);
        (*stream_)(batch.field, batch.slopes, batch.count, batch.filter,
                   [&](const std::vector<std::uint16_t>& texels, const FootprintStream& stream) {
                       encode_means_(stream, texels.size(), [&](std::size_t i, Pixel pixel) {
                           Point::set(batch, texels[i], pixel);
                       });
                   });
    }

    FilterKind kind_;
    FilteredColors filtered_;
    std::optional<StreamFilter> stream_;  ///< present for the exact filters
    Point point_;
    PixelEncoder<Pixel> encode_;
    StreamEncoder<Pixel> encode_means_;
};

/// Weighted means of the colours of several samples in the texel.
template <class P>
class SupersampledColor {
  public:
    using Pixel = P;
    SupersampledColor(const ColorMap& map, int samples)
        : pattern_(samples), map_(map), point_(map) {}

    /// Evaluates the samples, colours included, because their places are known only here.
    void sample(const FieldSampler& sampler, ShadedBatch& batch) const {
        batch.colors.assign(batch.count, Vec3d(0.0));
        batch.weights.assign(batch.count, 0.0);
        for (int i = 0; i < pattern_.samples(); ++i) {
            place(i, batch);
            sampler.values_at_offsets(batch);
            for (std::size_t j = 0; j < batch.count; ++j) {
                const double u = double(batch.offsets.u[j]), v = double(batch.offsets.v[j]);
                const double weight = gaussian_weight(u, v);
                batch.colors[j] += weight * map_(batch.field[j]);
                batch.weights[j] += weight;
            }
        }
    }
    void shade(ShadedBatch&) const {}
    P pixel(const ShadedBatch& batch, std::size_t at) const {
        return encode_(batch.colors[at] / batch.weights[at]);
    }
    P background(double f) const { return point_.background(f); }

  private:
    void place(int sample, ShadedBatch& batch) const {
        std::size_t at = 0;
        for (const Piece& piece : batch.pieces)
            for (std::size_t j = 0; j < piece.solid.count; ++j, ++at) {
                const auto [u, v] =
                    pattern_(sample, std::uint32_t(piece.x + j), std::uint32_t(piece.y));
                batch.offsets.u[at] = u;
                batch.offsets.v[at] = v;
            }
    }

    SamplePattern pattern_;
    PreparedColorMap map_;
    PointColor<P> point_;
    PixelEncoder<P> encode_;
};

}  // namespace burl
