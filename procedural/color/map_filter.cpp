// Narrow footprints: the piece at the low end is extended as a straight line, whose mean is its
// value in the middle, and every break inside adds a smoothed step and a smoothed ramp, so that
// nothing cancels. Broad footprints: differences of the map's antiderivatives, whatever the number
// of breaks.
#include "procedural/color/map_filter.h"

#include <algorithm>
#include <cmath>

namespace burl {

namespace {

/// The width, wide + narrow, below which a footprint is summed break by break.
constexpr double narrow_support = 0x1p-6;
/// The ratio narrow / wide below which a footprint is summed break by break up to a support of 2.
/// Beyond a support of 2, a ratio below least_ratio^2 counts as 0, for an error of 1e-7 of a jump.
constexpr double least_ratio = 1e-3;

/// The means over a footprint of the unit step at 0 and of the ramp max(x, 0).
struct Smoothed {
    double step = 0.0, ramp = 0.0;
};

/// The means for x in [-sum/2, 0], sum = wide + narrow, both exact to rounding however unequal the
/// widths are.
Smoothed smoothed_below(double x, const FilterWidths& w) {
    const double sum = 0.5 * (w.wide + w.narrow), difference = 0.5 * (w.wide - w.narrow);
    if (x <= -sum) return {};
    if (x < -difference) {
        const double reach = x + sum;
        const double step = reach * reach / (2.0 * w.wide * w.narrow);
        return {step, step * reach / 3.0};
    }
    return {0.5 + x / w.wide,
            (w.wide + w.narrow * (w.narrow / w.wide) / 3.0) / 8.0 + x * (0.5 + x / (2.0 * w.wide))};
}

Smoothed smoothed(double x, const FilterWidths& widths) {
    if (x <= 0.0) return smoothed_below(x, widths);
    const Smoothed mirrored = smoothed_below(-x, widths);
    return {1.0 - mirrored.step, x + mirrored.ramp};
}

/// The mean over a footprint with breaks inside: the line at its low end plus the breaks' shares.
/// The breaks to the right of the low end are found by the very number that chose the piece.
Vec3d sum_over_breaks(const MapPieces& map, double t, const FilterWidths& widths) {
    const double half = 0.5 * (widths.wide + widths.narrow), low = t - half;
    const bool repeat = map.wrap() == Wrap::repeat;
    double first = repeat ? std::floor(low) : 0.0;
    if (repeat && low - first >= 1.0) first += 1.0;  // -1e-20 - floor(-1e-20) rounds to 1
    const double last = repeat ? std::floor(t + half) : 0.0;
    Vec3d result = map.extended(low, t);
    for (double period = first; period <= last; period += 1.0)
        for (const MapBreak& b : map.breaks()) {
            if (period == first && b.position <= std::max(low - first, repeat ? 0.0 : low))
                continue;
            const Smoothed s = smoothed(t - (b.position + period), widths);
            result += s.step * b.jump + s.ramp * b.kink;
        }
    return result;
}

/// Whether to sum break by break, which is where differences of antiderivatives would cancel.
bool break_by_break(const FilterWidths& w) {
    const double support = w.wide + w.narrow;
    return support < narrow_support || (w.narrow < least_ratio * w.wide && support < 2.0);
}

/// f and widths in the range of the formulas: with `repeat` f less whole periods, so that adding
/// half a width rounds nothing off it; with `clamp` no wider than 2^40, which is as good as
/// infinite.
struct ReducedFootprint {
    double f = 0.0;
    FilterWidths widths;
};

ReducedFootprint reduced(const MapPieces& map, double f, const FilterWidths& widths) {
    if (map.wrap() == Wrap::repeat) return {f - std::floor(f), widths};
    const double scale = std::min(1.0, 0x1p40 / widths.wide);
    return {f * scale, {widths.wide * scale, widths.narrow * scale}};
}

/// Whether a footprint lies in one of the constant ends of a `clamp` map.
bool beyond_ends(const MapPieces& map, const ReducedFootprint& at) {
    const double half = 0.5 * (at.widths.wide + at.widths.narrow);
    return map.wrap() == Wrap::clamp && (at.f - half >= 1.0 || at.f + half <= 0.0);
}

Vec3d box_of(const MapPieces& map, double t, double width) {
    return map.mean() + (map.first(t + 0.5 * width) - map.first(t - 0.5 * width)) / width;
}

}  // namespace

FilterWidths FilterWidths::of(double along_u, double along_v) {
    const double u = std::abs(along_u), v = std::abs(along_v);
    return {std::max(u, v), std::min(u, v)};
}

double FilterWidths::box() const {
    return wide > 0.0 ? wide * std::sqrt(1.0 + (narrow / wide) * (narrow / wide)) : 0.0;
}

Vec3d box_filtered(const MapPieces& map, double f, double width) {
    return trapezoid_filtered(map, f, {width, 0.0});
}

Vec3d trapezoid_filtered(const MapPieces& map, double f, const FilterWidths& widths) {
    if (!std::isfinite(f) || !std::isfinite(widths.wide)) return map.extended(0.0, 0.0);
    const ReducedFootprint at = reduced(map, f, widths);
    const auto [wide, narrow] = at.widths;
    if (beyond_ends(map, at)) return map.extended(at.f, at.f);
    if (break_by_break(at.widths)) return sum_over_breaks(map, at.f, at.widths);
    if (narrow < least_ratio * wide * least_ratio) return box_of(map, at.f, wide);
    const double sum = 0.5 * (wide + narrow), difference = 0.5 * (wide - narrow);
    const Vec3d outer = map.second(at.f + sum) + map.second(at.f - sum);
    const Vec3d inner = map.second(at.f + difference) + map.second(at.f - difference);
    return map.mean() + (outer - inner) / wide / narrow;
}

}  // namespace burl
