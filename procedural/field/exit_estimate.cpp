#include "procedural/field/exit_estimate.h"

#include <algorithm>
#include <cmath>

#include "procedural/field/octave_groups.h"
#include "procedural/kernels/stream_kernels.h"
#include "procedural/noise/bounds.h"

namespace burl {

OctaveRange octave_range(const Octave& octave) {
    const NoiseBounds n = shaped(octave.shape, noise_bounds(octave.noise));
    const auto [low, high] = std::minmax({octave.scale * n.low, octave.scale * n.high});
    return {low, high, octave.scale * stream_unit(octave.noise.kind)};
}

std::vector<ExitPoint> allowed_exits(const ColorMap& colors, const std::vector<OctaveRange>& ranges,
                                     const Skips& skips) {
    if (ranges.empty()) return {};
    std::vector<ExitPoint> points = exit_points(constant_intervals(colors), ranges);
    if (!skips.allows(Skip::constant_tiles)) points.front().decided.clear();
    if (!skips.allows(Skip::early_exit))
        for (std::size_t k = 1; k < points.size(); ++k) points[k].decided.clear();
    const auto nowhere = [](const ExitPoint& point) { return point.decided.empty(); };
    if (std::ranges::all_of(points, nowhere)) points.clear();
    return points;
}

std::vector<double> likely_shares(const std::vector<ExitPoint>& points,
                                  const std::vector<OctaveRange>& ranges, double middle) {
    // A uniform number's deviation, in halves of its range; noise is nearer to its middle.
    constexpr double widest = 0.58;
    std::vector<double> shares;
    double variance = 0.0;
    for (const auto& [octaves, decided] : points) {
        const auto below = [&](double f) {
            if (variance == 0.0) return middle < f ? 1.0 : 0.0;
            return 0.5 * std::erfc((middle - f) / std::sqrt(2.0 * variance));
        };
        double share = 0.0;
        for (const auto& [begin, end] : decided) share += below(end) - below(begin);
        shares.push_back(share);
        const auto& [low, high, unit] = ranges[octaves];
        const double deviation = widest * 0.5 * (high - low);
        middle += 0.5 * (low + high);
        variance += deviation * deviation;
    }
    return shares;
}

bool may_exit(const Texture& texture, const Skips& skips, const ExitCosts& costs) {
    std::vector<Octave> octaves = expand_octaves(texture);
    const auto plain = std::ranges::stable_partition(octaves, has_kernel).begin();
    std::vector<OctaveRange> ranges;
    double middle = texture.quadric.j;
    for (const Octave& octave : octaves) {
        ranges.push_back(octave_range(octave));
        middle += octave.offset;
    }
    const std::vector<ExitPoint> points = allowed_exits(texture.colors, ranges, skips);
    Quadric flat;
    flat.j = texture.quadric.j;
    const bool known = texture.quadric == flat && texture.colors.wrap == Wrap::clamp;
    if (points.empty() || !known) return !points.empty();
    std::vector<double> costs_of(std::size_t(plain - octaves.begin()), 1.0);
    costs_of.resize(octaves.size(), plain_octave_cost);
    return !cheapest_exits(likely_shares(points, ranges, middle), costs_of, costs).empty();
}

}  // namespace burl
