#include "app/bench_stability.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "app/stability_cases.h"
#include "app/stability_checks.h"
#include "app/stability_truth.h"
#include "procedural/srgb.h"
#include "procedural/synthesize.h"

namespace burl {

namespace {

std::string texel_text(const StabilityCase& one, const TexelMap& map, std::int64_t x,
                       std::int64_t y, double got, double truth) {
    const Vec3d s = one.map(map(x, y));
    return fmt::format("{}, texel ({}, {}) at ({:.17g}, {:.17g}, {:.17g}): {:.9g} for {:.9g}",
                       one.input, x, y, s.x, s.y, s.z, got, truth);
}

/// Takes over `other` where it is worse.
void merge(StabilityRow& row, const StabilityRow& other) {
    row.cases += other.cases, row.values += other.values;
    if (!(other.share > row.share) && !row.input.empty()) return;
    row.share = other.share, row.error = other.error, row.input = other.input;
}

void note(StabilityRow& row, double error, double allowed,
          const std::function<std::string()>& input) {
    ++row.values;
    const double share = error / allowed;
    if (share <= row.share && !row.input.empty()) return;  // NaN is worse than any
    row.share = std::isnan(share) ? HUGE_VAL : share, row.error = error, row.input = input();
}

/// visit(span, map, y) for every span.
template <class Visit>
void for_each_span(const SolidAtlas& solid, const Visit& visit) {
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y)) visit(span, solid.maps[span.map], std::int64_t(y));
}

/// Texels against the definition.
StabilityRow field_errors(const StabilityCase& one) {
    return field_errors(one, synthesize_field(one.solid, one.texture, one.map, 1));
}

}  // namespace

StabilityRow field_errors(const StabilityCase& one, const Image<float>& field) {
    StabilityRow row{"", 1};
    const StabilityTruth truth(one.texture, one.map);
    for_each_span(one.solid, [&](const Span& span, const TexelMap& map, std::int64_t y) {
        for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
            const auto exact = double(truth.field(truth.point(map, x, y)));
            const double got = double(field(x, std::size_t(y)));
            note(row, std::abs(got - exact), truth.bound(span, map, y, exact),
                 [&] { return texel_text(one, map, x, y, got, exact); });
        }
    });
    return row;
}

namespace {

/// Neighbouring texels of a line against each other: what f changes by, against what it should.
StabilityRow jumps(const StabilityCase& one) {
    StabilityRow row{"", 1};
    const StabilityTruth truth(one.texture, one.map);
    const Image<float> field = synthesize_field(one.solid, one.texture, one.map, 1);
    for_each_span(one.solid, [&](const Span& span, const TexelMap& map, std::int64_t y) {
        long double before = truth.field(truth.point(map, span.x, y));
        for (std::uint32_t x = span.x + 1; x < span.x + span.count; ++x) {
            const long double exact = truth.field(truth.point(map, x, y));
            const double moved =
                double(field(x, std::size_t(y))) - double(field(x - 1, std::size_t(y)));
            note(row, std::abs(moved - double(exact - before)),
                 truth.bound(span, map, y, double(exact)) +
                     truth.bound(span, map, y, double(before)),
                 [&] { return texel_text(one, map, x, y, moved, double(exact - before)); });
            before = exact;
        }
    });
    return row;
}

/// The same places by two charts, whose spans begin at opposite ends of the line.
StabilityRow seams(const StabilityCase& one) {
    StabilityRow row{"", 1};
    StabilityCase back = one;
    for_each_span(one.solid, [&](const Span& span, const TexelMap& map, std::int64_t y) {
        TexelMap& other = back.solid.maps[span.map];
        other.origin = map(std::int64_t(span.x) + span.count - 1, y);
        other.step_x = -map.step_x;
        other.anchor_x = std::int32_t(span.x);
    });
    const StabilityTruth truth(one.texture, one.map);
    const Image<float> field = synthesize_field(one.solid, one.texture, one.map, 1);
    const Image<float> reversed = synthesize_field(back.solid, back.texture, back.map, 1);
    for_each_span(one.solid, [&](const Span& span, const TexelMap& map, std::int64_t y) {
        for (std::uint32_t i = 0; i < span.count; ++i) {
            const std::uint32_t x = span.x + i, mirrored = span.x + span.count - 1 - i;
            const double a = double(field(x, std::size_t(y))),
                         b = double(reversed(mirrored, std::size_t(y)));
            note(row, std::abs(a - b), 2.0 * truth.bound(span, map, y, a),
                 [&] { return texel_text(one, map, x, y, b, a); });
        }
    });
    return row;
}

/// The steepest slope of a map's straight pieces, linear light per unit of index.
double steepest(const ColorMap& map) {
    double slope = 0.0;
    for (std::size_t i = 1; i < map.stops.size(); ++i) {
        const Vec3d step = linear_light(map.stops[i].color) - linear_light(map.stops[i - 1].color);
        const double width = map.stops[i].position - map.stops[i - 1].position;
        for (int c = 0; c < 3; ++c) slope = std::max(slope, std::abs(step[c]) / width);
    }
    return slope;
}

/// Colours against those of the definition: f is held in float64, so large sizes cost its rounding
/// and no more.
StabilityRow color_errors(const StabilityCase& one) {
    StabilityRow row{"", 1};
    const StabilityTruth truth(one.texture, one.map);
    const Image<RgbF> colors = synthesize_rgbf(one.solid, one.texture, one.map, 1);
    const double slope = steepest(one.texture.colors);
    for_each_span(one.solid, [&](const Span& span, const TexelMap& map, std::int64_t y) {
        const double f_error = 2.5e-7 * truth.amplitudes() + truth.rounding(span, map, y);
        for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
            const double exact = truth.color(truth.field(truth.point(map, x, y))).x;
            const double got = double(colors(x, std::size_t(y)).r);
            note(row, std::abs(got - exact), slope * f_error + 1e-6,
                 [&] { return texel_text(one, map, x, y, got, exact); });
        }
    });
    return row;
}

using Measure = StabilityRow (*)(const StabilityCase&);

/// All cases, in parallel; the first of equally bad ones is told.
StabilityRow measured(const std::string& name, const std::vector<StabilityCase>& cases,
                      Measure measure) {
    std::vector<StabilityRow> rows(cases.size());
    tbb::parallel_for(std::size_t(0), cases.size(),
                      [&](std::size_t i) { rows[i] = measure(cases[i]); });
    StabilityRow all{name};
    for (const StabilityRow& row : rows) merge(all, row);
    return all;
}

}  // namespace

std::vector<StabilityRow> bench_stability(bool full) {
    std::vector<StabilityRow> rows;
    const std::vector<StabilityGroup> groups = stability_groups(full);
    for (const StabilityGroup& group : groups) {
        rows.push_back(measured(group.name, group.cases, field_errors));
        if (group.name == "lattice planes" || group.name == "coordinates")
            rows.push_back(measured(group.name + ": jumps", group.cases, jumps));
        if (group.name == "runs" || group.name == "coordinates" || group.name == "beyond 2^31")
            rows.push_back(measured(group.name + ": seams", group.cases, seams));
        if (group.name == "quadrics")
            rows.push_back(measured("quadrics: colours", group.cases, color_errors));
    }
    for (const StabilityRow& row : {check_texel_points(full), check_wrap(), check_threads(),
                                    check_batches(), check_filters(groups), check_refusals()})
        rows.push_back(row);
    return rows;
}

}  // namespace burl
