#include "procedural/synthesize.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <tuple>

#include "procedural/corner_samples.h"
#include "procedural/field_sampler.h"
#include "procedural/filtered_colors.h"
#include "procedural/pixel_encoder.h"
#include "procedural/point_colors.h"
#include "procedural/sample_pattern.h"
#include "procedural/stream_encoder.h"
#include "procedural/stream_filter.h"
#include "procedural/synthesize_pieces.h"

namespace burl {

namespace {

struct Batch : FieldBatch {
    ColorBuffers point_colors;
    std::vector<double> weights;  ///< sums over several samples of a texel
    std::vector<Vec3d> colors;

    CornerBuffers corners;
    FilterBuffers filter;
    bool filtered[batch_capacity];  ///< whether `means` counts
    std::tuple<std::vector<Rgb16>, std::vector<RgbF>> means;
};

// Shaders: prepare() samples a batch, pixel() gives one of its texels, or pixels() a run of them.

class FieldCopy {
  public:
    using Pixel = float;
    void prepare(const FieldSampler& sampler, Batch& batch) const { sampler.values(batch); }
    float pixel(const Batch& batch, std::size_t at) const { return float(batch.field[at]); }
    float background(double f) const { return float(f); }
};

/// Colours at texel centres, worked out where they are asked for.
template <class P>
class PointColor {
  public:
    using Pixel = P;
    explicit PointColor(const ColorMap& map) : colors_(map) {}
    void prepare(const FieldSampler& sampler, Batch& batch) const {
        sampler.values(batch);
        shade(batch);
    }
    void shade(Batch& batch) const {
        std::fill_n(batch.filtered, batch.count, false);
        std::get<std::vector<P>>(batch.means).resize(batch_capacity);
    }
    static void set(Batch& batch, std::size_t at, P pixel) {
        batch.filtered[at] = true;
        std::get<std::vector<P>>(batch.means)[at] = pixel;
    }
    void pixels(const Batch& batch, std::size_t at, std::size_t count, P* pixels) const {
        const std::vector<P>& means = std::get<std::vector<P>>(batch.means);
        for (std::size_t j = at; j < at + count; ++j)
            *pixels++ = batch.filtered[j] ? means[j] : background(batch.field[j]);
    }
    P background(double f) const { return colors_(f); }

  private:
    PointColors<P> colors_;
};

/// In 8 bits, by table.
template <>
class PointColor<Rgb8> {
  public:
    using Pixel = Rgb8;
    explicit PointColor(const ColorMap& map) : colors_(map) {}
    void prepare(const FieldSampler& sampler, Batch& batch) const {
        sampler.values(batch);
        shade(batch);
    }
    void shade(Batch& batch) const {
        colors_.look_up(batch.field, batch.count, batch.point_colors);
    }
    /// Instead of the colour at its centre.
    static void set(Batch& batch, std::size_t at, Rgb8 pixel) {
        batch.point_colors.codes[at].color = pixel;
    }
    void pixels(const Batch& batch, std::size_t at, std::size_t count, Rgb8* pixels) const {
        colors_.pixels(batch.field, at, count, batch.point_colors, pixels);
    }
    Rgb8 background(double f) const { return colors_(f); }

  private:
    PointColors<Rgb8> colors_;
};

/// The map averaged over what f takes on in a texel, to first order. `Point` colours the texels
/// over which the map is straight.
template <class Point>
class FilteredColor {
  public:
    using Pixel = typename Point::Pixel;
    FilteredColor(const ColorMap& map, FilterKind kind)
        : kind_(kind), filtered_(map, kind), point_(map) {
        if (filtered_.exact()) stream_.emplace(MapPieces(map), kind != FilterKind::exact);
    }

    void prepare(const FieldSampler& sampler, Batch& batch) const {
        if (kind_ == FilterKind::trapezoid2) {
            sampler.values(batch);
            average_with_corners(sampler, batch, batch.corners);
        } else {
            sampler.values_and_slopes(batch);
        }
        if (stream_) fill_means(batch);
    }
    void pixels(const Batch& batch, std::size_t at, std::size_t count, Pixel* pixels) const {
        if (stream_) return point_.pixels(batch, at, count, pixels);
        const auto& [u, v] = batch.slopes;
        for (std::size_t j = at; j < at + count; ++j)
            *pixels++ = encode_(filtered_(batch.field[j], double(u[j]), double(v[j])));
    }
    Pixel background(double f) const { return point_.background(f); }

  private:
    void fill_means(Batch& batch) const {
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
    std::optional<StreamFilter> stream_;  ///< of the exact filters
    Point point_;
    PixelEncoder<Pixel> encode_;
    StreamEncoder<Pixel> encode_means_;
};

/// Colours of several places in the texel, weighted.
template <class P>
class SupersampledColor {
  public:
    using Pixel = P;
    SupersampledColor(const ColorMap& map, int samples)
        : pattern_(samples), map_(map), point_(map) {}

