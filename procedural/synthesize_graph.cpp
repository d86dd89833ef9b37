#include "procedural/synthesize_graph.h"

#include <algorithm>
#include <utility>

#include "procedural/graph_evaluator.h"
#include "procedural/pixel_encoder.h"
#include "procedural/row_tasks.h"
#include "procedural/sample_pattern.h"

namespace burl {

namespace {

/// A texel's point and its steps to the next column and row, in texture coordinates.
struct TexelPlace {
    std::uint32_t x = 0, y = 0;
    Vec3d point{0.0};
    Footprint steps;
};

/// Texels of one thread on their way through the evaluator, each as one sample or several.
template <class Pixel>
class TexelQueue {
  public:
    TexelQueue(const GraphEvaluator& evaluate, const Filter& filter,
               const PixelEncoder<Pixel>& encode, Image<Pixel>& image)
        : evaluate_(evaluate),
          kind_(filter.kind),
          pattern_(kind_ == FilterKind::supersample ? filter.samples : 1),
          encode_(encode),
          image_(image),
          scratch_(evaluate.make_scratch()) {}

    void add(const TexelPlace& texel) {
        texels_.push_back(texel);
        for (int i = 0; i < pattern_.samples(); ++i) {
            const auto [u, v] = offset(i, texel);
            points_.push_back(texel.point + double(u) * texel.steps.u + double(v) * texel.steps.v);
            footprints_.push_back(point_samples() ? Footprint{} : texel.steps);
        }
        if (points_.size() >= graph_batch_size) flush();
    }

    void flush() {
        samples_.resize(points_.size());
        evaluate_(points_, footprints_, scratch_, samples_);
        const auto* sample = samples_.data();
        for (const TexelPlace& texel : texels_) {
            Vec3d sum(0.0);
            double weights = 0.0;
            for (int i = 0; i < pattern_.samples(); ++i) {
                const auto [u, v] = offset(i, texel);
                const double weight = gaussian_weight(double(u), double(v));
                sum += weight * (sample++)->color();
                weights += weight;
            }
            image_(texel.x, texel.y) = encode_(sum / weights);
        }
        texels_.clear();
        points_.clear();
        footprints_.clear();
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
    const PixelEncoder<Pixel>& encode_;
    Image<Pixel>& image_;
    GraphEvaluator::Scratch scratch_;
    std::vector<TexelPlace> texels_;
    std::vector<Vec3d> points_;
    std::vector<Footprint> footprints_;
    std::vector<GraphSample> samples_;
};

template <class Pixel>
void synthesize_rows(const SolidAtlas& solid, const Affine3& map, const RowRange& rows,
                     TexelQueue<Pixel> queue) {
    for (std::size_t y = rows.begin(); y != rows.end(); ++y)
        for (const Span& span : solid.row(y)) {
            const TexelMap& texel = solid.maps[span.map];
            const Footprint steps{map.linear * texel.step_x, map.linear * texel.step_y};
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                queue.add({x, std::uint32_t(y), map(texel(x, std::int64_t(y))), steps});
        }
    queue.flush();
}

template <class Pixel>
Image<Pixel> synthesize(const SolidAtlas& solid, const TextureGraph& graph, const Affine3& map,
                        const Filter& filter, int threads) {
    const PixelEncoder<Pixel> encode{};
    const GraphEvaluator evaluate(graph, filter);
    Image<Pixel> image(solid.size, solid.size, encode(evaluate(Vec3d(0.0)).color()));
    for_row_ranges(solid.size, 16 * graph_batch_size, threads, [&](const RowRange& rows) {
        synthesize_rows(solid, map, rows, TexelQueue<Pixel>(evaluate, filter, encode, image));
    });
    return image;
}

}  // namespace

Image<Rgb8> synthesize_graph_rgb8(const SolidAtlas& solid, const TextureGraph& graph,
                                  const Affine3& map, const Filter& filter, int threads) {
    return synthesize<Rgb8>(solid, graph, map, filter, threads);
}

Image<Rgb16> synthesize_graph_rgb16(const SolidAtlas& solid, const TextureGraph& graph,
                                    const Affine3& map, const Filter& filter, int threads) {
    return synthesize<Rgb16>(solid, graph, map, filter, threads);
}

Image<RgbF> synthesize_graph_rgbf(const SolidAtlas& solid, const TextureGraph& graph,
                                  const Affine3& map, const Filter& filter, int threads) {
    return synthesize<RgbF>(solid, graph, map, filter, threads);
}

}  // namespace burl
