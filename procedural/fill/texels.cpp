#include "procedural/fill/texels.h"

#include <optional>

#include "procedural/batch/economy.h"
#include "procedural/batch/row_tasks.h"
#include "procedural/batch/sample_pattern.h"
#include "procedural/batch/texel_batch.h"
#include "procedural/color/filtered_colors.h"
#include "procedural/color/pixel_encoder.h"
#include "procedural/color/table.h"
#include "procedural/fixed/field.h"
#include "procedural/model/band_limit.h"

namespace burl {

namespace {

/// The field f in float64.
class ExactField {
  public:
    ExactField(const Texture& texture, bool band_limit)
        : quadric_(texture.quadric), octaves_(expand_octaves(texture)) {
        for (const Octave& octave : octaves_)
            if (band_limit) means_.push_back(octave_mean(octave));
    }

    double operator()(const Vec3d& s) const { return evaluate_field(quadric_, octaves_, s); }
    FieldSample sample(const Vec3d& s) const { return sample_field<double>(quadric_, octaves_, s); }

    bool band_limited() const { return !means_.empty(); }
    /// The field as texels of these sides show it: each octave times its visible share, plus its
    /// mean times the rest.
    ExactField seen_by(const Footprint& steps) const {
        ExactField field = *this;
        field.octaves_.clear();
        for (std::size_t k = 0; k < octaves_.size(); ++k) {
            Octave octave = octaves_[k];
            const Mat3d& map = octave.lattice_from_solid.linear;
            const double weight = band_weight(map * steps.u, map * steps.v);
            field.quadric_.j += (1.0 - weight) * means_[k];
            octave.scale *= weight;
            if (weight > 0.0)
                field.octaves_.push_back(octave);
            else
                field.quadric_.j += octave.offset;
        }
        return field;
    }

