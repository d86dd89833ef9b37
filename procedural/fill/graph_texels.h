#pragma once
// Texels of an atlas through a graph's evaluator, in batches, each as one sample or several by the
// filter (docs/reference/nodes.md): the common part of baking colours and baking normals.
#include <utility>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/filter.h"
#include "procedural/batch/row_tasks.h"
#include "procedural/batch/row_window.h"
#include "procedural/batch/sample_pattern.h"
#include "procedural/batch/texel_batch.h"
#include "procedural/fill/mask_images.h"
#include "procedural/fill/pieces.h"
#include "procedural/graph/evaluator.h"

namespace burl {

/// The batch of texels of one thread. `shade(texel, u, v, sample)` makes a vector of the graph's
/// sample at (u, v) texels from the texel's centre; `encode` makes the pixel of the samples'
/// weighted mean.
template <class Pixel, class Shade, class Encode>
class TexelQueue {
  public:
    TexelQueue(const GraphEvaluator& evaluate, const Filter& filter, const Shade& shade,
               const Encode& encode, const RowBand<Pixel>& image, const MaskReader& masks)
        : evaluate_(evaluate),
          kind_(filter.kind),
          pattern_(kind_ == FilterKind::supersample ? filter.samples : 1),
          shade_(shade),
          encode_(encode),
          image_(image),
          masks_(masks),
          scratch_(evaluate.make_scratch()) {}

    void add(const TexelPlace& texel) {
        texels_.push_back(texel);
        for (int i = 0; i < pattern_.samples(); ++i) {
            const auto [u, v] = offset(i, texel);
            points_.push_back(texel.point + double(u) * texel.steps.u + double(v) * texel.steps.v);
            masks_.append(texel.x, texel.y, double(u) * texel.steps.u + double(v) * texel.steps.v,
                          scratch_.masks);
            footprints_.push_back(point_samples() ? Footprint{} : texel.steps);
        }
        if (points_.size() >= graph_batch_size) flush();
    }

    /// Evaluates the batch and stores its pixels.
    void flush() {
        samples_.resize(points_.size());
        evaluate_(points_, footprints_, scratch_, samples_);
        const auto* sample = samples_.data();
        for (const TexelPlace& texel : texels_) {
            Vec3d sum(0.0);
            double weights = 0.0;
            for (int i = 0; i < pattern_.samples(); ++i) {
                const auto [u, v] = offset(i, texel);
                // A sample that is alone keeps its bits.
                const double weight =
                    kind_ == FilterKind::supersample ? gaussian_weight(double(u), double(v)) : 1.0;
                sum += weight * shade_(texel, double(u), double(v), *sample++);
                weights += weight;
            }
            image_(texel.x, texel.y) = encode_(sum / weights);
        }
        texels_.clear();
        points_.clear();
        footprints_.clear();
        clear_masks(scratch_.masks);
    }

  private:
    bool point_samples() const {
        return kind_ == FilterKind::none || kind_ == FilterKind::supersample;
    }
    std::pair<float, float> offset(int i, const TexelPlace& texel) const {
        if (kind_ != FilterKind::supersample) return {0.0f, 0.0f};
        return pattern_(i, texel.x, texel.y);
    }

    const GraphEvaluator& evaluate_;
    FilterKind kind_;
    SamplePattern pattern_;
    const Shade& shade_;
    const Encode& encode_;
    const RowBand<Pixel>& image_;
    const MaskReader& masks_;
    GraphEvaluator::Scratch scratch_;
    std::vector<TexelPlace> texels_;
    std::vector<Vec3d> points_;
    std::vector<Footprint> footprints_;
    std::vector<GraphSample> samples_;
};

/// Fills the rows' texels that lie in spans, rows in parallel; the bytes do not depend on `threads`
/// (0: all). `map` takes the SolidAtlas's space to the texture's.
template <class Pixel, class Shade, class Encode>
void fill_texels(const SolidAtlas& solid, const Affine3& map, const GraphEvaluator& evaluate,
                 const Filter& filter, const Shade& shade, const Encode& encode, int threads,
                 const RowBand<Pixel>& image, const Economy& economy = {},
                 const MaskImages& masks = {}) {
    const MaskReader reader(masks, map);
    const auto fill_rows = [&](const RowRange& rows) {
        TexelQueue<Pixel, Shade, Encode> queue(evaluate, filter, shade, encode, image, reader);
        for (std::size_t y = image.first + rows.begin(); y != image.first + rows.end(); ++y) {
            for (const Span& span : solid.row(y)) {
                const TexelMap& texel = solid.maps[span.map];
                const Footprint steps{map.linear * texel.step_x, map.linear * texel.step_y};
                for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                    queue.add(
                        {x, std::uint32_t(y), span.map, map(texel(x, std::int64_t(y))), steps});
            }
            economy.count(1, texels_of(solid.row(y)));
        }
        queue.flush();
    };
    for_window_ranges(solid.size, image.rows().count(), 16 * graph_batch_size, threads, fill_rows,
                      economy.stop);
}

}  // namespace burl
