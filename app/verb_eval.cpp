// `burl eval`: value, gradient and colour of a recipe, or of one noise, at given points, in float64
// and float32 side by side: the way anyone checks the textures from outside.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "app/command_options.h"
#include "app/noise_options.h"
#include "app/point_file.h"
#include "app/report.h"
#include "app/verbs.h"
#include "atlas/error.h"
#include "procedural/color_table.h"
#include "procedural/octaves.h"
#include "procedural/srgb.h"
#include "procedural/texture_json.h"

namespace burl {

namespace {

struct EvalCommand {
    RecipeOptions recipe;
    NoiseOptions noise;
    std::string points;
    bool json = false;
};

/// What one precision gives at a point.
struct Evaluation {
    double value = 0.0;
    std::vector<double> gradient;  ///< as many components as the points have coordinates
    std::optional<Vec3d> color;    ///< linear light
};

struct BothPrecisions {
    Evaluation float64, float32;
};

template <class Real, std::size_t N>
Evaluation evaluate_noise_at(const NoiseOptions& noise, const std::array<double, 4>& point) {
    Point<N> p;
    std::copy_n(point.begin(), N, p.begin());
    const NoiseSample<Real, N> n = sample_noise<Real>(noise, p);
    return {double(n.value), {n.gradient.begin(), n.gradient.end()}, {}};
}

template <std::size_t N>
std::vector<BothPrecisions> evaluate_noise(const NoiseOptions& noise, const PointFile& file) {
    std::vector<BothPrecisions> results;
    for (const auto& point : file.points)
        results.push_back({evaluate_noise_at<double, N>(noise, point),
                           evaluate_noise_at<float, N>(noise, point)});
    return results;
}

std::vector<BothPrecisions> evaluate_noise(NoiseOptions noise, const PointFile& file) {
    noise.resolve(file.dimensions);
    switch (file.dimensions) {
        case 1:
            return evaluate_noise<1>(noise, file);
        case 2:
            return evaluate_noise<2>(noise, file);
        case 3:
            return evaluate_noise<3>(noise, file);
        default:
            return evaluate_noise<4>(noise, file);
    }
}

/// Noise in Real, the sum in float64, the result in Real again, as a bake has it. The gradient is
/// with respect to the point in solid space, before the recipe's scale.
template <class Real>
Evaluation evaluate_recipe_at(const Recipe& recipe, std::span<const Octave> octaves,
                              const PreparedColorMap& colors, const Vec3d& point) {
    const Affine3 map = texture_from_solid(recipe);
    const FieldSample f = sample_field<Real>(recipe.texture.quadric, octaves, map(point));
    const Vec3d gradient = f.gradient * map.linear, color = colors(f.value);
    const auto rounded = [](double x) { return double(Real(x)); };
    return {rounded(f.value),
            {rounded(gradient.x), rounded(gradient.y), rounded(gradient.z)},
            Vec3d(rounded(color.x), rounded(color.y), rounded(color.z))};
}

std::vector<BothPrecisions> evaluate_recipe(const Recipe& recipe, const PointFile& file) {
    if (file.dimensions != 3)
        throw Error(
            ExitCode::usage,
            fmt::format("a recipe needs points x,y,z; these have {} coordinates", file.dimensions));
    const std::vector<Octave> octaves = expand_octaves(recipe.texture);
    const PreparedColorMap colors(recipe.texture.colors);
    std::vector<BothPrecisions> results;
    for (const auto& [x, y, z, w] : file.points)
        results.push_back({evaluate_recipe_at<double>(recipe, octaves, colors, {x, y, z}),
                           evaluate_recipe_at<float>(recipe, octaves, colors, {x, y, z})});
    return results;
}

std::string srgb_text(const Vec3d& linear) {
    const auto code = [](double x) {
        return std::uint8_t(std::lround(255.0 * srgb_encode(std::clamp(x, 0.0, 1.0))));
    };
    return color_to_hex({code(linear.x), code(linear.y), code(linear.z)});
}

Json evaluation_json(const Evaluation& one) {
    Json json{{"value", one.value}, {"gradient", one.gradient}};
    if (one.color) {
        json["color"] = {one.color->x, one.color->y, one.color->z};
        json["srgb"] = srgb_text(*one.color);
    }
    return json;
}

Json results_json(const PointFile& file, const std::vector<BothPrecisions>& results) {
    Json points = Json::array();
    double value = 0.0, gradient = 0.0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const auto& [float64, float32] = results[i];
        const auto& point = file.points[i];
        points.push_back(
            {{"point",
              std::vector<double>(point.begin(), point.begin() + std::ptrdiff_t(file.dimensions))},
             {"float64", evaluation_json(float64)},
             {"float32", evaluation_json(float32)}});
        value = std::max(value, std::abs(float64.value - float32.value));
        for (std::size_t axis = 0; axis < file.dimensions; ++axis)
            gradient =
                std::max(gradient, std::abs(float64.gradient[axis] - float32.gradient[axis]));
    }
    return {{"points", points}, {"largest_difference", {{"value", value}, {"gradient", gradient}}}};
}

/// A table with a line of names; 17 and 9 digits tell every float64 and float32.
void print_table(const PointFile& file, const std::vector<BothPrecisions>& results) {
    constexpr std::string_view axes = "xyzw";
    const std::string_view used = axes.substr(0, file.dimensions);
    const bool colored = results.front().float64.color.has_value();
    std::string line = fmt::format("{}", fmt::join(used, ","));
    for (const char* suffix : {"", "32"}) {
        line += fmt::format(",value{}", suffix);
        for (const char axis : used) line += fmt::format(",d{}{}", axis, suffix);
        if (colored) line += fmt::format(",red{0},green{0},blue{0},srgb{0}", suffix);
    }
    fmt::print("{}\n", line);
    for (std::size_t i = 0; i < results.size(); ++i) {
        line.clear();
        for (std::size_t axis = 0; axis < file.dimensions; ++axis)
            line += fmt::format("{}{:.17g}", axis == 0 ? "" : ",", file.points[i][axis]);
        for (const auto& [one, digits] :
             {std::pair{&results[i].float64, 17}, {&results[i].float32, 9}}) {
            line += fmt::format(",{:.{}g}", one->value, digits);
            for (const double slope : one->gradient) line += fmt::format(",{:.{}g}", slope, digits);
            if (one->color)
                line +=
                    fmt::format(",{:.{}g},{:.{}g},{:.{}g},{}", one->color->x, digits, one->color->y,
                                digits, one->color->z, digits, srgb_text(*one->color));
        }
        fmt::print("{}\n", line);
    }
}

void run_eval(const EvalCommand& command, bool recipe_given) {
    if (recipe_given == command.noise.given())
        throw Error(ExitCode::usage, "name either a recipe or, with --noise, one noise");
    if (!recipe_given && !command.recipe.settings.empty())
        throw Error(ExitCode::usage, "--set edits recipes; a noise has options of its own");
    // The points last: a wrong recipe should not need them.
    std::optional<Recipe> recipe;
    if (recipe_given) recipe = command.recipe.load();
    const PointFile file = read_points(command.points);
    const std::vector<BothPrecisions> results =
        recipe ? evaluate_recipe(*recipe, file) : evaluate_noise(command.noise, file);
    if (command.json)
        write_json("-", results_json(file, results));
    else
        print_table(file, results);
}

}  // namespace

void add_eval(CLI::App& program) {
    auto* verb = program.add_subcommand(
        "eval", "Print value, gradient and colour of a recipe or a noise at given points");
    auto command = std::make_shared<EvalCommand>();
    auto* recipe =
        verb->add_option("recipe", command->recipe.recipe, "Preset name or recipe file (.json)");
    command->recipe.add_settings(*verb);
    verb->add_option("--points", command->points, "Points, lines of x,y,z (.csv)")->required();
    command->noise.add(*verb);
    verb->add_flag("--json", command->json, "Print JSON");
    verb->callback([command, recipe] { run_eval(*command, recipe->count() > 0); });
}

}  // namespace burl
