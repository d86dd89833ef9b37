#include "tests/stability/stability.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "atlas/base/error.h"
#include "tests/stability/checks.h"
#include "tests/stability/truth.h"

namespace burl {

namespace {

/// Images with longer runs are so large that they are made one at a time, and by the kernels only.
constexpr std::uint32_t large_image = 5000;

/// The definition's values at a case's texels, which all ways of filling them are compared with.
struct Definition {
    StabilityTruth truth;
    std::vector<LongPoint> points;
    std::vector<long double> field;
    bool jumps = false;

    explicit Definition(const StabilityCase& one) : truth(one.texture, one.map) {
        for_each_span(one.solid, [&](const Span& span, const TexelMap& map, std::int64_t y) {
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                points.push_back(truth.point(map, x, y));
                field.push_back(truth.field(points.back()));
            }
        });
        for (const Octave& octave : truth.octaves()) jumps = jumps || has_jumps(octave.noise);
    }
};

/// Calls visit(index of the texel, its span, its index in the span, its row, the span's sizes) for
/// every texel.
template <class Visit>
void for_each_texel(const StabilityCase& one, const Definition& definition, const Visit& visit) {
    std::size_t at = 0;
    for_each_span(one.solid, [&](const Span& span, const TexelMap& map, std::int64_t y) {
        const SpanSizes sizes = definition.truth.sizes(span, map, y);
        for (std::uint32_t i = 0; i < span.count; ++i) visit(at++, span, i, y, sizes);
    });
}

void note_errors(const StabilityCase& one, const StabilityWay& way, const Definition& definition,
                 const std::vector<double>& texels, StabilityRow& row) {
    for_each_texel(one, definition,
                   [&](std::size_t at, const Span& span, std::uint32_t i, std::int64_t y,
                       const SpanSizes& sizes) {
                       const auto exact = double(definition.field[at]);
                       const LongPoint& s = definition.points[at];
                       const double error =
                           definition.jumps
                               ? definition.truth.error(s, texels[at], sizes, place_error(way))
                               : std::abs(double((long double)(texels[at]) - definition.field[at]));
                       row.note(error, allowed_error(way, definition.truth, sizes, exact), [&] {
                           return fmt::format(
                               "{}, {}, texel ({}, {}) at ({:.17g}, {:.17g}, {:.17g}): {:.9g} "
                               "for {:.9g}",
                               one.input, way.name, span.x + i, y, double(s[0]), double(s[1]),
                               double(s[2]), texels[at], exact);
                       });
                   });
}

/// Compares the differences of neighbouring texels with those of the definition.
void note_steps(const StabilityCase& one, const StabilityWay& way, const Definition& definition,
                const std::vector<double>& texels, StabilityRow& row) {
    for_each_texel(
        one, definition,
        [&](std::size_t at, const Span&, std::uint32_t i, std::int64_t, const SpanSizes& sizes) {
            if (i == 0) return;
            const long double a = definition.field[at - 1], b = definition.field[at];
            const double step = texels[at] - texels[at - 1];
            const double allowed = allowed_error(way, definition.truth, sizes, double(a)) +
                                   allowed_error(way, definition.truth, sizes, double(b));
            row.jump_share = std::max(row.jump_share, std::abs(step - double(b - a)) / allowed);
        });
}

/// Returns a case with the same points, whose spans begin at the opposite ends of their lines: the
/// other chart of a seam.
StabilityCase reversed(const StabilityCase& one) {
    StabilityCase back = one;
    for_each_span(one.solid, [&](const Span& span, const TexelMap& map, std::int64_t y) {
        TexelMap& other = back.solid.maps[span.map];
        other.origin = map(std::int64_t(span.x) + span.count - 1, y);
        other.step_x = -map.step_x;
        other.anchor_x = std::int32_t(span.x);
    });
    return back;
}

void note_seams(const StabilityCase& one, const StabilityWay& way, const Definition& definition,
                const std::vector<double>& texels, StabilityRow& row) {
    const std::vector<double> back = fill_texels(reversed(one), way, 1);
    for_each_texel(one, definition,
                   [&](std::size_t at, const Span& span, std::uint32_t i, std::int64_t,
                       const SpanSizes& sizes) {
                       const double other = back[at - i + (span.count - 1 - i)];
                       const double allowed = 2.0 * allowed_error(way, definition.truth, sizes,
                                                                  double(definition.field[at]));
                       row.seam_share =
                           std::max(row.seam_share, std::abs(texels[at] - other) / allowed);
                   });
}

StabilityRow row_of(const StabilityWay& way) {
    StabilityRow row;
    row.arithmetic = way.arithmetic, row.cases = 1;
    return row;
}

/// Returns a row per arithmetic, over all cases of the group.
std::vector<StabilityRow> group_errors(const StabilityGroup& group) {
    std::vector<std::vector<StabilityRow>> each(group.cases.size());
    const auto measure = [&](std::size_t i) { each[i] = case_errors(group.cases[i]); };
    std::vector<std::size_t> large, small;
    for (std::size_t i = 0; i < each.size(); ++i)
        (group.cases[i].solid.size >= large_image ? large : small).push_back(i);
    std::ranges::for_each(large, measure);
    tbb::parallel_for(std::size_t(0), small.size(), [&](std::size_t i) { measure(small[i]); });
    std::vector<StabilityRow> rows;
    for (std::size_t i = 0; i < each.size(); ++i)
        for (const StabilityRow& one : each[i]) {
            const bool is_first =
                &one == &each[i].front() || one.arithmetic != (&one)[-1].arithmetic;
            auto row = std::ranges::find(rows, one.arithmetic, &StabilityRow::arithmetic);
            if (row == rows.end()) {
                StabilityRow& added = rows.emplace_back();
                added.group = group.name, added.arithmetic = one.arithmetic;
                row = rows.end() - 1;
            }
            row->cases += is_first ? 1 : 0;
            row->merge(one, fmt::format("{}/{}", group.name, i));
        }
    return rows;
}

/// Returns the rows that check the bounds promised for textures of the papers' size: 1e-6 for the
/// largest error, and 1.7e-7 for the RMS error of any recipe.
std::vector<StabilityRow> unit_rows(const std::vector<StabilityRow>& rows) {
    std::vector<StabilityRow> result;
    for (const StabilityRow& row : rows) {
        if (row.group != unit_group_name || row.arithmetic != "float32") continue;
        StabilityRow largest = row, rms = row;
        largest.group += ": largest", rms.group += ": RMS";
        largest.error = row.largest, largest.share = row.largest / 1e-6;
        rms.error = row.rms, rms.share = row.rms / 1.7e-7;
        largest.case_name = largest.input = row.largest_case;
        rms.case_name = rms.input = row.rms_case;
        for (StabilityRow* one : {&largest, &rms}) {
            one->jump_share = one->seam_share = 0.0;
            result.push_back(*one);
        }
    }
    return result;
}

}  // namespace

