// A recipe at points, and the figures of atlases.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "app/base/json_text.h"
#include "app/library/evaluate.h"
#include "app/library/guard.h"
#include "app/library/metrics.h"
#include "app/library/reported.h"
#include "app/library/states.h"
#include "app/measure/evaluate_points.h"
#include "app/measure/measuring.h"
#include "app/recipe/channel_texture.h"
#include "app/recipe/edit/keyed_recipe.h"
#include "atlas/base/json.h"
#include "atlas/base/stop.h"

namespace burl::library {

namespace {

/// Points that are evaluated together: few enough for a core's cache, enough to prepare the
/// recipe for.
constexpr std::size_t chunk = 4096;

constexpr const char* evaluating = "evaluating the recipe";

burl::Recipe evaluated_recipe(const Recipe& recipe, const std::string& channel) {
    burl::Recipe asked = recipe_at(recipe.state().recipe, 0.0);
    asked.precision = {};
    asked.precision.kind = PrecisionKind::float64;
    if (channel.empty()) return asked;
    const std::vector<std::string> names = channel_names();
    if (std::ranges::find(names, channel) == names.end())
        throw burl::Error(ExitCode::usage, fmt::format("there is no channel '{}'; there are {}",
                                                       channel, fmt::join(names, ", ")));
    asked.texture = channel_texture(asked, channel);
    return asked;
}

/// The points `first` up to `end`. Throws burl::Error(usage) for one that is not finite.
PointFile points_of(std::span<const double> points, std::size_t first, std::size_t end) {
    PointFile file;
    for (std::size_t i = first; i < end; ++i) {
        const std::array<double, 4> point{points[3 * i], points[3 * i + 1], points[3 * i + 2], 0.0};
        if (!std::ranges::all_of(point, [](double x) { return std::isfinite(x); }))
            throw burl::Error(ExitCode::usage, fmt::format("point {} is not finite", i));
        file.points.push_back(point);
    }
    return file;
}

void store(const std::vector<PointResult>& results, std::size_t first, Evaluated& evaluated) {
    for (std::size_t i = 0; i < results.size(); ++i) {
        const Evaluation& one = results[i].float64;
        const std::size_t at = first + i;
        evaluated.values[at] = one.value;
        std::ranges::copy(one.gradient, evaluated.gradients.begin() + std::ptrdiff_t(3 * at));
        for (int k = 0; k < 3; ++k) evaluated.colors[3 * at + std::size_t(k)] = (*one.color)[k];
    }
}

/// The kinds of atlas that the options ask for.
std::vector<AtlasKind> kinds_of(const MetricsOptions& options, const burl::Recipe& recipe) {
    if (options.atlas.empty()) return {recipe.atlas.kind};
    if (options.atlas == "all") return all_atlas_kinds(recipe.atlas.size);
    if (const auto kind = enum_named<AtlasKind>(options.atlas)) return {*kind};
    throw burl::Error(ExitCode::usage,
                      fmt::format("atlas '{}': must be one of {}, or all", options.atlas,
                                  fmt::join(enum_names<AtlasKind>, ", ")));
}

Json measured(const Mesh& mesh, const Recipe& recipe, const MetricsOptions& options,
              const std::stop_token& stop, Course* course) {
    MeasuringPlan plan;
    plan.stop = stop;
    plan.meter = course ? &course->meter() : nullptr;
    plan.recipe = recipe_at(recipe.state().recipe, 0.0);
    if (options.size != 0)
        plan.recipe.atlas.size = options.size,
        plan.recipe.atlas.width = plan.recipe.atlas.height = 0;
    check_size(plan.recipe.atlas);
    check_square(plan.recipe.atlas);
    plan.looks_up_recipe = true;
    plan.lookups = options.lookups;
    const std::vector<AtlasKind> kinds = kinds_of(options, plan.recipe);
    const burl::Mesh& measured = mesh.state().mesh;
    if (options.own_uvs && measured.corners.uvs.empty())
        throw burl::Error(ExitCode::usage, "the mesh has no texture coordinates to measure");
    Measuring measuring(std::move(plan), measured);
    return measuring.json(measuring.all(options.own_uvs, kinds));
}

Evaluated evaluated(const Recipe& recipe, std::span<const double> points,
                    const EvaluateOptions& options, const std::stop_token& stop, Course* course) {
    if (points.size() % 3 != 0)
        throw burl::Error(ExitCode::usage,
                          fmt::format("points: {} numbers are not three per point", points.size()));
    const burl::Recipe asked = evaluated_recipe(recipe, options.channel);
    const burl::Mesh* const mesh = options.mesh ? &options.mesh->state().mesh : nullptr;
    const std::size_t count = points.size() / 3;
    Evaluated evaluated{std::vector<double>(count), std::vector<double>(3 * count),
                        std::vector<double>(3 * count)};
    if (course) course->expect({{evaluating}});
    if (course) course->meter().begin(evaluating, count);
    // A mesh's shape is prepared once for all points.
    const std::size_t step = mesh ? std::max<std::size_t>(count, 1) : chunk;
    tbb::parallel_for(std::size_t(0), (count + step - 1) / step, [&](std::size_t i) {
        const std::size_t first = i * step, end = std::min(first + step, count);
        check_stop(stop);
        store(evaluate_points(asked, points_of(points, first, end), mesh, stop), first, evaluated);
        if (course) course->meter().add(end - first);
    });
    return evaluated;
}

}  // namespace

Evaluated evaluate(const Recipe& recipe, std::span<const double> points,
                   const EvaluateOptions& options) {
    const auto make = [&](const std::stop_token& stop, Course* course) {
        return guarded([&] { return evaluated(recipe, points, options, stop, course); });
    };
    return made_reported(options.progress, make);
}

std::string metrics(const Mesh& mesh, const Recipe& recipe, const MetricsOptions& options) {
    const auto make = [&](const std::stop_token& stop, Course* course) {
        return guarded([&] {
            return measured(mesh, recipe, options, stop, course)
                       .dump(2, ' ', false, Json::error_handler_t::replace) +
                   "\n";
        });
    };
    return made_reported(options.progress, make);
}

double number_at(const std::string& json, const std::string& pointer) {
    return guarded([&] {
        const Json tree = parse_json_text(json, "JSON");
        try {
            const Json& found = tree.at(Json::json_pointer(pointer));
            if (found.is_number()) return found.get<double>();
        } catch (const Json::exception&) {
        }
        throw burl::Error(ExitCode::usage, fmt::format("there is no number at '{}'", pointer));
    });
}

}  // namespace burl::library
