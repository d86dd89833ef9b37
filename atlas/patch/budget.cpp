#include "atlas/patch/budget.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace burl {
namespace {

constexpr double most_aspect = 16.0;
constexpr int most_budget_halvings =
    40;  ///< bisections of the interval that holds the common factor

/// A patch's inner texels in some unit, and the root of their width over height.
struct Inner {
    double texels = 0.0, root_aspect = 1.0;
};

/// Texels of a block's side that has so many inner steps; the gutter is at most a quarter of the
/// side.
double side(double steps, double gutter) {
    return std::min(steps + 1.0 + 2.0 * gutter, 2.0 * (steps + 1.0));
}

double block(const Inner& inner, double factor, double gutter) {
    const double steps = std::sqrt(factor * inner.texels), cell = gutter > 0.0 ? 2.0 * gutter : 2.0;
    return std::max(side(steps * inner.root_aspect, gutter), cell) *
           std::max(side(steps / inner.root_aspect, gutter), cell);
}

}  // namespace

double texel_demand(const PatchDemand& patch) {
    const Stretch& s = patch.stretch;
    if (!(s.area > 0.0)) return 0.0;
    return std::cbrt(std::sqrt(s.x / s.area) * std::sqrt(s.y / s.area) * std::sqrt(s.x) *
                     std::sqrt(s.y));
}

std::vector<double> block_texels(std::span<const PatchDemand> patches, std::uint32_t size,
                                 std::uint32_t gutter) {
    std::vector<Inner> inner;
    double all = 0.0;
    for (const PatchDemand& patch : patches) {
        const double texels = texel_demand(patch), aspect = patch.stretch.best_aspect();
        const bool usable = texels > 0.0 && aspect > 0.0 && std::isfinite(aspect);
        inner.push_back(
            {texels, usable ? std::sqrt(std::clamp(aspect, 1.0 / most_aspect, most_aspect)) : 1.0});
        all += texels;
    }
    const double square = double(size) * size;
    const auto sum = [&](double factor) {
        return std::accumulate(inner.begin(), inner.end(), 0.0, [&](double total, const Inner& i) {
            return total + block(i, factor, gutter);
        });
    };
    double low = 0.0, high = all > 0.0 ? square / all : 0.0;
    for (int i = 0; i < most_budget_halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (sum(middle) > square ? high : low) = middle;
    }
    std::vector<double> result;
    for (const Inner& i : inner) result.push_back(block(i, low, gutter));
    return result;
}

}  // namespace burl
