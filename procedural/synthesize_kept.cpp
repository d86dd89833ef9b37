#include "procedural/synthesize_kept.h"

#include <algorithm>
#include <utility>

#include "procedural/point_colors.h"
#include "procedural/synthesize_pieces.h"

namespace burl {

namespace {

/// Rows of what is kept begin at multiples of this: no vector reaches from one row into the next.
constexpr std::size_t row_alignment = batch_padding;

struct Batch : FieldBatch {
    ColorBuffers colors;
};

bool same_field(const Texture& a, const Texture& b) {
    return a.quadric == b.quadric && a.noise == b.noise;
}

}  // namespace

/// Puts a row's colours, which come in order, where they belong, and the background between them.
template <class Pixel>
class KeptSynthesis::RowPainter {
  public:
    RowPainter(std::span<const Run> runs, std::span<Pixel> row, const PointColors<Pixel>& colors)
        : run_(runs.data()), row_(row), colors_(colors) {
        const Pixel background = colors(0.0);
        std::size_t x = 0;
        for (const Run& run : runs) {
            std::fill(row.begin() + std::ptrdiff_t(x), row.begin() + run.x, background);
            x = run.x + run.count;
        }
        std::fill(row.begin() + std::ptrdiff_t(x), row.end(), background);
    }

    void operator()(const double* f, std::size_t count, ColorBuffers& buffers) {
        colors_.look_up(f, count, buffers);
        for (std::size_t at = 0; at < count;) {
            const std::size_t part = std::min(count - at, run_->count - done_);
            colors_.pixels(f, at, part, buffers, &row_[run_->x + done_]);
            at += part;
            done_ += part;
            if (done_ == run_->count) ++run_, done_ = 0;
        }
    }

