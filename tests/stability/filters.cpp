// The errors of filtered colours against the definition of the closed forms
// (docs/reference/filtering.md), computed in long double.
#include "tests/stability/checks.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "procedural/color/srgb.h"
#include "procedural/fill/synthesize.h"
#include "procedural/fill/texels.h"
#include "tests/stability/cases.h"
#include "tests/stability/truth.h"
#include "tests/stability/ways.h"

namespace burl {

namespace {

using Real = long double;

/// The density of u U + v V at a distance x from its centre; u >= v >= 0, u > 0.
Real trapezoid_density(Real x, Real u, Real v) {
    const Real outside = 0.5L * (u + v) - std::abs(x);
    return outside <= 0.0L ? 0.0L : std::min(outside / v, 1.0L) / u;
}

/// Returns the points from low to high, inclusive, where the slope of map or density changes.
std::vector<Real> bends(const ColorMap& map, Real f, Real u, Real v) {
    const Real low = f - 0.5L * (u + v), high = f + 0.5L * (u + v);
    std::vector<Real> at{low, high, f - 0.5L * (u - v), f + 0.5L * (u - v), f};
    const bool repeat = map.wrap == Wrap::repeat;
    for (Real period = repeat ? std::floor(low) : 0.0L; period <= (repeat ? high : 0.0L);
         period += 1.0L)
        for (const ColorStop& stop : map.stops) at.push_back(period + Real(stop.position));
    std::erase_if(at, [&](Real x) { return x < low || x > high; });
    std::ranges::sort(at);
    return at;
}

/// Returns the steepest slope of a map's linear pieces, in linear light per unit of index.
double steepest(const ColorMap& map) {
    double slope = 0.0;
    for (std::size_t i = 1; i < map.stops.size(); ++i) {
        const Vec3d step = linear_light(map.stops[i].color) - linear_light(map.stops[i - 1].color);
        const double width = map.stops[i].position - map.stops[i - 1].position;
        for (int c = 0; c < 3; ++c) slope = std::max(slope, std::abs(step[c]) / width);
    }
    return slope;
}

/// The mean of f over a texel and the changes of f along the texel's sides, with their error
/// bounds.
struct Spread {
    Real f = 0.0L, u = 0.0L, v = 0.0L;
    double f_error = 0.0, slope_error = 0.0;
};

LongPoint moved(const LongPoint& s, const Vec3d& u, Real along_u, const Vec3d& v, Real along_v) {
    LongPoint result;
    for (int axis = 0; axis < 3; ++axis)
        result[std::size_t(axis)] =
            s[std::size_t(axis)] + along_u * Real(u[axis]) + along_v * Real(v[axis]);
    return result;
}

struct Texel {
    LongPoint point;
    Vec3d u, v;  ///< sides of the texel
};

/// Returns the sum of |a_k| times the change of octave k's lattice coordinates along the sides, in
/// cells.
double cells_across(const StabilityTruth& truth, const Texel& texel) {
    double sum = 0.0;
    for (const Octave& octave : truth.octaves())
        for (const Vec3d& side : {texel.u, texel.v}) {
            const Vec3d cells = octave.lattice_from_solid.linear * side;
            sum += std::abs(octave.scale) *
                   (std::abs(cells.x) + std::abs(cells.y) + std::abs(cells.z));
        }
    return sum;
}

/// Returns the spread from f and its gradient at the centre. In float32 the noises' slopes err by
/// 3e-6, and by up to 60 times the error of their coordinates.
Spread central_spread(const StabilityTruth& truth, const Texel& texel, const SpanSizes& sizes,
                      bool float32) {
    const LongNoise f = truth.sample(texel.point);
    Spread spread{f.value};
    for (int axis = 0; axis < 3; ++axis) {
        spread.u += f.gradient[std::size_t(axis)] * Real(texel.u[axis]);
        spread.v += f.gradient[std::size_t(axis)] * Real(texel.v[axis]);
    }
    const double sides = double(std::abs(spread.u) + std::abs(spread.v));
    const double coordinate = 4.0 * 0x1p-52 * sizes.lattice;
    spread.f_error =
        (float32 ? 2.5e-7 : 8.0 * 0x1p-52) * truth.amplitudes() + truth.rounding(sizes);
    spread.slope_error = cells_across(truth, texel) * ((float32 ? 3e-6 : 1e-14) + 60 * coordinate) +
                         (float32 ? 6e-8 : 1e-15) * sides + 8.0 * 0x1p-52 * sizes.quadric;
    return spread;
}

/// Returns the spread from f at the centre and the corners (corner_samples.h).
Spread corner_spread(const StabilityTruth& truth, const Texel& texel, const SpanSizes& sizes,
                     bool float32) {
    Spread spread = central_spread(truth, texel, sizes, float32);
    Real corners[4];
    for (int i = 0; i < 4; ++i)
        corners[i] = truth.field(
            moved(texel.point, texel.u, i % 2 == 0 ? -0.5L : 0.5L, texel.v, i < 2 ? -0.5L : 0.5L));
    const auto& [a, b, c, d] = corners;
    spread.f += ((a - spread.f) + (b - spread.f) + (c - spread.f) + (d - spread.f)) / 12.0L;
    spread.u = 0.5L * ((b - a) + (d - c));
    spread.v = 0.5L * ((c - a) + (d - b));
    spread.f_error *= 2.0;
    spread.slope_error = spread.f_error + 6e-8 * double(std::abs(spread.u) + std::abs(spread.v));
    return spread;
}

Vec3d defined_color(const ColorMap& map, FilterKind kind, const Spread& spread) {
    if (kind == FilterKind::none) return long_color(map, spread.f);
    if (kind == FilterKind::exact)
        return long_mean(map, spread.f, std::hypot(spread.u, spread.v), 0.0L);
    return long_mean(map, spread.f, spread.u, spread.v);
}

Image<RgbF> filtered(const StabilityCase& one, FilterKind kind, PrecisionKind precision) {
    if (precision == PrecisionKind::float32)
        return synthesize_model<RgbF>(one.solid, one.texture, one.map, 1, {kind, 16, false});
    return synthesize_texels<RgbF>(one.solid, one.texture, one.map, {precision, {}},
                                   {kind, 16, false}, 1);
}

/// Returns the errors of a case's texels under the filter `none`, `exact`, `trapezoid` or
/// `trapezoid2`. The map must be continuous.
StabilityRow filter_errors(const StabilityCase& one, FilterKind kind, PrecisionKind precision) {
    StabilityRow row;
    row.cases = 1;
    const StabilityTruth truth(one.texture, one.map);
    const Image<RgbF> colors = filtered(one, kind, precision);
    const double slope = steepest(one.texture.colors);
    const bool float32 = precision == PrecisionKind::float32;
    for_each_span(one.solid, [&](const Span& span, const TexelMap& map, std::int64_t y) {
        const SpanSizes sizes = truth.sizes(span, map, y);
        for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
            const Texel texel{truth.point(map, x, y), one.map.linear * map.step_x,
                              one.map.linear * map.step_y};
            const Spread spread = kind == FilterKind::trapezoid2
                                      ? corner_spread(truth, texel, sizes, float32)
                                      : central_spread(truth, texel, sizes, float32);
            const Vec3d exact = defined_color(one.texture.colors, kind, spread);
            const RgbF got = colors(x, std::size_t(y));
            const double error =
                std::max({std::abs(double(got.r) - exact.x), std::abs(double(got.g) - exact.y),
                          std::abs(double(got.b) - exact.z)});
            const double allowed = slope * (spread.f_error + spread.slope_error) + 3e-7;
            row.note(error, allowed, [&] {
                return fmt::format("{}, --filter {}, texel ({}, {}): red {:.9g} for {:.9g}",
                                   one.input, to_string(kind), x, y, got.r, exact.x);
            });
        }
    });
    return row;
}

}  // namespace

