// The suite `burl bench filter`: cost and error of each texel filter against the mean over the
// texel, by texture and footprint (the error of eq. 9 of Hart et al. 1999, which the paper leaves
// to be investigated). All textures are sampled on oblique planes, with texels 0.7 times as high as
// wide.
#include <cmath>
#include <memory>
#include <random>

#include <fmt/format.h>

#include "app/bench/bench.h"
#include "app/bench/command.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/recipe.h"
#include "atlas/base/json.h"
#include "procedural/fill/graph.h"
#include "procedural/fill/synthesize.h"
#include "procedural/model/octaves.h"

namespace burl {

namespace {

/// The results of a filter.
struct FilterBench {
    std::string texture;  ///< preset, or node of a checkerboard
    /// Side of a texel in cells of the finest octave (zone plate: in units of 1/50).
    double footprint;
    double truth_noise = 0.0;  ///< RMS error of the reference, the sampled mean over a texel
    /// Times are on one thread, errors over all channels in linear light. The method is a value of
    /// --filter, or a form of a checkerboard's node; "grid:16" and "jitter:16" are unweighted
    /// samples, which are not timed, as they cost 16 times the first filter.
    BenchResult result{};
};

constexpr std::uint32_t block = 8, blocks = 8, fine = 64, side_texels = block * blocks;
constexpr double footprints[] = {1.0 / 32, 0.1, 0.25, 1.0};

/// A texture with the filter under test; the first of a subject is unfiltered.
struct NamedRecipe {
    std::string filter;
    Recipe recipe;
};

struct FilterSubject {
    std::string texture;
    double frequency = 1.0;  ///< cells of the finest octave per unit of the solid
    double reach = 1.0;      ///< largest distance of texels from the origin
    std::vector<NamedRecipe> recipes;
};

/// Returns the cells of the finest octave per unit of the solid.
double finest_frequency(const Texture& texture) {
    double finest = 0.0;
    for (const Octave& octave : expand_octaves(texture))
        for (int axis = 0; axis < 3; ++axis)
            finest = std::max(finest, glm::length(octave.lattice_from_solid.linear[axis]));
    return finest > 0.0 ? finest : 50.0;
}

FilterSubject preset(const char* name) {
    using enum FilterKind;
    Recipe recipe = load_recipe(name);
    FilterSubject subject{name, finest_frequency(*plain_texture(recipe.texture)), 1.0, {}};
    const auto add = [&](std::string filter_name, const Filter& filter) {
        recipe.filter = filter;
        subject.recipes.push_back({std::move(filter_name), recipe});
    };
    for (const FilterKind kind :
         {none, table_mip, table_sat, table_sat3, exact, trapezoid, trapezoid2})
        add(std::string(to_string(kind)), {kind, 1, false});
    add("trapezoid, fade", {trapezoid, 1, true});
    add("supersample:16", {supersample, 16, false});
    return subject;
}

/// Returns a checkerboard filtered by each form of its node and by supersampling the whole texture.
FilterSubject checkers(const char* node) {
    FilterSubject subject{node, 1.0, 16.0, {}};
    const auto add = [&](const char* name, const char* form, FilterKind kind) {
        const std::string json =
            fmt::format(R"({{"burl": 1, "texture": {{"node": "{}", "aa": "{}"}}}})", node, form);
        Recipe recipe = parse_recipe(json, node);
        recipe.filter.kind = kind;
        subject.recipes.push_back({name, recipe});
    };
    add("none", "none", FilterKind::none);
    add("closed_form", "closed_form", FilterKind::trapezoid);
    add("trapezoid", "trapezoid", FilterKind::trapezoid);
    add("node's samples", "supersample", FilterKind::trapezoid);
    add("supersample:16", "none", FilterKind::supersample);
    return subject;
}

Image<RgbF> colors(const SolidAtlas& solid, const Recipe& recipe) {
    if (const Texture* texture = plain_texture(recipe.texture))
        return synthesize_model<RgbF>(solid, *texture, {}, 0, recipe.filter);
    return synthesize_graph<RgbF>(solid, recipe.texture, {}, recipe.filter, 0);
}

/// Bakes on one thread, in 8 bits.
void bake(const SolidAtlas& solid, const Recipe& recipe) {
    if (const Texture* texture = plain_texture(recipe.texture))
        synthesize_model<Rgb8>(solid, *texture, {}, 1, recipe.filter);
    else
        synthesize_graph<Rgb8>(solid, recipe.texture, {}, recipe.filter, 1);
}

TexelMap plane(const Vec3d& origin, double side) {
    const Vec3d u(0.8, 0.36, 0.48), v(-0.6, 0.48, 0.64);  // orthogonal unit vectors
    return {origin, side * u, 0.7 * side * v, 0, 0};
}

/// Returns an atlas of squares of side x side texels, `across` in a row, each with its own map.
SolidAtlas squares(const std::vector<TexelMap>& maps, std::uint32_t across, std::uint32_t side) {
    SolidAtlas solid;
    solid.size = across * side;
    solid.maps = maps;
    for (std::uint32_t i = 0; i < maps.size(); ++i) {
        solid.maps[i].anchor_x = std::int32_t(i % across * side);
        solid.maps[i].anchor_y = std::int32_t(i / across * side);
    }
    for (std::uint32_t y = 0; y < solid.size; ++y) {
        solid.row_begin.push_back(solid.spans.size());
        for (std::uint32_t x = 0; x < across; ++x)
            solid.spans.push_back({x * side, side, y / side * across + x});
    }
    solid.row_begin.push_back(solid.spans.size());
    return solid;
}

/// Statistics of the 64 x 64 samples of a texel: the mean, and the means of 16 of them.
struct TexelTruth {
    Vec3d mean{0.0}, grid{0.0}, jittered{0.0};
    Vec3d halves{0.0};  ///< difference of the means of the two halves of a chequered split
};

Vec3d as_vector(const RgbF& c) {
    return {c.r, c.g, c.b};
}

/// Computes the statistics of a texel from its 64 x 64 samples, taken at the centres of equal
/// parts.
TexelTruth summed(const Image<RgbF>& samples, std::size_t x, std::size_t y, std::mt19937& random) {
    TexelTruth truth;
    constexpr std::size_t stratum = fine / 4;
    for (std::size_t j = 0; j < fine; ++j)
        for (std::size_t i = 0; i < fine; ++i) {
            const Vec3d color = as_vector(samples(x * fine + i, y * fine + j));
            truth.mean += color / double(fine * fine);
            truth.halves += ((i + j) % 2 == 0 ? color : -color) / double(fine * fine / 2);
        }
    const auto at = [&](std::size_t k, std::size_t i, std::size_t j) {
        return as_vector(samples(x * fine + k % 4 * stratum + i, y * fine + k / 4 * stratum + j));
    };
    for (std::size_t k = 0; k < 16; ++k) {
        // The centre of a stratum is the common corner of four samples.
        const std::size_t m = stratum / 2;
        truth.grid +=
            (at(k, m, m) + at(k, m - 1, m - 1) + at(k, m, m - 1) + at(k, m - 1, m)) / 64.0;
        const std::size_t i = random() % stratum, j = random() % stratum;
        truth.jittered += at(k, i, j) / 16.0;
    }
    return truth;
}

std::vector<TexelTruth> truths(const std::vector<TexelMap>& maps, const Recipe& point) {
    std::vector<TexelTruth> result(side_texels * side_texels);
    std::mt19937 random(7);
    for (std::size_t m = 0; m < maps.size(); ++m) {
        TexelMap map = maps[m];
        map.origin += (0.5 / fine - 0.5) * (map.step_x + map.step_y);
        map.step_x /= fine;
        map.step_y /= fine;
        const Image<RgbF> samples = colors(squares({map}, 1, block * fine), point);
        for (std::size_t y = 0; y < block; ++y)
            for (std::size_t x = 0; x < block; ++x)
                result[(m / blocks * block + y) * side_texels + m % blocks * block + x] =
                    summed(samples, x, y, random);
    }
    return result;
}

BenchError error_of(const std::vector<TexelTruth>& truth,
                    const std::function<Vec3d(std::size_t)>& value) {
    std::vector<double> values, means;
    for (std::size_t i = 0; i < truth.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            values.push_back(value(i)[c]);
            means.push_back(truth[i].mean[c]);
        }
    return BenchError::of(values, means);
}

/// Returns the group's name, with the footprint as a fraction of a cell.
std::string group_name(const std::string& texture, double footprint) {
    return footprint < 1.0 ? fmt::format("{}, 1/{:.0f}", texture, 1.0 / footprint)
                           : fmt::format("{}, {:.0f}", texture, footprint);
}

/// Times all filters on one large square.
std::vector<BenchRow> time_filters(const FilterSubject& subject, const std::string& group,
                                   double side, std::size_t across, int repeats) {
    const auto solid = std::make_shared<SolidAtlas>(
        squares({plane({0.3, 0.2, 0.1}, side)}, 1, std::uint32_t(across)));
    std::vector<BenchCase> cases;
    for (const NamedRecipe& r : subject.recipes)
        cases.push_back(
            {r.filter, double(across * across), "texel", [=] { bake(*solid, r.recipe); }, group});
    return run_paired(cases, repeats);
}

std::vector<TexelMap> random_planes(const FilterSubject& subject, double side) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-subject.reach, subject.reach);
    std::vector<TexelMap> maps;
    for (std::uint32_t i = 0; i < blocks * blocks; ++i)
        maps.push_back(plane({place(random), place(random), place(random)}, side));
    return maps;
}

