#pragma once
// Texels of an atlas as point samples of a graph, one each or the weighted mean of several: batches
// of points for a value program, and colours stored as pixels.
#include <memory>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/filter.h"
#include "procedural/batch/row_tasks.h"
#include "procedural/batch/row_window.h"
#include "procedural/batch/sample_pattern.h"
#include "procedural/batch/texel_batch.h"
#include "procedural/color/pixel_encoder.h"
#include "procedural/color/srgb.h"
#include "procedural/graph/values.h"
#include "procedural/kernels/quadric_kernel.h"

namespace burl {

/// Stores colours, given channel by channel, as pixels.
template <class Pixel>
class BatchEncoder {
  public:
    void operator()(const std::array<const double*, 3>& c, std::size_t count, Pixel* pixels) const {
        for (std::size_t j = 0; j < count; ++j) pixels[j] = encode_({c[0][j], c[1][j], c[2][j]});
    }

  private:
    PixelEncoder<Pixel> encode_;
};

template <>
class BatchEncoder<Rgb8> {
  public:
    void operator()(const std::array<const double*, 3>& c, std::size_t count, Rgb8* pixels) const {
        alignas(64) std::uint8_t codes[3][value_batch + batch_padding];
        for (std::size_t i = 0; i < 3; ++i) encode_(c[i], count, codes[i]);
        for (std::size_t j = 0; j < count; ++j) pixels[j] = {codes[0][j], codes[1][j], codes[2][j]};
    }

  private:
    SrgbStreamEncoder encode_;
};

/// The batch of texels of one thread.
template <class Pixel>
class PointQueue {
  public:
    PointQueue(const GraphValues& graph, const Filter& filter, const BatchEncoder<Pixel>& encode,
               const RowBand<Pixel>& image)
        : graph_(graph),
          supersampled_(filter.kind == FilterKind::supersample),
          pattern_(supersampled_ ? filter.samples : 1),
          encode_(encode),
          image_(image),
          scratch_(graph.make_scratch()),
          sums_(supersampled_ ? 4 : 0) {}

    /// Adds a span's texels. Their points are computed from the span's start, so the bytes do not
    /// depend on batches.
    void add(const Piece& span) {
        for (std::size_t done = 0; done < span.solid.count;) {
            Piece piece = span;
            piece.x += done;
            piece.solid.first = span.solid.first + double(done);
            piece.solid.count = std::min(span.solid.count - done, value_batch - count_);
            done += piece.solid.count;
            count_ += piece.solid.count;
            pieces_.push_back(piece);
            if (count_ == value_batch) flush();
        }
    }

    /// Evaluates the batch and stores its pixels.
    void flush() {
        if (count_ == 0) return;
        scratch_.work.texels += count_;
        encode_(supersampled_ ? mean_colors() : point_colors(), count_, pixels_);
        const Pixel* from = pixels_;
        for (const Piece& piece : pieces_) {
            std::copy_n(from, piece.solid.count, &image_(piece.x, piece.y));
            from += piece.solid.count;
        }
        pieces_.clear();
        count_ = 0;
    }

    /// The work of the texels flushed.
    const SynthesisWork& work() const { return scratch_.work; }

  private:
    std::array<const double*, 3> point_colors() {
        for (int axis = 0; axis < 3; ++axis) {
            lines_.clear();
            for (const auto& [x, y, solid, down, length] : pieces_)
                lines_.push_back(
                    {solid.start[axis], solid.step[axis], 0.0, solid.first, solid.count});
            fill_parabolas(lines_, scratch_[Register(axis)]);
        }
        return graph_(count_, scratch_);
    }

    /// The weighted means of all samples' colours.
    std::array<const double*, 3> mean_colors() {
        for (auto& sum : sums_) std::fill_n(sum.values, count_, 0.0);
        for (int i = 0; i < pattern_.samples(); ++i) {
            place_samples(i);
            const auto color = graph_(count_, scratch_);
            for (std::size_t j = 0; j < count_; ++j) {
                for (std::size_t c = 0; c < 3; ++c) sums_[c].values[j] += weights_[j] * color[c][j];
                sums_[3].values[j] += weights_[j];
            }
        }
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t j = 0; j < count_; ++j) sums_[c].values[j] /= sums_[3].values[j];
        return {sums_[0].values, sums_[1].values, sums_[2].values};
    }

    void place_samples(int sample) {
        std::size_t at = 0;
        for (const auto& [x, y, solid, down, length] : pieces_)
            for (std::size_t j = 0; j < solid.count; ++j, ++at) {
                const auto [a, b] = pattern_(sample, std::uint32_t(x + j), std::uint32_t(y));
                const double u = double(a), v = double(b);
                const Vec3d p = solid.start + (solid.first + double(j) + u) * solid.step + v * down;
                for (int axis = 0; axis < 3; ++axis) scratch_[Register(axis)][at] = p[axis];
                weights_[at] = gaussian_weight(u, v);
            }
    }

    const GraphValues& graph_;
    bool supersampled_;
    SamplePattern pattern_;
    const BatchEncoder<Pixel>& encode_;
    const RowBand<Pixel>& image_;
    GraphValues::Scratch scratch_;
    std::vector<GraphValues::Scratch::Array> sums_;
    std::vector<Piece> pieces_;
    std::vector<ParabolaLine> lines_;
    std::size_t count_ = 0;
    double weights_[value_batch];
    Pixel pixels_[value_batch];
};

/// The number of texels of these rows that lie in no span.
inline std::uint64_t texels_outside(const SolidAtlas& solid, const RowWindow& rows) {
    std::uint64_t count = std::uint64_t(solid.size) * rows.count();
    for (std::size_t y = rows.first; y < rows.end; ++y)
        for (const Span& span : solid.row(y)) count -= span.count;
    return count;
}

/// Fills the rows' texels that lie in spans by point samples of a value program; rows are filled in
/// parallel.
template <class Pixel>
void fill_points(const SolidAtlas& solid, const Affine3& map, const GraphValues& graph,
                 const Filter& filter, int threads, const Economy& economy,
                 const RowBand<Pixel>& image) {
    const BatchEncoder<Pixel> encode;
    WorkSum work(economy.work);
    const RowWindow rows = image.rows();
    RowGroups groups(solid.size, 16 * value_batch);
    groups.size = rows.count();
    const auto fill_rows = [&](const RowRange& range) {
        const auto queue = std::make_unique<PointQueue<Pixel>>(graph, filter, encode, image);
        for (std::size_t row = groups.begin(range.begin()); row != groups.begin(range.end());
             ++row) {
            const std::size_t y = rows.first + row;
            if (row % groups.rows == 0) queue->flush();
            for (const Span& span : solid.row(y)) {
                const TexelMap& texel = solid.maps[span.map];
                const WholeSpan whole = solid.whole(span);
                queue->add(
                    {span.x, y,
                     LatticeLine{map(texel(whole.x, std::int64_t(y))), map.linear * texel.step_x,
                                 double(span.x - whole.x), span.count},
                     map.linear * texel.step_y, double(whole.count)});
            }
        }
        queue->flush();
        work.add(queue->work());
    };
    for_row_ranges(groups.count(), 1, threads, fill_rows, economy.stop);
    SynthesisWork gaps;
    gaps.skip_texels(Skip::unread_texels, texels_outside(solid, rows));
    work.add(gaps);
}

}  // namespace burl