Vec3d long_mean(const ColorMap& map, long double f, long double u, long double v) {
    u = std::abs(u), v = std::abs(v);
    if (u < v) std::swap(u, v);
    if (f + u == f) return long_color(map, f);
    v = std::max(v, 1e-12L * u);  // a box is a trapezoid with steep sides
    const std::vector<Real> at = bends(map, f, u, v);
    std::array<Real, 3> sum{};
    Real weight = 0.0L;
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        const Real width = at[i + 1] - at[i];
        if (width <= 0.0L) continue;
        // Gauss's rule with two points is exact for a product of two linear functions.
        for (const Real side : {-1.0L, 1.0L}) {
            const Real x = 0.5L * (at[i] + at[i + 1]) + side * width / std::sqrt(12.0L);
            const Real share = 0.5L * width * trapezoid_density(x - f, u, v);
            const Vec3d color = long_color(map, x);
            for (std::size_t c = 0; c < 3; ++c) sum[c] += share * Real(color[int(c)]);
            weight += share;
        }
    }
    return {double(sum[0] / weight), double(sum[1] / weight), double(sum[2] / weight)};
}

std::vector<StabilityRow> check_filter_errors(const std::vector<StabilityGroup>& groups,
                                              StabilityChoice choice) {
    using enum FilterKind;
    std::vector<StabilityRow> rows;
    const StabilityGroup filters = filter_group(choice);
    const auto add = [&](const StabilityGroup& group, FilterKind kind, PrecisionKind precision) {
        std::vector<StabilityRow> each(group.cases.size());
        tbb::parallel_for(std::size_t(0), each.size(), [&](std::size_t i) {
            each[i] = filter_errors(group.cases[i], kind, precision);
        });
        StabilityRow all;
        all.group = fmt::format("{}: {}", group.name, to_string(kind));
        all.cases = each.size();
        all.arithmetic = to_string(precision);
        for (std::size_t i = 0; i < each.size(); ++i)
            all.merge(each[i], fmt::format("{}/{}", group.name, i));
        rows.push_back(std::move(all));
    };
    for (const PrecisionKind precision : {PrecisionKind::float32, PrecisionKind::float64}) {
        for (const FilterKind kind : {none, exact, trapezoid, trapezoid2})
            add(filters, kind, precision);
        for (const StabilityGroup& group : groups)
            if (group.name == "quadrics") add(group, none, precision);
    }
    return rows;
}