void add_rows(std::vector<FilterBench>& rows, const FilterSubject& subject, double footprint,
              int repeats, std::size_t across) {
    const double side = footprint / subject.frequency;
    const std::vector<TexelMap> maps = random_planes(subject, side);
    const std::vector<TexelTruth> truth = truths(maps, subject.recipes.front().recipe);
    // If the errors of the halves are independent, they differ by twice the error of their mean.
    const double noise =
        0.5 * error_of(truth, [&](std::size_t i) { return truth[i].mean + truth[i].halves; }).rms;
    const std::string group = group_name(subject.texture, footprint);
    const auto add = [&](const BenchRow& time, const std::function<Vec3d(std::size_t)>& value) {
        rows.push_back({subject.texture, footprint, noise, {time, error_of(truth, value)}});
    };
    const SolidAtlas solid = squares(maps, blocks, block);
    const std::vector<BenchRow> times = time_filters(subject, group, side, across, repeats);
    for (std::size_t k = 0; k < times.size(); ++k) {
        const Image<RgbF> image = colors(solid, subject.recipes[k].recipe);
        add(times[k], [&](std::size_t i) { return as_vector(image.pixels()[i]); });
    }
    const auto untimed = [&](const char* filter) {
        BenchRow row;
        row.name = filter, row.unit = "texel", row.group = group;
        return row;
    };
    add(untimed("grid:16"), [&](std::size_t i) { return truth[i].grid; });
    add(untimed("jitter:16"), [&](std::size_t i) { return truth[i].jittered; });
}