  private:
    Quadric quadric_;
    std::vector<Octave> octaves_;
    std::vector<double> means_;  ///< the octaves' means, with a band limit
};

/// The field as texels of these sides show it: unchanged in fixed point.
const FixedField& seen_by(const FixedField& field, const Footprint&, std::optional<FixedField>&) {
    return field;
}

/// The field as texels of these sides show it; `limited` holds it where it differs.
const ExactField& seen_by(const ExactField& field, const Footprint& steps,
                          std::optional<ExactField>& limited) {
    return field.band_limited() ? limited.emplace(field.seen_by(steps)) : field;
}

/// The texels to fill, and how the loop over them runs.
struct Task {
    const SolidAtlas& solid;
    const Affine3& map;
    int threads = 0;
    const Economy& economy;
    RowWindow rows;
    std::uint64_t octaves = 0;  ///< evaluations of octaves per texel, for the economy's counts
};

/// An image of pixel(field, texel) for every texel in a span, and of `background` elsewhere.
template <class Pixel, class Field, class Shade>
Image<Pixel> fill(const Task& task, const Field& whole, const Pixel& background,
                  const Shade& pixel) {
    const SolidAtlas& solid = task.solid;
    const Affine3& map = task.map;
    constexpr std::size_t texels_per_task = 1024;
    Image<Pixel> rows_of_image(solid.size, task.rows.count(), background);
    const RowBand image(rows_of_image, task.rows.first);
    WorkSum total(task.economy.work);
    const auto fill_rows = [&](const RowRange& rows) {
        SynthesisWork work;
        std::optional<Field> limited;
        for (std::size_t y = image.first + rows.begin(); y != image.first + rows.end(); ++y)
            for (const Span& span : solid.row(y)) {
                const TexelMap& texel = solid.maps[span.map];
                const Footprint steps{map.linear * texel.step_x, map.linear * texel.step_y};
                const Field& field = seen_by(whole, steps, limited);
                for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                    image(x, y) = pixel(field, TexelPlace{x, std::uint32_t(y), span.map,
                                                          map(texel(x, std::int64_t(y))), steps});
                work.texels += span.count;
            }
        work.octaves = work.texels * task.octaves;
        total.add(work);
        task.economy.count(1, work.texels);
    };
    for_row_ranges(task.rows.count(), texels_per_task, task.threads, fill_rows, task.economy.stop);
    return rows_of_image;
}

/// The weighted mean of the colours of several samples in the texel.
template <class Field>
Vec3d supersampled(const PreparedColorMap& map, const SamplePattern& pattern, const Field& field,
                   const TexelPlace& texel) {
    Vec3d sum(0.0);
    double weights = 0.0;
    for (int i = 0; i < pattern.samples(); ++i) {
        const auto [a, b] = pattern(i, texel.x, texel.y);
        const double u = double(a), v = double(b), weight = gaussian_weight(u, v);
        sum += weight * map(field(texel.point + u * texel.steps.u + v * texel.steps.v));
        weights += weight;
    }
    return sum / weights;
}

/// The values of f over a texel as a filter sees them: their middle and their spread along each
/// side.
struct Spread {
    double middle = 0.0, u = 0.0, v = 0.0;
};

/// The spread to first order, from differences.
Spread central_spread(const FixedField& field, const TexelPlace& texel) {
    const auto [f, u, v] = spread_over(field, texel.point, texel.steps);
    return {f, u, v};
}

/// The spread to first order, from value and gradient at the centre.
Spread central_spread(const ExactField& field, const TexelPlace& texel) {
    const FieldSample sample = field.sample(texel.point);
    return {sample.value, glm::dot(sample.gradient, texel.steps.u),
            glm::dot(sample.gradient, texel.steps.v)};
}

/// The spread to second order, from the values at centre and corners (field/corner_samples.h).
template <class Field>
Spread corner_spread(const Field& field, const TexelPlace& texel) {
    const auto [u, v] = texel.steps;
    const double f = field(texel.point);
    const double a = field(texel.point - 0.5 * u - 0.5 * v),
                 b = field(texel.point + 0.5 * u - 0.5 * v),
                 c = field(texel.point - 0.5 * u + 0.5 * v),
                 d = field(texel.point + 0.5 * u + 0.5 * v);
    return {f + ((a - f) + (b - f) + (c - f) + (d - f)) / 12.0, 0.5 * ((b - a) + (d - c)),
            0.5 * ((c - a) + (d - b))};
}

template <class Pixel, class Field>
Image<Pixel> sampled_colors(const Task& task, const ColorMap& colors, const Filter& filter,
                            const Field& field) {
    const PreparedColorMap color(colors);
    const PixelEncoder<Pixel> encode;
    const Pixel background = encode(color(0.0));
    if (filter.kind == FilterKind::supersample) {
        const SamplePattern pattern(filter.samples);
        return fill(task, field, background, [&](const Field& f, const TexelPlace& t) {
            return encode(supersampled(color, pattern, f, t));
        });
    }
    return fill(task, field, background,
                [&](const Field& f, const TexelPlace& t) { return encode(color(f(t.point))); });
}

template <class Pixel, class Field>
Image<Pixel> filtered_colors(const Task& task, const ColorMap& colors, const Filter& filter,
                             const Field& field) {
    const FilteredColors color(colors, filter.kind);
    const PixelEncoder<Pixel> encode;
    const bool curved = filter.kind == FilterKind::trapezoid2;
    return fill(task, field, encode(PreparedColorMap(colors)(0.0)),
                [&](const Field& f, const TexelPlace& t) {
                    const auto [middle, u, v] = curved ? corner_spread(f, t) : central_spread(f, t);
                    return encode(color(middle, u, v));
                });
}

/// The image by the way of evaluation that the filter needs.
template <class Pixel, class Field>
Image<Pixel> colors_of(const Task& task, const ColorMap& colors, const Filter& filter,
                       const Field& field) {
    if (filter.kind == FilterKind::none || filter.kind == FilterKind::supersample)
        return sampled_colors<Pixel>(task, colors, filter, field);
    return filtered_colors<Pixel>(task, colors, filter, field);
}

/// The number of times that every octave is evaluated per texel.
std::uint64_t evaluations(const Filter& filter, bool in_fixed_point) {
    switch (filter.kind) {
        case FilterKind::none:
            return 1;
        case FilterKind::supersample:
            return std::uint64_t(filter.samples);
        case FilterKind::trapezoid2:
            return 5;
        default:
            return in_fixed_point ? 3 : 1;
    }
}

}  // namespace

template <class Pixel>
Image<Pixel> synthesize_texels(const SolidAtlas& solid, const Texture& texture, const Affine3& map,
                               const Precision& precision, const Filter& filter, int threads,
                               const Economy& economy, const RowWindow& rows) {
    const bool in_fixed_point = precision.kind == PrecisionKind::fixed;
    const Task task{solid,
                    map,
                    threads,
                    economy,
                    rows.of(solid.size),
                    evaluations(filter, in_fixed_point) * expand_octaves(texture).size()};
    if (in_fixed_point)
        return colors_of<Pixel>(task, texture.colors, filter,
                                FixedField(texture, precision.format));
    return colors_of<Pixel>(task, texture.colors, filter, ExactField(texture, filter.band_limit));
}

template Image<Rgb8> synthesize_texels(const SolidAtlas&, const Texture&, const Affine3&,
                                       const Precision&, const Filter&, int, const Economy&,
                                       const RowWindow&);
template Image<Rgb16> synthesize_texels(const SolidAtlas&, const Texture&, const Affine3&,
                                        const Precision&, const Filter&, int, const Economy&,
                                        const RowWindow&);
template Image<RgbF> synthesize_texels(const SolidAtlas&, const Texture&, const Affine3&,
                                       const Precision&, const Filter&, int, const Economy&,
                                       const RowWindow&);

Image<double> field_of_texels(const SolidAtlas& solid, const Texture& texture, const Affine3& map,
                              const Precision& precision, int threads) {
    const auto value = [](const auto& field, const TexelPlace& t) { return field(t.point); };
    const Economy nothing;
    const Task task{solid, map, threads, nothing, RowWindow().of(solid.size), 0};
    if (precision.kind == PrecisionKind::fixed)
        return fill(task, FixedField(texture, precision.format), 0.0, value);
    return fill(task, ExactField(texture, false), 0.0, value);
}

}  // namespace burl
