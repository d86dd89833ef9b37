#pragma once
// Texels of an atlas as point samples of a graph, one each or the weighted mean of several: batches
// of points for a value program, and colours stored as pixels.
#include <memory>
#include <span>
#include <utility>
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
#include "procedural/fill/mask_images.h"
#include "procedural/fill/pieces.h"
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

/// The arrays of planes over a batch of texels.
using PlaneArrays = std::span<const double* const>;

/// Stores the first three planes, a colour, as pixels of an image.
template <class Pixel>
class ImageStore {
  public:
    /// Both must outlive this object.
    ImageStore(const BatchEncoder<Pixel>& encode, const RowBand<Pixel>& image)
        : encode_(encode), image_(image) {}

    void operator()(PlaneArrays planes, std::size_t count, std::span<const Piece> pieces) {
        encode_({planes[0], planes[1], planes[2]}, count, pixels_);
        const Pixel* from = pixels_;
        for (const Piece& piece : pieces) {
            std::copy_n(from, piece.solid.count, &image_(piece.x, piece.y));
            from += piece.solid.count;
        }
    }

  private:
    const BatchEncoder<Pixel>& encode_;
    const RowBand<Pixel>& image_;
    Pixel pixels_[value_batch];
};

/// The batch of texels of one thread; `Store` takes the planes of each batch.
template <class Store>
class PointQueue {
  public:
    PointQueue(const GraphValues& graph, const Filter& filter, const MaskReader& masks, Store store)
        : graph_(graph),
          masks_(masks),
          supersampled_(filter.kind == FilterKind::supersample),
          pattern_(supersampled_ ? filter.samples : 1),
          store_(std::move(store)),
          scratch_(graph.make_scratch()),
          sums_(supersampled_ ? graph.results().size() + 1 : 0),
          centres_(supersampled_ ? scratch_.masks.size() : 0) {}

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

    /// Evaluates the batch and stores its texels.
    void flush() {
        if (count_ == 0) return;
        scratch_.work.texels += count_;
        masks_.read(pieces_, scratch_);
        if (supersampled_)
            find_means();
        else
            find_values();
        store_(planes_, count_, pieces_);
        pieces_.clear();
        count_ = 0;
    }

    /// The work of the texels flushed.
    const SynthesisWork& work() const { return scratch_.work; }

  private:
    void run() {
        graph_.program().run(count_, scratch_);
        planes_.clear();
        for (const Register r : graph_.results()) planes_.push_back(scratch_[r]);
    }

    void find_values() {
        for (int axis = 0; axis < 3; ++axis) {
            lines_.clear();
            for (const auto& [x, y, solid, down, length] : pieces_)
                lines_.push_back(
                    {solid.start[axis], solid.step[axis], 0.0, solid.first, solid.count});
            fill_parabolas(lines_, scratch_[Register(axis)]);
        }
        run();
    }

    /// Sets the planes to the weighted means of all samples.
    void find_means() {
        const std::size_t planes = sums_.size() - 1;
        for (auto& sum : sums_) std::fill_n(sum.values, count_, 0.0);
        keep_masks();
        for (int i = 0; i < pattern_.samples(); ++i) {
            place_samples(i);
            run();
            for (std::size_t j = 0; j < count_; ++j) {
                for (std::size_t c = 0; c < planes; ++c)
                    sums_[c].values[j] += weights_[j] * planes_[c][j];
                sums_[planes].values[j] += weights_[j];
            }
        }
        for (std::size_t c = 0; c < planes; ++c) {
            for (std::size_t j = 0; j < count_; ++j) sums_[c].values[j] /= sums_[planes].values[j];
            planes_[c] = sums_[c].values;
        }
    }

    /// Keeps the masks at the texels' centres, from which those of samples are taken.
    void keep_masks() {
        for (std::vector<Dual>& one : centres_) one.clear();
        for (const Piece& piece : pieces_)
            for (std::size_t x = piece.x; x < piece.x + piece.solid.count; ++x)
                for (std::size_t m = 0; m < centres_.size(); ++m)
                    centres_[m].push_back(masks_.has(m) ? masks_(m, x, piece.y) : Dual());
    }

