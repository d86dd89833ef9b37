#include "procedural/kept/kept.h"

#include <algorithm>
#include <utility>

#include "procedural/batch/economy.h"
#include "procedural/color/point_colors.h"
#include "procedural/fill/pieces.h"
#include "procedural/fill/synthesize.h"
#include "procedural/fill/texel_shaders.h"
#include "procedural/kept/recolor.h"

namespace burl {

namespace {

/// Whether the filter needs the derivatives of f.
bool wants_slopes(FilterKind kind) {
    return kind != FilterKind::none && kind != FilterKind::supersample;
}

/// Stores the pixels of a batch whose colours were looked up.
template <class Pixel>
void paint(const PointColors<Pixel>& colors, const double* f, std::size_t count,
           const ColorBuffers& buffers, RowPainter<Pixel>& painter) {
    painter(count, [&](std::size_t at, std::size_t part, Pixel* pixels) {
        colors.pixels(f, at, part, buffers, pixels);
    });
}

/// Shades a batch and stores its pixels.
template <class Shader>
void paint(const Shader& shader, ShadedBatch& batch, RowPainter<typename Shader::Pixel>& painter) {
    shader.shade(batch);
    painter(batch.count, [&](std::size_t at, std::size_t part, auto* pixels) {
        shader.pixels(batch, at, part, pixels);
    });
}

}  // namespace

/// Batch of one thread with the arrays of its colours.
struct KeptSynthesis::Batch : FieldBatch {
    ColorBuffers colors;
};

/// Parameters of evaluate_row that all rows of a texture share.
template <class Pixel>
struct KeptSynthesis::Evaluation {
    const FieldSampler& sampler;
    const PointColors<Pixel>& colors;
    Pixel background;
    KeptBatch kept;  ///< caches of the whole picture
    double* field;   ///< cache of f; null: f is not cached
    /// Whether the quadric and all octaves are in the cache.
    bool all_known;
};

KeptSynthesis::KeptSynthesis(const SolidAtlas& solid, const Affine3& texture_from_atlas,
                             std::size_t budget, Kernel kernel)
    : solid_(&solid),
      texture_from_atlas_(texture_from_atlas),
      budget_(budget),
      kernel_(kernel),
      rows_(solid),
      lines_(solid) {}

void KeptSynthesis::set_map(const Affine3& texture_from_atlas) {
    if (texture_from_atlas == texture_from_atlas_) return;
    texture_from_atlas_ = texture_from_atlas;
    maps_.clear();
    forget();
}

KeptSynthesis::FieldKey KeptSynthesis::field_key(const Texture& texture, const Filter& filter) {
    const FilterKind kind = filter.kind == FilterKind::trapezoid2 || !wants_slopes(filter.kind)
                                ? filter.kind
                                : FilterKind::exact;
    return {texture.quadric, texture.noise, kind, filter.band_limit};
}

/// Notes what changed since the last texture; octave k is compared with octave k of that texture.
void KeptSynthesis::note_changes(const std::vector<NoiseKey>& keys, const FieldKey& field) {
    octave_changes_.resize(keys.size());
    for (std::size_t k = 0; k < keys.size(); ++k)
        octave_changes_[k].note(moved_ || (k < last_keys_.size() && last_keys_[k] != keys[k]));
    quadric_change_.note(moved_ || (last_field_ && last_field_->quadric != field.quadric));
    std::vector<bool> cause;
    if (moved_ || (last_field_ && *last_field_ != field)) {
        cause.push_back(quadric_change_.now);
        for (const Change& octave : octave_changes_) cause.push_back(octave.now);
    }
    field_again_ = !cause.empty() && cause == field_cause_;
    field_cause_ = std::move(cause);
    moved_ = false;
    last_keys_ = keys;
    last_field_ = field;
}

void KeptSynthesis::count_recolored(const Economy& economy) const {
    if (!economy.work) return;
    economy.work->texels += rows_.texels();
    economy.work->skip_octaves(Skip::kept_terms, octaves_per_texel_ * rows_.texels());
}

template <class Pixel>
void KeptSynthesis::recolor(const Texture& texture, int threads, const Economy& economy,
                            Image<Pixel>& image) {
    const Wrap wrap = texture.colors.wrap;
    const RecolorTask task{rows_, solid_->size, threads, economy};
    field_cause_.clear();
    count_recolored(economy);
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        if (keep_entries()) {
            const bool known = known_entries_ == wrap;
            known_entries_.reset();
            recolor_places(task, texture.colors, field_.data(), known, entries_.data(), image);
            if (known || !economy.stop.stop_requested()) known_entries_ = wrap;
            return;
        }
    recolor_field(task, texture.colors, field_.data(), image);
}

template <class Pixel>
void KeptSynthesis::evaluate_row(std::size_t y, const Evaluation<Pixel>& to, Batch& batch,
                                 Image<Pixel>& image) {
    RowPainter<Pixel> painter(rows_.runs(y), image.row(y), to.background);
    KeptBatch kept = to.kept;
    kept.at = rows_.begin(y);
    const auto fill = [&](std::size_t count) {
        batch.count = count;
        to.sampler.values(batch, kept);
        if (to.field) std::copy_n(batch.field, count, to.field + kept.at);
        to.colors.look_up(batch.field, count, batch.colors);
        paint(to.colors, batch.field, count, batch.colors, painter);
        batch.streams.work.texels += count;
        kept.at += count;
    };
    if (to.all_known)
        return rows_.for_each_batch(y, [&](std::size_t, std::size_t count) { fill(count); });
    if (lines_.kept() && !to.sampler.needs_pieces(to.kept, lines_.longest(y)))
        return lines_.for_each_batch(y, maps_, [&](const SpanLines& lines) {
            kept.lines = &lines;
            fill(lines.texels);
        });
    PieceReader pieces(*solid_, maps_, {y, y + 1});
    while (pieces.read(batch)) fill(batch.count);
}

template <class Pixel>
void KeptSynthesis::evaluate(const Texture& texture, int threads, const Economy& economy,
                             Image<Pixel>& image) {
    const PointColors<Pixel> colors(texture.colors);
    const FieldSampler sampler(texture, false, kernel_, economy.skips);
    known_field_.reset();
    known_entries_.reset();
    const std::vector<NoiseKey> keys = sampler.noise_keys();
    note_changes(keys, field_key(texture, {}));
    std::vector<KeptOctave> octaves = keep(keys);
    double* const field = field_again_ ? nullptr : field_.data();
    const FieldStart start = start_.begin(sampler.sum(), field ? nullptr : field_.data());
    std::vector<KeptNoise> kept;
    for (KeptOctave& octave : octaves) {
        const bool started = start.known && kept.size() < start.octaves;
        if (started && !octave.known) octave.noise = {};  // the prefix holds the octave
        kept.push_back({octave.noise.data(), octave.known || started});
    }
    const bool quadric_known = known_quadric_ == texture.quadric;
    known_quadric_.reset();
    const bool fills_quadric = !quadric_known && !quadric_change_.again && !start.known;
    double* const quadric = quadric_known || fills_quadric ? quadric_.data() : nullptr;
    const bool all_known =
        (quadric_known || start.known) && std::ranges::all_of(kept, &KeptNoise::known);
    const Evaluation<Pixel> to{
        sampler, colors, colors(0.0), {kept, quadric, quadric_known, 0, start}, field, all_known};
    if (lines_fit_ && !all_known && !sampler.needs_pieces(to.kept, 0.0)) lines_.keep();
    WorkSum work(economy.work);
    const auto fill_rows = [&](const RowRange& range) {
        const auto batch = std::make_unique_for_overwrite<Batch>();
        for (std::size_t y = range.begin(); y != range.end(); ++y)
            evaluate_row(y, to, *batch, image);
        work.add(batch->streams.work);
    };
    for_row_ranges(solid_->size, 8 * batch_capacity, threads, fill_rows, economy.stop);
    work_.octaves_kept = std::size_t(std::ranges::count(kept, true, &KeptNoise::known));
    work_.octaves_evaluated = kept.size() - work_.octaves_kept;
    octaves_per_texel_ = kept.size();
    const bool stopped = economy.stop.stop_requested();
    if (stopped) std::erase_if(octaves, [](const KeptOctave& octave) { return !octave.known; });
    octaves_ = std::move(octaves);
    if (quadric && (quadric_known || !stopped)) known_quadric_ = texture.quadric;
    start_.end(start.known || !stopped);
    if (field && !stopped) known_field_ = field_key(texture, {});
}

template <class Shader>
void KeptSynthesis::recolor_with(const Shader& shader, int threads, const Economy& economy,
                                 Image<typename Shader::Pixel>& image) const {
    const auto background = shader.background(0.0);
    const auto color_rows = [&](const RowRange& range) {
        const auto batch = std::make_unique_for_overwrite<ShadedBatch>();
        for (std::size_t y = range.begin(); y != range.end(); ++y) {
            RowPainter painter(rows_.runs(y), image.row(y), background);
            rows_.for_each_batch(y, [&](std::size_t at, std::size_t count) {
                batch->count = count;
                std::copy_n(field_.data() + at, count, batch->field);
                if (slopes_u_.data()) {
                    std::copy_n(slopes_u_.data() + at, count, batch->slopes.u);
                    std::copy_n(slopes_v_.data() + at, count, batch->slopes.v);
                }
                paint(shader, *batch, painter);
            });
        }
    };
    for_row_ranges(solid_->size, 8 * batch_capacity, threads, color_rows, economy.stop);
    count_recolored(economy);
}

template <class Shader>
void KeptSynthesis::evaluate_with(const Shader& shader, const Texture& texture,
                                  const Filter& filter, int threads, const Economy& economy,
                                  Image<typename Shader::Pixel>& image) {
    const auto background = shader.background(0.0);
    const FieldSampler sampler(texture, filter.band_limit, kernel_, economy.skips);
    known_field_.reset();
    const bool slopes = slopes_u_.data() != nullptr;
    WorkSum work(economy.work);
    const auto fill_rows = [&](const RowRange& range) {
        const auto batch = std::make_unique_for_overwrite<ShadedBatch>();
        for (std::size_t y = range.begin(); y != range.end(); ++y) {
            RowPainter painter(rows_.runs(y), image.row(y), background);
            std::size_t at = rows_.begin(y);
            PieceReader pieces(*solid_, maps_, {y, y + 1});
            while (pieces.read(*batch)) {
                const std::size_t count = batch->count;
                if constexpr (requires { shader.sample(sampler, *batch); })
                    shader.sample(sampler, *batch);
                else
                    sampler.values(*batch);
                std::copy_n(batch->field, count, field_.data() + at);
                if (slopes) {
                    std::copy_n(batch->slopes.u, count, slopes_u_.data() + at);
                    std::copy_n(batch->slopes.v, count, slopes_v_.data() + at);
                }
                paint(shader, *batch, painter);
                batch->streams.work.texels += count;
                at += count;
            }
        }
        work.add(batch->streams.work);
        work.add(batch->corners.batch->streams.work);
    };
    for_row_ranges(solid_->size, 8 * batch_capacity, threads, fill_rows, economy.stop);
    octaves_per_texel_ = sampler.noise_keys().size();
    if (!economy.stop.stop_requested()) known_field_ = field_key(texture, filter);
}

template <class Pixel, class Shader>
void KeptSynthesis::synthesize_with(const Shader& shader, const Texture& texture,
                                    const Filter& filter, int threads, const Economy& economy,
                                    Image<Pixel>& image) {
    if (work_.field_kept) return recolor_with(shader, threads, economy, image);
    forget_octaves();
    if (keep_field(wants_slopes(filter.kind)))
        evaluate_with(shader, texture, filter, threads, economy, image);
    else
        image = synthesize_model<Pixel>(*solid_, texture, texture_from_atlas_, threads, filter,
                                        kernel_, economy);
}

template <class Pixel>
void KeptSynthesis::synthesize(const Texture& texture, int threads, Image<Pixel>& image,
                               const Filter& filter, const Economy& economy) {
    work_ = {};
    if (filter.kind == FilterKind::supersample) {
        image = synthesize_model<Pixel>(*solid_, texture, texture_from_atlas_, threads, filter,
                                        kernel_, economy);
        return;
    }
    if (image.width() != solid_->size || image.height() != solid_->size)
        image = Image<Pixel>::unset(solid_->size, solid_->size);
    if (maps_.empty()) maps_ = moved_maps(solid_->maps, texture_from_atlas_, threads);
    if (economy.work)
        economy.work->skip_texels(Skip::unread_texels,
                                  std::uint64_t(solid_->size) * solid_->size - rows_.texels());
    work_.field_kept = known_field_ == field_key(texture, filter);
    const ColorMap& colors = texture.colors;
    if (wants_slopes(filter.kind))
        synthesize_with(FilteredColor<PointColor<Pixel>>(colors, filter.kind), texture, filter,
                        threads, economy, image);
    else if (filter.band_limit)
        synthesize_with(PointColor<Pixel>(colors), texture, filter, threads, economy, image);
    else if (work_.field_kept)
        recolor(texture, threads, economy, image);
    else
        evaluate(texture, threads, economy, image);
}

template void KeptSynthesis::synthesize(const Texture&, int, Image<Rgb8>&, const Filter&,
                                        const Economy&);
template void KeptSynthesis::synthesize(const Texture&, int, Image<Rgb16>&, const Filter&,
                                        const Economy&);
template void KeptSynthesis::synthesize(const Texture&, int, Image<RgbF>&, const Filter&,
                                        const Economy&);

}  // namespace burl