void StabilityRow::merge(const StabilityRow& other, const std::string& name) {
    values += other.values;
    jump_share = std::max(jump_share, other.jump_share);
    seam_share = std::max(seam_share, other.seam_share);
    const double its_rms = other.values > 0 ? std::sqrt(other.squares / double(other.values)) : 0.0;
    if (other.largest > largest) largest = other.largest, largest_case = name;
    if (its_rms > rms) rms = its_rms, rms_case = name;
    if (other.share <= share && !input.empty()) return;
    share = other.share, error = other.error, input = other.input, case_name = name;
}

StabilityRow field_errors(const StabilityCase& one, const StabilityWay& way,
                          const std::vector<double>& texels) {
    StabilityRow row = row_of(way);
    note_errors(one, way, Definition(one), texels, row);
    return row;
}

std::vector<StabilityRow> case_errors(const StabilityCase& one) {
    const Definition definition(one);
    const bool is_lines = one.solid.maps.size() == one.solid.spans.size();
    std::vector<StabilityRow> rows;
    for (const StabilityWay& way : stability_ways()) {
        const bool large = one.solid.size >= large_image;
        if (!can_fill(way, one.texture) || (large && way.arithmetic != "float32")) continue;
        StabilityRow& row = rows.emplace_back(row_of(way));
        const std::vector<double> texels = fill_texels(one, way, 1);
        note_errors(one, way, definition, texels, row);
        if (definition.jumps) continue;
        note_steps(one, way, definition, texels, row);
        if (is_lines && !large) note_seams(one, way, definition, texels, row);
    }
    return rows;
}

std::vector<StabilityRow> stability_errors(StabilityChoice choice) {
    std::vector<StabilityRow> rows;
    const auto add = [&](const std::vector<StabilityRow>& more) {
        rows.insert(rows.end(), more.begin(), more.end());
    };
    const std::vector<StabilityGroup> groups = stability_groups(choice);
    for (const StabilityGroup& group : groups) add(group_errors(group));
    add(unit_rows(rows));
    add(check_filter_errors(groups, choice));
    return rows;
}

std::vector<StabilityRow> stability_counts(StabilityChoice choice) {
    const std::vector<StabilityGroup> groups = stability_groups(choice);
    return {check_texel_points(choice),
            check_wrap(choice),
            check_threads(choice),
            check_batches(choice),
            check_instruction_sets(groups, choice),
            check_filters(groups),
            check_refusals()};
}

std::vector<StabilityRow> bench_stability(StabilityChoice choice) {
    std::vector<StabilityRow> rows = stability_errors(choice);
    const std::vector<StabilityRow> counts = stability_counts(choice);
    rows.insert(rows.end(), counts.begin(), counts.end());
    return rows;
}

StabilityCase stability_case(const std::string& name, StabilityChoice choice) {
    const std::size_t slash = name.rfind('/');
    std::vector<StabilityGroup> groups = stability_groups(choice);
    groups.push_back(filter_group(choice));
    for (const StabilityGroup& group : groups) {
        std::size_t i = 0;
        const char *begin = name.data() + slash + 1, *end = name.data() + name.size();
        if (slash == std::string::npos || group.name != name.substr(0, slash)) continue;
        const auto [rest, problem] = std::from_chars(begin, end, i);
        if (problem == std::errc() && rest == end && i < group.cases.size()) return group.cases[i];
        throw Error(ExitCode::usage, fmt::format("--case {}: {} has the cases 0 to {}", name,
                                                 group.name, group.cases.size() - 1));
    }
    throw Error(ExitCode::usage,
                fmt::format("--case {}: must be a group's name and a number as the suite prints "
                            "them, such as \"coordinates/117\"",
                            name));
}

}  // namespace burl