    void prepare(const FieldSampler& sampler, Batch& batch) const {
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
    P pixel(const Batch& batch, std::size_t at) const {
        return encode_(batch.colors[at] / batch.weights[at]);
    }
    P background(double f) const { return point_.background(f); }

  private:
    void place(int sample, Batch& batch) const {
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

/// Pieces from `begin` on that follow one another in a row of the image: where they end, and the
/// number of their texels.
std::pair<std::size_t, std::size_t> run_of(std::span<const Piece> pieces, std::size_t begin) {
    std::size_t end = begin + 1, count = pieces[begin].solid.count;
    while (end < pieces.size() && pieces[end].y == pieces[begin].y &&
           pieces[end].x == pieces[begin].x + count)
        count += pieces[end++].solid.count;
    return {end, count};
}

template <class Shader>
void flush(Batch& batch, const FieldSampler& sampler, const Shader& shader,
           Image<typename Shader::Pixel>& image) {
    if (batch.count == 0) return;
    shader.prepare(sampler, batch);
    std::size_t at = 0;
    for (std::size_t i = 0; i < batch.pieces.size();) {
        auto* pixels = &image(batch.pieces[i].x, batch.pieces[i].y);
        const auto [end, count] = run_of(batch.pieces, i);
        if constexpr (requires { shader.pixels(batch, at, count, pixels); })
            shader.pixels(batch, at, count, pixels);
        else
            for (std::size_t j = 0; j < count; ++j) pixels[j] = shader.pixel(batch, at + j);
        at += count;
        i = end;
    }
    batch.pieces.clear();
    batch.count = 0;
}

template <class Shader>
void synthesize_rows(const SolidAtlas& solid, std::span<const TexelMap> maps,
                     const FieldSampler& sampler, const Shader& shader, const RowRange& rows,
                     Image<typename Shader::Pixel>& image) {
    const auto background = shader.background(0.0);
    const auto batch = std::make_unique_for_overwrite<Batch>();
    const auto empty = [&] { flush(*batch, sampler, shader, image); };
    for (std::size_t y = rows.begin(); y != rows.end(); ++y) {
        fill_gaps(solid.row(y), background, image.row(y));
        add_row(solid, maps, y, *batch, empty);
    }
    empty();
}

template <class Shader>
Image<typename Shader::Pixel> synthesize(const SolidAtlas& solid, const Texture& texture,
                                         const Affine3& map, const Filter& filter, int threads,
                                         Kernel kernel, const Shader& shader) {
    auto image = Image<typename Shader::Pixel>::unset(solid.size, solid.size);
    const FieldSampler sampler(texture, filter.band_limit, kernel);
    const std::vector<TexelMap> maps = moved_maps(solid.maps, map, threads);
    for_row_ranges(solid.size, 8 * batch_capacity, threads, [&](const RowRange& rows) {
        synthesize_rows(solid, maps, sampler, shader, rows, image);
    });
    return image;
}

template <class Pixel>
Image<Pixel> synthesize_colors(const SolidAtlas& solid, const Texture& texture, const Affine3& map,
                               const Filter& filter, int threads, Kernel kernel) {
    const ColorMap& colors = texture.colors;
    const auto run = [&](const auto& shader) {
        return synthesize(solid, texture, map, filter, threads, kernel, shader);
    };
    if (filter.kind == FilterKind::none) return run(PointColor<Pixel>(colors));
    if (filter.kind == FilterKind::supersample)
        return run(SupersampledColor<Pixel>(colors, filter.samples));
    return run(FilteredColor<PointColor<Pixel>>(colors, filter.kind));
}

}  // namespace

Image<Rgb8> synthesize_rgb8(const SolidAtlas& solid, const Texture& texture,
                            const Affine3& texture_from_atlas, int threads, const Filter& filter,
                            Kernel kernel) {
    return synthesize_colors<Rgb8>(solid, texture, texture_from_atlas, filter, threads, kernel);
}

Image<Rgb16> synthesize_rgb16(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads, const Filter& filter,
                              Kernel kernel) {
    return synthesize_colors<Rgb16>(solid, texture, texture_from_atlas, filter, threads, kernel);
}

Image<RgbF> synthesize_rgbf(const SolidAtlas& solid, const Texture& texture,
                            const Affine3& texture_from_atlas, int threads, const Filter& filter,
                            Kernel kernel) {
    return synthesize_colors<RgbF>(solid, texture, texture_from_atlas, filter, threads, kernel);
}

Image<float> synthesize_field(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads, Kernel kernel) {
    return synthesize(solid, texture, texture_from_atlas, {}, threads, kernel, FieldCopy());
}

}  // namespace burl
