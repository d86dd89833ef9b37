#include "procedural/field/early_exit.h"

#include <cmath>
#include <numeric>

namespace burl {

std::vector<ExitPoint> exit_points(const std::vector<IndexInterval>& intervals,
                                   const std::vector<OctaveRange>& ranges) {
    double amplitudes = 0.0;
    for (const auto& [low, high, unit] : ranges)
        amplitudes += std::max(std::abs(low), std::abs(high));
    double below = -1e-6 - 1e-5 * amplitudes, above = -below;
    std::vector<ExitPoint> points;
    for (std::size_t k = ranges.size(); k-- > 0;) {
        below += ranges[k].low, above += ranges[k].high;
        ExitPoint& point = points.emplace_back(ExitPoint{k, {}});
        for (const auto& [begin, end] : intervals)
            if (begin - below < end - above) point.decided.push_back({begin - below, end - above});
    }
    std::ranges::reverse(points);
    return points;
}

std::vector<std::size_t> cheapest_exits(const std::vector<double>& decided,
                                        const std::vector<double>& octaves,
                                        const ExitCosts& costs) {
    const auto cost_of = [&](std::size_t begin, std::size_t end, double more) {
        double sum = 0.0;
        for (std::size_t k = begin; k < end; ++k) sum += octaves[k] + more;
        return sum;
    };
    // cost[k]: of a texel's octaves once texels were looked at after k of them; next[k]: where the
    // next look is.
    std::vector<double> cost(decided.size());
    std::vector<std::size_t> next(decided.size());
    const auto plan = [&](double share, std::size_t known, std::size_t from, std::size_t& look) {
        look = octaves.size();
        double best = share * cost_of(known, octaves.size(), 0.0);
        for (std::size_t k = from; k < decided.size(); ++k) {
            const double all =
                share * (cost_of(known, k, costs.octave_kept) + costs.test) + cost[k];
            if (all < best) best = all, look = k;
        }
        return best;
    };
    for (std::size_t k = decided.size(); k-- > 0;)
        cost[k] = plan(1.0 - decided[k], k, k + 1, next[k]);
    std::vector<std::size_t> points;
    std::size_t first = octaves.size();
    if (plan(1.0, 0, 0, first) > 0.8 * cost_of(0, octaves.size(), 0.0)) return points;
    for (std::size_t k = first; k < octaves.size(); k = next[k]) points.push_back(k);
    return points;
}

void OpenBlocks::open(std::size_t count) {
    count_ = texels_ = count;
    where_.resize((count + batch_padding - 1) / batch_padding);
    std::iota(where_.begin(), where_.end(), 0u);
    std::fill_n(open_, where_.size(), true);
}

void OpenBlocks::scatter(const double* values, double* batch) const {
    for (std::size_t i = 0; i < where_.size(); ++i)
        std::copy_n(values + i * batch_padding, texels_of(where_[i]),
                    batch + where_[i] * batch_padding);
}

}  // namespace burl