    void place_samples(int sample) {
        std::size_t at = 0;
        for (const auto& [x, y, solid, down, length] : pieces_)
            for (std::size_t j = 0; j < solid.count; ++j, ++at) {
                const auto [a, b] = pattern_(sample, std::uint32_t(x + j), std::uint32_t(y));
                const double u = double(a), v = double(b);
                const Vec3d p = solid.start + (solid.first + double(j) + u) * solid.step + v * down;
                for (int axis = 0; axis < 3; ++axis) scratch_[Register(axis)][at] = p[axis];
                for (std::size_t m = 0; m < centres_.size(); ++m)
                    scratch_.masks[m].values[at] =
                        moved(centres_[m][at], u * solid.step + v * down).value;
                weights_[at] = gaussian_weight(u, v);
            }
    }

    const GraphValues& graph_;
    const MaskReader& masks_;
    bool supersampled_;
    SamplePattern pattern_;
    Store store_;
    GraphValues::Scratch scratch_;
    std::vector<GraphValues::Scratch::Array> sums_;
    MaskValues centres_;  ///< masks at the batch's texels, where there are several samples
    std::vector<const double*> planes_;
    std::vector<Piece> pieces_;
    std::vector<ParabolaLine> lines_;
    std::size_t count_ = 0;
    double weights_[value_batch];
};

/// The number of texels of these rows that lie in no span.
inline std::uint64_t texels_outside(const SolidAtlas& solid, const RowWindow& rows) {
    std::uint64_t count = std::uint64_t(solid.size) * rows.count();
    for (std::size_t y = rows.first; y < rows.end; ++y)
        for (const Span& span : solid.row(y)) count -= span.count;
    return count;
}

/// The work of the texels of some rows by the evaluator; octaves are those of the value program of
/// the same graph.
inline SynthesisWork work_of(const SolidAtlas& solid, const RowWindow& rows,
                             const ValueProgram& program, const Filter& filter) {
    const std::uint64_t samples =
        filter.kind == FilterKind::supersample ? std::uint64_t(filter.samples) : 1;
    SynthesisWork work;
    const std::uint64_t outside = texels_outside(solid, rows);
    work.skip_texels(Skip::unread_texels, outside);
    work.texels = std::uint64_t(solid.size) * rows.count() - outside;
    work.octaves = work.texels * samples * program.octaves();
    return work;
}

/// Gives the rows' texels that lie in spans, as point samples of a value program and masks, to a
/// copy of `store` per thread; rows are filled in parallel.
template <class Store>
void fill_points(const SolidAtlas& solid, const Affine3& map, const GraphValues& graph,
                 const Filter& filter, int threads, const Economy& economy, const RowWindow& rows,
                 const MaskImages& masks, const Store& store) {
    WorkSum work(economy.work);
    RowGroups groups(solid.size, 16 * value_batch);
    groups.size = rows.count();
    const MaskReader reader(masks, map);
    const auto fill_rows = [&](const RowRange& range) {
        const auto queue = std::make_unique<PointQueue<Store>>(graph, filter, reader, store);
        for (std::size_t row = groups.begin(range.begin()); row != groups.begin(range.end());
             ++row) {
            const std::size_t y = rows.first + row;
            if (row % groups.rows == 0) queue->flush();
            economy.count(1, texels_of(solid.row(y)));
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

/// Fills the rows' texels that lie in spans by point samples of a value program's colour.
template <class Pixel>
void fill_points(const SolidAtlas& solid, const Affine3& map, const GraphValues& graph,
                 const Filter& filter, int threads, const Economy& economy,
                 const RowBand<Pixel>& image, const MaskImages& masks = {}) {
    const BatchEncoder<Pixel> encode;
    fill_points(solid, map, graph, filter, threads, economy, image.rows(), masks,
                ImageStore<Pixel>(encode, image));
}

}  // namespace burl