/// Times are of side^2 texels in `repeats` paired rounds. Errors are over 4,096 texels at 64
/// places of the solid, against the mean of 64 x 64 samples of each.
std::vector<FilterBench> bench_filters(int repeats, std::size_t side) {
    std::vector<FilterSubject> subjects;
    for (const char* name : {"wood", "marble", "clouds", "planet", "zoneplate"})
        subjects.push_back(preset(name));
    for (const char* node : {"checkerboard", "checkerboard_3d"}) subjects.push_back(checkers(node));
    std::vector<FilterBench> rows;
    for (const FilterSubject& subject : subjects)
        for (const double footprint : footprints) add_rows(rows, subject, footprint, repeats, side);
    return rows;
}

Json filter_json(const FilterBench& row) {
    Json json = result_json(row.result);
    json.update(Json{{"texture", row.texture},
                     {"footprint_cells", row.footprint},
                     {"truth_noise", row.truth_noise}});
    return json;
}

}  // namespace

void run_filter_bench(const BenchCommand& command) {
    const std::vector<FilterBench> rows = bench_filters(command.repeats, command.size_or(256));
    if (!report_rows(command, rows, filter_json)) return;
    std::vector<BenchResult> results;
    for (const FilterBench& row : rows) results.push_back(row.result);
    fmt::print("{}", result_table(results));
}

}  // namespace burl
