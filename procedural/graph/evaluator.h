#pragma once
// Evaluates a texture graph in batches: node after node, each over the arrays of all points, with
// forward-mode derivatives. All of it in float64, which is the reference, or with sums of noise by
// the vectorised kernels in float32; a point's result does not depend on what else is in its batch.
#include <memory>
#include <span>
#include <vector>

#include "procedural/graph/batch.h"

namespace burl {

/// Value and gradient with respect to the solid point: of a number one channel, of a colour red,
/// green, blue (linear light, multiplied by alpha) and alpha.
struct GraphSample {
    std::array<Dual, 4> channels;
    Wire wire = Wire::number;

    /// Linear light over black; a number is a grey.
    Vec3d color() const {
        if (wire == Wire::number) return Vec3d(channels[0].value);
        return {channels[0].value, channels[1].value, channels[2].value};
    }
};

class GraphEvaluator {
  public:
    /// The arrays of one thread; any number of batches.
    using Scratch = std::vector<Channel>;

    /// The graph must be valid (graph_from_json makes only such) and not empty. `filter` decides
    /// how color_map and field average over footprints (docs/reference/nodes.md). `precision` is
    /// that of sums of noise, float64 or float32.
    explicit GraphEvaluator(const TextureGraph& graph,
                            const Filter& filter = {FilterKind::trapezoid},
                            PrecisionKind precision = PrecisionKind::float64);

    Scratch make_scratch() const { return Scratch(channel_count_); }
    const TextureGraph& graph() const { return graph_; }

    /// samples[i] = the result at points[i] for footprints[i], or for point samples where no
    /// footprints are given. Any number of points.
    void operator()(std::span<const Vec3d> points, std::span<const Footprint> footprints,
                    Scratch& scratch, std::span<GraphSample> samples) const;

    /// One point.
    GraphSample operator()(const Vec3d& point, const Footprint& footprint = {}) const;

  private:
    void evaluate_batch(std::span<const Footprint> footprints, Scratch& scratch) const;
    std::span<Channel> channels(Scratch& scratch, std::size_t node) const;

    TextureGraph graph_;
    bool float32_;
    std::vector<PreparedNode> prepared_;
    std::vector<std::size_t> first_channel_;
    std::size_t channel_count_ = 0;
};

}  // namespace burl
