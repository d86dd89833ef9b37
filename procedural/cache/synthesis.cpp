#include "procedural/cache/synthesis.h"

#include <algorithm>
#include <memory>

#include "procedural/batch/economy.h"
#include "procedural/batch/row_tasks.h"
#include "procedural/color/point_colors.h"
#include "procedural/fill/pieces.h"
#include "procedural/fill/synthesize.h"
#include "procedural/fill/texel_shaders.h"

namespace burl {

namespace {

/// Texels that a thread takes at least.
constexpr std::size_t texels_of_task = 8 * batch_capacity;

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

/// Parameters of one call of synthesize().
struct CachedSynthesis::Job {
    const Texture& texture;
    const Filter& filter;
    int threads;
    const Economy& economy;
    FieldKey key{texture, filter};

    bool complete() const { return !economy.stop.stop_requested(); }
};

/// Batch of one thread with the arrays of its colours.
struct CachedSynthesis::Batch : FieldBatch {
    ColorBuffers colors;
};

/// Parameters of evaluate_row that all rows of a texture share.
template <class Pixel>
struct CachedSynthesis::Evaluation {
    const FieldSampler& sampler;
    const PointColors<Pixel>& colors;
    Pixel background;
    const FieldUse& use;
};

CachedSynthesis::CachedSynthesis(const SolidAtlas& solid, const Affine3& texture_from_atlas,
                                 std::size_t budget, Kernel kernel)
    : solid_(&solid),
      texture_from_atlas_(texture_from_atlas),
      kernel_(kernel),
      cache_(solid, budget) {}

void CachedSynthesis::set_map(const Affine3& texture_from_atlas) {
    if (texture_from_atlas == texture_from_atlas_) return;
    texture_from_atlas_ = texture_from_atlas;
    maps_.clear();
    cache_.invalidate();
}

template <class Pixel>
Image<Pixel> CachedSynthesis::from_scratch(const Job& job) const {
    return synthesize_model<Pixel>(*solid_, job.texture, texture_from_atlas_, job.threads,
                                   job.filter, kernel_, job.economy);
}

template <class Pixel>
void CachedSynthesis::evaluate_row(std::size_t y, const Evaluation<Pixel>& to, Batch& batch,
                                   Image<Pixel>& image) const {
    const TexelLayout& layout = cache_.memory().layout;
    RowPainter<Pixel> painter(layout.runs(y), image.row(y), to.background);
    KeptBatch arrays = to.use.arrays;
    arrays.at = layout.begin(y);
    const auto fill = [&](std::size_t count) {
        batch.count = count;
        to.sampler.values(batch, arrays);
        if (to.use.field) std::copy_n(batch.field, count, to.use.field + arrays.at);
        to.colors.look_up(batch.field, count, batch.colors);
        paint(to.colors, batch.field, count, batch.colors, painter);
        batch.streams.work.texels += count;
        arrays.at += count;
    };
    if (to.use.all_known)
        return layout.for_each_batch(y, [&](std::size_t, std::size_t count) { fill(count); });
    SpanLineCache* const cached = to.use.lines;
    if (cached && !to.sampler.needs_pieces(to.use.arrays, cached->longest(y)))
        return cached->for_each_batch(y, maps_, [&](const SpanLines& lines) {
            arrays.lines = &lines;
            fill(lines.texels);
        });
    PieceReader pieces(*solid_, maps_, {y, y + 1});
    while (pieces.read(batch)) fill(batch.count);
}

template <class Pixel>
void CachedSynthesis::evaluate(const Job& job, Image<Pixel>& image) {
    const PointColors<Pixel> colors(job.texture.colors);
    const FieldSampler sampler(job.texture, false, kernel_, job.economy.skips);
    const FieldUse use = cache_.begin(job.key, sampler);
    const Evaluation<Pixel> to{sampler, colors, colors(0.0), use};
    WorkSum work(job.economy.work);
    const auto fill_rows = [&](const RowRange& range) {
        const auto batch = std::make_unique_for_overwrite<Batch>();
        for (std::size_t y = range.begin(); y != range.end(); ++y)
            evaluate_row(y, to, *batch, image);
        work.add(batch->streams.work);
        job.economy.count(1, texels_of(*solid_, range.begin(), range.end()));
    };
    for_row_ranges(solid_->size, texels_of_task, job.threads, fill_rows, job.economy.stop);
    const auto octaves = use.arrays.octaves;
    octaves_per_texel_ = octaves.size();
    work_.octaves_cached = std::size_t(std::ranges::count(octaves, true, &KeptNoise::known));
    work_.octaves_evaluated = octaves.size() - work_.octaves_cached;
    cache_.end(job.key, use, job.complete());
}

template <class Shader>
void CachedSynthesis::evaluate_by(const Shader& shader, const Job& job,
                                  Image<typename Shader::Pixel>& image) {
    const auto background = shader.background(0.0);
    const FieldSampler sampler(job.texture, job.filter.band_limit, kernel_, job.economy.skips);
    const CacheMemory& memory = cache_.memory();
    WorkSum work(job.economy.work);
    const auto fill_rows = [&](const RowRange& range) {
        const auto batch = std::make_unique_for_overwrite<ShadedBatch>();
        for (std::size_t y = range.begin(); y != range.end(); ++y) {
            RowPainter painter(memory.layout.runs(y), image.row(y), background);
            std::size_t at = memory.layout.begin(y);
            PieceReader pieces(*solid_, maps_, {y, y + 1});
            while (pieces.read(*batch)) {
                const std::size_t count = batch->count;
                if constexpr (requires { shader.sample(sampler, *batch); })
                    shader.sample(sampler, *batch);
                else
                    sampler.values(*batch);
                std::copy_n(batch->field, count, memory.field.data() + at);
                if (job.key.has_slopes()) {
                    std::copy_n(batch->slopes.u, count, memory.slopes_u.data() + at);
                    std::copy_n(batch->slopes.v, count, memory.slopes_v.data() + at);
                }
                paint(shader, *batch, painter);
                batch->streams.work.texels += count;
                at += count;
            }
        }
        work.add(batch->streams.work);
        work.add(batch->corners.batch->streams.work);
        job.economy.count(1, texels_of(*solid_, range.begin(), range.end()));
    };
    for_row_ranges(solid_->size, texels_of_task, job.threads, fill_rows, job.economy.stop);
    octaves_per_texel_ = sampler.noise_keys().size();
    cache_.end_filtered(job.key, job.complete());
}

template <class Buffers, class Pixel, class Color>
void CachedSynthesis::recolor_rows(const Job& job, const Pixel& background, Image<Pixel>& image,
                                   const Color& color) const {
    const TexelLayout& layout = cache_.memory().layout;
    const auto color_rows = [&](const RowRange& range) {
        const auto buffers = std::make_unique_for_overwrite<Buffers>();
        for (std::size_t y = range.begin(); y != range.end(); ++y) {
            RowPainter<Pixel> painter(layout.runs(y), image.row(y), background);
            layout.for_each_batch(
                y, [&](std::size_t at, std::size_t count) { color(at, count, *buffers, painter); });
        }
        job.economy.count(1, texels_of(*solid_, range.begin(), range.end()));
    };
    for_row_ranges(solid_->size, texels_of_task, job.threads, color_rows, job.economy.stop);
    if (!job.economy.work) return;
    job.economy.work->texels += layout.texels();
    job.economy.work->skip_octaves(Skip::kept_terms, octaves_per_texel_ * layout.texels());
}

template <class Shader>
void CachedSynthesis::recolor_by(const Shader& shader, const Job& job,
                                 Image<typename Shader::Pixel>& image) const {
    const CacheMemory& memory = cache_.memory();
    const auto color = [&](std::size_t at, std::size_t count, ShadedBatch& batch, auto& painter) {
        batch.count = count;
        std::copy_n(memory.field.data() + at, count, batch.field);
        if (job.key.has_slopes()) {
            std::copy_n(memory.slopes_u.data() + at, count, batch.slopes.u);
            std::copy_n(memory.slopes_v.data() + at, count, batch.slopes.v);
        }
        paint(shader, batch, painter);
    };
    recolor_rows<ShadedBatch>(job, shader.background(0.0), image, color);
}

template <class Pixel>
void CachedSynthesis::recolor(const Job& job, Image<Pixel>& image) {
    const PointColors<Pixel> colors(job.texture.colors);
    const double* const field = cache_.memory().field.data();
    const Wrap wrap = job.texture.colors.wrap;
    cache_.repeat();
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        if (const EntriesUse use = cache_.begin_entries(wrap); use.entries) {
            const auto color = [&](std::size_t at, std::size_t count, ColorBuffers& buffers,
                                   auto& painter) {
                if (!use.known) colors.index(field + at, count, use.entries + at);
                colors.look_up(use.entries + at, field + at, count, buffers);
                paint(colors, field + at, count, buffers, painter);
            };
            recolor_rows<ColorBuffers>(job, colors(0.0), image, color);
            return cache_.end_entries(wrap, job.complete());
        }
    recolor_rows<ColorBuffers>(
        job, colors(0.0), image,
        [&](std::size_t at, std::size_t count, ColorBuffers& buffers, auto& painter) {
            colors.look_up(field + at, count, buffers);
            paint(colors, field + at, count, buffers, painter);
        });
}

template <class Shader>
void CachedSynthesis::synthesize_by(const Shader& shader, const Job& job,
                                    Image<typename Shader::Pixel>& image) {
    if (work_.field_cached)
        recolor_by(shader, job, image);
    else if (cache_.begin_filtered(job.key))
        evaluate_by(shader, job, image);
    else
        image = from_scratch<typename Shader::Pixel>(job);
}

template <class Pixel>
void CachedSynthesis::synthesize(const Texture& texture, int threads, Image<Pixel>& image,
                                 const Filter& filter, const Economy& economy) {
    const Job job{texture, filter, threads, economy};
    const std::uint64_t size = solid_->size;
    work_ = {};
    if (filter.kind == FilterKind::supersample) {
        image = from_scratch<Pixel>(job);
        return;
    }
    if (image.width() != size || image.height() != size) image = Image<Pixel>::unset(size, size);
    if (maps_.empty()) maps_ = moved_maps(solid_->maps, texture_from_atlas_, threads);
    if (economy.work)
        economy.work->skip_texels(Skip::unread_texels,
                                  size * size - cache_.memory().layout.texels());
    work_.field_cached = cache_.holds(job.key);
    if (job.key.has_slopes())
        synthesize_by(FilteredColor<PointColor<Pixel>>(texture.colors, filter.kind), job, image);
    else if (filter.band_limit)
        synthesize_by(PointColor<Pixel>(texture.colors), job, image);
    else if (work_.field_cached)
        recolor(job, image);
    else
        evaluate(job, image);
}

template void CachedSynthesis::synthesize(const Texture&, int, Image<Rgb8>&, const Filter&,
                                          const Economy&);
template void CachedSynthesis::synthesize(const Texture&, int, Image<Rgb16>&, const Filter&,
                                          const Economy&);
template void CachedSynthesis::synthesize(const Texture&, int, Image<RgbF>&, const Filter&,
                                          const Economy&);

}  // namespace burl