  private:
    const Run* run_;
    std::size_t done_ = 0;  ///< texels of the run
    std::span<Pixel> row_;
    const PointColors<Pixel>& colors_;
};

KeptSynthesis::KeptSynthesis(const SolidAtlas& solid, const Affine3& texture_from_atlas,
                             std::size_t budget, Kernel kernel)
    : solid_(&solid), texture_from_atlas_(texture_from_atlas), budget_(budget), kernel_(kernel) {
    find_runs();
}

void KeptSynthesis::find_runs() {
    std::size_t kept = 0;
    for (std::size_t y = 0; y < solid_->size; ++y) {
        row_begin_.push_back(kept);
        run_begin_.push_back(runs_.size());
        for (const Span& span : solid_->row(y)) {
            const bool goes_on =
                runs_.size() > run_begin_.back() && runs_.back().x + runs_.back().count == span.x;
            if (!goes_on) runs_.push_back({span.x, 0});
            runs_.back().count += span.count;
            kept += span.count;
        }
        kept = (kept + row_alignment - 1) / row_alignment * row_alignment;
    }
    row_begin_.push_back(kept);
    run_begin_.push_back(runs_.size());
}

std::size_t KeptSynthesis::bytes() const {
    const std::size_t field = field_.data() ? sizeof(double) : 0;
    const std::size_t quadric = quadric_.data() ? sizeof(double) : 0;
    return row_begin_.back() * (field + quadric + sizeof(float) * octaves_.size());
}

/// Places for the keys' noise, those of before where they hold it already. What is not evaluated
/// after all because of an exception is forgotten.
std::vector<KeptSynthesis::KeptOctave> KeptSynthesis::keep(const std::vector<NoiseKey>& keys) {
    const std::size_t texels = row_begin_.back();
    const std::size_t most = bytes_per_texel();
    if (most >= sizeof(double) && !field_.data()) field_ = KeptArray<double>(texels);
    const std::size_t kept =
        most < sizeof(double) ? 0 : std::min(keys.size(), (most - sizeof(double)) / sizeof(float));

    std::vector<KeptOctave> before = std::exchange(octaves_, {}), octaves(kept);
    for (std::size_t k = 0; k < kept; ++k) {
        octaves[k].key = keys[k];
        const auto same = std::ranges::find(before, keys[k], &KeptOctave::key);
        if (same == before.end()) continue;
        octaves[k].noise = std::move(same->noise);
        octaves[k].known = true;
        before.erase(same);
    }
    const std::size_t rest = most - std::min(most, sizeof(double) + kept * sizeof(float));
    if (rest < sizeof(double)) quadric_ = {};
    for (KeptOctave& octave : octaves) {
        if (octave.known) continue;
        if (before.empty()) {
            octave.noise = KeptArray<float>(texels);
        } else {
            octave.noise = std::move(before.back().noise);
            before.pop_back();
        }
    }
    before.clear();
    if (rest >= sizeof(double) && !quadric_.data()) {
        quadric_ = KeptArray<double>(texels);
        quadric_known_ = false;
    }
    return octaves;
}

template <class Visit>
void KeptSynthesis::for_each_batch(std::size_t y, const Visit& visit) const {
    std::size_t left = 0;
    for (const Run& run : runs(y)) left += run.count;
    for (std::size_t at = row_begin_[y], count = 0; left > 0; left -= count, at += count) {
        count = std::min(left, batch_capacity);
        visit(at, count);
    }
}

template <class Pixel>
void KeptSynthesis::recolor(const Texture& texture, int threads, Image<Pixel>& image) const {
    const PointColors<Pixel> colors(texture.colors);
    for_row_ranges(solid_->size, 8 * batch_capacity, threads, [&](const RowRange& rows) {
        const auto buffers = std::make_unique_for_overwrite<ColorBuffers>();
        for (std::size_t y = rows.begin(); y != rows.end(); ++y) {
            RowPainter<Pixel> paint(runs(y), image.row(y), colors);
            for_each_batch(y, [&](std::size_t at, std::size_t count) {
                paint(field_.data() + at, count, *buffers);
            });
        }
    });
}

template <class Pixel>
void KeptSynthesis::evaluate(const Texture& texture, int threads, Image<Pixel>& image) {
    if (maps_.empty()) maps_ = moved_maps(solid_->maps, texture_from_atlas_, threads);
    const PointColors<Pixel> colors(texture.colors);
    const FieldSampler sampler(texture, false, kernel_);
    field_known_ = false;
    quadric_known_ = quadric_known_ && texture.quadric == texture_.quadric;
    const std::vector<NoiseKey> keys = sampler.noise_keys();
    std::vector<KeptOctave> octaves = keep(keys);
    std::vector<KeptNoise> kept(keys.size());
    std::ranges::transform(octaves, kept.begin(), [](const KeptOctave& octave) {
        return KeptNoise{octave.noise.data(), octave.known};
    });
    const bool quadric_known = std::exchange(quadric_known_, false) && quadric_.data();
    const bool all_known = quadric_known && std::ranges::all_of(kept, &KeptNoise::known);
    for_row_ranges(solid_->size, 8 * batch_capacity, threads, [&](const RowRange& rows) {
        const auto batch = std::make_unique_for_overwrite<Batch>();
        for (std::size_t y = rows.begin(); y != rows.end(); ++y) {
            RowPainter<Pixel> paint(runs(y), image.row(y), colors);
            const auto fill = [&](std::size_t at, std::size_t count) {
                sampler.values(*batch, {kept, quadric_.data(), quadric_known, at});
                if (field_.data()) std::copy_n(batch->field, count, field_.data() + at);
                paint(batch->field, count, batch->colors);
            };
            if (all_known) {
                for_each_batch(y, [&](std::size_t at, std::size_t count) {
                    batch->count = count;
                    fill(at, count);
                });
                continue;
            }
            std::size_t at = row_begin_[y];
            const auto empty = [&] {
                if (batch->count == 0) return;
                fill(at, batch->count);
                at += batch->count;
                batch->pieces.clear();
                batch->count = 0;
            };
            add_row(*solid_, maps_, y, *batch, empty);
            empty();
        }
    });
    work_.octaves_kept = std::size_t(std::ranges::count(kept, true, &KeptNoise::known));
    work_.octaves_evaluated = kept.size() - work_.octaves_kept;
    octaves_ = std::move(octaves);
    field_known_ = field_.data() != nullptr;
    quadric_known_ = quadric_.data() != nullptr;
    texture_ = texture;
}

template <class Pixel>
void KeptSynthesis::synthesize(const Texture& texture, int threads, Image<Pixel>& image) {
    if (image.width() != solid_->size || image.height() != solid_->size)
        image = Image<Pixel>::unset(solid_->size, solid_->size);
    work_ = {field_known_ && same_field(texture, texture_)};
    if (work_.field_kept)
        recolor(texture, threads, image);
    else
        evaluate(texture, threads, image);
}

template void KeptSynthesis::synthesize(const Texture&, int, Image<Rgb8>&);
template void KeptSynthesis::synthesize(const Texture&, int, Image<Rgb16>&);
template void KeptSynthesis::synthesize(const Texture&, int, Image<RgbF>&);

}  // namespace burl
