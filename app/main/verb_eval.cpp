// `burl eval`: value, gradient and colour of a recipe, or of a single noise, at given points, in
// float64 and another precision side by side, so that textures can be checked from outside.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/main/verbs.h"
#include "app/measure/evaluate_points.h"
#include "app/measure/metrics_pictures.h"
#include "app/measure/report.h"
#include "app/options/command_options.h"
#include "app/options/idle_options.h"
#include "app/options/input_limits.h"
#include "app/options/metres.h"
#include "app/recipe/channel_texture.h"
#include "app/recipe/recipe_cost.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "procedural/graph/masks.h"
#include "procedural/model/texture_json.h"

namespace burl {

namespace {

struct EvalCommand {
    RecipeOptions recipe;
    NoiseOptions noise;
    std::string points, channel, mesh;
    MeshOptions meshes;
    bool json = false;
};

/// The keys without effect on the texture at a point.
constexpr std::array idle_in_eval{
    IdleKey{"atlas", "eval works without an atlas"},
    IdleKey{"bump.height", "eval is of numbers, which nothing shades"},
    IdleKey{"filter", "eval is of points, which no filter averages"},
    IdleKey{"paint", "eval is of the texture below the paint"},
    IdleKey{"pose", "eval knows no pose of a mesh"},
    IdleKey{"solid.space", "eval's points are in solid space, and there is no --mesh"}};

std::string srgb_text(const Vec3d& linear) {
    return color_to_hex(encoded(linear));
}

Json evaluation_json(const Evaluation& one) {
    Json json{{"value", one.value}};
    if (!one.gradient.empty()) json["gradient"] = one.gradient;
    if (one.color) {
        json["color"] = {one.color->x, one.color->y, one.color->z};
        json["srgb"] = srgb_text(*one.color);
    }
    return json;
}

Json point_json(const std::array<double, 4>& point, std::size_t dimensions,
                const PointResult& result, const char* other) {
    Json json{
        {"point", std::vector<double>(point.begin(), point.begin() + std::ptrdiff_t(dimensions))},
        {"float64", evaluation_json(result.float64)}};
    if (result.other) json[other] = evaluation_json(*result.other);
    return json;
}

/// The largest differences from float64.
Json differences_json(const std::vector<PointResult>& results) {
    double value = 0.0, gradient = 0.0;
    for (const auto& [float64, other] : results) {
        if (!other) return Json::object();
        value = std::max(value, std::abs(float64.value - other->value));
        for (std::size_t i = 0; i < other->gradient.size(); ++i)
            gradient = std::max(gradient, std::abs(float64.gradient[i] - other->gradient[i]));
    }
    Json json{{"value", value}};
    if (!results.front().other->gradient.empty()) json["gradient"] = gradient;
    return json;
}

Json results_json(const PointFile& file, const std::vector<PointResult>& results, bool fixed) {
    Json points = Json::array();
    for (std::size_t i = 0; i < results.size(); ++i)
        points.push_back(
            point_json(file.points[i], file.dimensions, results[i], fixed ? "fixed" : "float32"));
    return {{"points", points}, {"largest_difference", differences_json(results)}};
}

/// The names of the columns of one precision.
std::string column_names(const Evaluation& one, std::string_view axes, std::string_view suffix) {
    std::string names = fmt::format(",value{}", suffix);
    for (std::size_t i = 0; i < one.gradient.size(); ++i)
        names += fmt::format(",d{}{}", axes[i], suffix);
    if (one.color) names += fmt::format(",red{0},green{0},blue{0},srgb{0}", suffix);
    return names;
}

std::string columns(const Evaluation& one, int digits) {
    std::string text = fmt::format(",{:.{}g}", one.value, digits);
    for (const double slope : one.gradient) text += fmt::format(",{:.{}g}", slope, digits);
    if (one.color)
        text += fmt::format(",{:.{}g},{:.{}g},{:.{}g},{}", one.color->x, digits, one.color->y,
                            digits, one.color->z, digits, srgb_text(*one.color));
    return text;
}

/// Prints a table with a line of names. 17 and 9 digits distinguish all float64 and float32
/// numbers.
void print_table(const PointFile& file, const std::vector<PointResult>& results, bool fixed) {
    const std::string_view axes = std::string_view("xyzw").substr(0, file.dimensions);
    const PointResult& first = results.front();
    fmt::print("{}{}{}\n", fmt::join(axes, ","), column_names(first.float64, axes, ""),
               first.other ? column_names(*first.other, axes, fixed ? "_fixed" : "32") : "");
    for (std::size_t i = 0; i < results.size(); ++i) {
        std::string line;
        for (std::size_t axis = 0; axis < file.dimensions; ++axis)
            line += fmt::format("{}{:.17g}", axis == 0 ? "" : ",", file.points[i][axis]);
        line += columns(results[i].float64, 17);
        if (results[i].other) line += columns(*results[i].other, fixed ? 17 : 9);
        fmt::print("{}\n", line);
    }
}

/// The recipe with the channel asked for as its texture.
Recipe of_channel(Recipe recipe, const std::string& channel) {
    if (channel.empty()) return recipe;
    if (recipe.precision.kind == PrecisionKind::fixed)
        throw Error(ExitCode::usage,
                    "--channel is of float32 and float64; fixed point has colours alone");
    recipe.texture = channel_texture(recipe, channel);
    return recipe;
}

/// The mesh that masks are of; none where none is named.
std::optional<Mesh> mesh_for(const EvalCommand& command, const Recipe& recipe) {
    if (command.mesh.empty()) return {};
    if (first_mask_node(recipe.texture, GraphOutput::color).empty())
        throw Error(ExitCode::usage,
                    "--mesh: the texture reads no mask of a mesh's shape; leave it out");
    return command.meshes.load(command.mesh);
}

void run_eval(const EvalCommand& command, bool recipe_given) {
    if (recipe_given == command.noise.given())
        throw Error(ExitCode::usage, "name either a recipe or, with --noise, one noise");
    if (!recipe_given && (!command.recipe.settings.empty() || command.recipe.time))
        throw Error(ExitCode::usage,
                    "--set and --time are of recipes; a noise has options of its own");
    if (!recipe_given && !command.mesh.empty())
        throw Error(ExitCode::usage, "--mesh is of recipes; a noise knows no mesh");
    if (!recipe_given && !command.channel.empty())
        throw Error(ExitCode::usage, "--channel is of recipes; a noise has one value");
    // Points are read last, since a wrong recipe should be reported without them.
    std::optional<Recipe> recipe;
    std::optional<Mesh> mesh;
    if (recipe_given) {
        recipe = command.recipe.load();
        refuse_edits(command.recipe,
                     std::span(idle_in_eval).first(idle_in_eval.size() - !command.mesh.empty()));
        check_edits(command.recipe, *recipe);
        recipe = of_channel(std::move(*recipe), command.channel);
        mesh = mesh_for(command, *recipe);
        if (mesh) set_metres({&*recipe, 1}, command.recipe, command.meshes.frame, *mesh);
    }
    const std::optional<std::string>& asked = command.recipe.precision;
    const Precision precision = recipe  ? recipe->precision
                                : asked ? parse_precision(*asked)
                                        : Precision{};
    const PointFile file = read_points(command.points);
    if (recipe)
        check_noises(command.points,
                     2.0 * double(file.points.size()) * noises_per_point(*recipe, false),
                     command.recipe);
    const std::vector<PointResult> results =
        recipe ? evaluate_points(*recipe, file, mesh ? &*mesh : nullptr)
               : evaluate_points(command.noise, file, precision);
    const bool fixed = precision.kind == PrecisionKind::fixed;
    if (command.json)
        write_json("-", results_json(file, results, fixed));
    else
        print_table(file, results, fixed);
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
    verb->add_option("--channel", command->channel,
                     "Channel of the recipe's material in place of its colour")
        ->check(one_of(channel_names()));
    auto* mesh = verb->add_option(
        "--mesh", command->mesh,
        "Mesh or sample whose shape masks of the texture are of, each at the mesh's "
        "point nearest to the one asked for");
    command->meshes.add_frame(*verb);
    for (const char* option : {"--up", "--rotate", "--scale", "--units"})
        verb->get_option(option)->needs(mesh);
    command->noise.add(*verb);
    command->recipe.add_precision(*verb, "float32, beside float64");
    verb->add_flag("--json", command->json, "Print JSON");
    add_input_limits(*verb, command->meshes, command->recipe);
    verb->callback([command, recipe, verb] {
        command->noise.check_given(*verb);
        run_eval(*command, recipe->count() > 0);
    });
}

}  // namespace burl