/// The texels' footprints are equally large in all directions, or 1000 times longer than wide.
StabilityGroup filter_group(StabilityChoice choice) {
    StabilityGroup group{"filters", {}};
    const bool few = choice == StabilityChoice::thinned;
    for (const NamedTerm& noise : named_terms())
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
            for (const double step : {1e-6, 1e-3, 1.0 / 64, 1.0 / 8, 1.0, 30.0})
                for (const double ratio : {1.0, 1e-3}) {
                    const NoiseSpec spec{.kind = noise.term.kind, .radius2 = noise.term.radius2};
                    if (has_jumps(spec)) continue;
                    if (few && (!has_long_form(spec) || ratio < 1.0 || step > 1.0)) continue;
                    Chance chance(std::uint32_t(group.cases.size()));
                    NoiseTerm term = noise.term;
                    term.octaves = 1 + chance.bits() % 4;
                    Texture texture = texture_of(term);
                    texture.colors.wrap = wrap;
                    const double place = chance.pick(std::array{0.3, -17.3, 1e3 + 0.7});
                    texture.quadric.a = chance.signed_unit() / place, texture.quadric.g = 0.5;
                    SolidAtlas solid = random_lines(Vec3d(place), step, few ? 8 : 24, 4,
                                                    std::uint32_t(group.cases.size()));
                    for (TexelMap& map : solid.maps) map.step_y = ratio * step * chance.vector();
                    group.cases.push_back(
                        {fmt::format("{}, {} octaves near {:g}, texels of {:g} by {:g} cells, {}",
                                     noise.name, term.octaves, place, step, step * ratio,
                                     to_string(wrap)),
                         texture, std::move(solid)});
                }
    return group;
}

}  // namespace burl
