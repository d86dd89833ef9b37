// The field where only its colour counts: early exits (early_exit.h).
#include <algorithm>

#include "procedural/field/exit_estimate.h"
#include "procedural/field/exit_kernel.h"
#include "procedural/field/sampler.h"

namespace burl {

/// In the order of noise_keys().
std::vector<OctaveRange> FieldSampler::octave_ranges() const {
    std::vector<OctaveRange> ranges;
    for (const Octave& octave : streamed_octaves_) ranges.push_back(octave_range(octave));
    for (const ScalarOctave& scalar : scalar_octaves_)
        ranges.push_back(octave_range(scalar.octave));
    return ranges;
}

/// Of the pilot's blocks, after 0 octaves and more, as many as kernels know.
std::vector<double> FieldSampler::decided_shares(const std::vector<ExitPoint>& points,
                                                 FieldBatch& pilot) const {
    ExitBuffers::Noise noise;
    std::vector<std::uint32_t> positions(batch_capacity + 2 * batch_padding);
    std::vector<double> shares;
    fill_quadric(pilot);
    for (std::size_t k = 0; k < points.size() && k <= streamed_octaves_.size(); ++k) {
        if (k > 0) {
            const std::vector<float*> arrays(k, noise.values);
            const Octave& octave = streamed_octaves_[k - 1];
            streams_.fill_noise(k - 1, k, pilot.pieces, pilot.streams, arrays);
            add_sums(octave.scale * stream_unit(octave.noise.kind), noise.values, pilot.count,
                     pilot.field);
        }
        const std::size_t undecided = find_undecided(exit_.repeats, points[k].decided, pilot.field,
                                                     pilot.count, positions.data());
        OpenBlocks open;
        open.open(pilot.count);
        const std::size_t closed =
            open.close({positions.data(), undecided}, [](std::size_t, std::size_t, std::size_t) {});
        shares.push_back(double(closed) / double(pilot.count));
    }
    return shares;
}

void FieldSampler::plan_exit(const ColorMap& colors, FieldBatch& pilot, const ExitCosts& costs) {
    const std::vector<OctaveRange> ranges = octave_ranges();
    exit_ = {};
    const std::vector<ExitPoint> points = allowed_exits(colors, ranges, skips_);
    if (band_limit_ || points.empty() || pilot.count == 0) return;
    exit_.repeats = colors.wrap == Wrap::repeat;
    exit_.octaves = ranges.size();
    const std::vector<double> shares = decided_shares(points, pilot);
    std::vector<double> octaves = streams_.octave_costs(pilot.pieces, pilot.count, pilot.streams);
    octaves.resize(ranges.size(), plain_octave_cost);
    for (const std::size_t k : cheapest_exits(shares, octaves, costs))
        if (!points[k].decided.empty()) exit_.points.push_back(points[k]);
}

void FieldSampler::values_for_colors(FieldBatch& batch, ExitBuffers& buffers) const {
    if (exit_.points.empty()) return values(batch);
    fill_quadric(batch);
    streams_.add_open(exit_, batch.pieces, batch.count, batch.streams, buffers, batch.field);
    add_scalar_octaves(batch, nullptr, nullptr, &buffers.open);
}

}  // namespace burl
