// `burl eval`: value, gradient and colour of a recipe, or of one noise, at given points, in float64
// and float32 side by side: the way anyone checks the textures from outside.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "app/command_options.h"
#include "app/evaluate_points.h"
#include "app/report.h"
#include "app/verbs.h"
#include "atlas/error.h"
#include "procedural/srgb.h"
#include "procedural/texture_json.h"

namespace burl {

namespace {

struct EvalCommand {
    RecipeOptions recipe;
    NoiseOptions noise;
    std::string points, fixed;
    bool json = false;
};

/// "8.8".
FixedFormat parse_format(const std::string& text) {
    FixedFormat format;
    const char* const last = text.data() + text.size();
    const auto integer = std::from_chars(text.data(), last, format.integer_bits);
    const bool dot = integer.ec == std::errc() && integer.ptr != last && *integer.ptr == '.';
    const auto fraction = std::from_chars(dot ? integer.ptr + 1 : last, last, format.fraction_bits);
    if (!dot || fraction.ec != std::errc() || fraction.ptr != last || format.integer_bits < 1 ||
        format.integer_bits > 16 || format.fraction_bits < 2 || format.fraction_bits > 16)
        throw Error(ExitCode::usage,
                    "--fixed takes bits before and after the point, 1 to 16 and 2 to 16, as 8.8");
    return format;
}

std::string srgb_text(const Vec3d& linear) {
    const auto code = [](double x) {
        return std::uint8_t(std::lround(255.0 * srgb_encode(std::clamp(x, 0.0, 1.0))));
    };
    return color_to_hex({code(linear.x), code(linear.y), code(linear.z)});
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
                const PointResult& result) {
    Json json{
        {"point", std::vector<double>(point.begin(), point.begin() + std::ptrdiff_t(dimensions))},
        {"float64", evaluation_json(result.float64)},
        {"float32", evaluation_json(result.float32)}};
    if (result.fixed) json["fixed"] = evaluation_json(*result.fixed);
    return json;
}

/// Largest differences from float64.
Json differences_json(const std::vector<PointResult>& results) {
    double value = 0.0, gradient = 0.0, fixed = 0.0;
    for (const PointResult& r : results) {
        value = std::max(value, std::abs(r.float64.value - r.float32.value));
        for (std::size_t i = 0; i < r.float64.gradient.size(); ++i)
            gradient = std::max(gradient, std::abs(r.float64.gradient[i] - r.float32.gradient[i]));
        if (r.fixed) fixed = std::max(fixed, std::abs(r.float64.value - r.fixed->value));
    }
    Json json{{"value", value}, {"gradient", gradient}};
    if (results.front().fixed) json["fixed_value"] = fixed;
    return json;
}

Json results_json(const PointFile& file, const std::vector<PointResult>& results) {
    Json points = Json::array();
    for (std::size_t i = 0; i < results.size(); ++i)
        points.push_back(point_json(file.points[i], file.dimensions, results[i]));
    return {{"points", points}, {"largest_difference", differences_json(results)}};
}

/// Names of the columns of one precision.
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

/// A table with a line of names; 17 and 9 digits tell every float64 and float32.
void print_table(const PointFile& file, const std::vector<PointResult>& results) {
    const std::string_view axes = std::string_view("xyzw").substr(0, file.dimensions);
    const PointResult& first = results.front();
    fmt::print("{}{}{}{}\n", fmt::join(axes, ","), column_names(first.float64, axes, ""),
               column_names(first.float32, axes, "32"),
               first.fixed ? column_names(*first.fixed, axes, "_fixed") : "");
    for (std::size_t i = 0; i < results.size(); ++i) {
        std::string line;
        for (std::size_t axis = 0; axis < file.dimensions; ++axis)
            line += fmt::format("{}{:.17g}", axis == 0 ? "" : ",", file.points[i][axis]);
        line += columns(results[i].float64, 17) + columns(results[i].float32, 9);
        if (results[i].fixed) line += columns(*results[i].fixed, 17);
        fmt::print("{}\n", line);
    }
}

void run_eval(const EvalCommand& command, bool recipe_given) {
    if (recipe_given == command.noise.given())
        throw Error(ExitCode::usage, "name either a recipe or, with --noise, one noise");
    if (!recipe_given && !command.recipe.settings.empty())
        throw Error(ExitCode::usage, "--set edits recipes; a noise has options of its own");
    std::optional<FixedFormat> format;
    if (!command.fixed.empty()) format = parse_format(command.fixed);
    // The points last: a wrong recipe should not need them.
    std::optional<Recipe> recipe;
    if (recipe_given) recipe = command.recipe.load();
    const PointFile file = read_points(command.points);
    const std::vector<PointResult> results = recipe ? evaluate_points(*recipe, file, format)
                                                    : evaluate_points(command.noise, file, format);
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
    verb->add_option("--fixed", command->fixed,
                     "Also in fixed point with I.F bits, such as 8.8 (value and perlin noise)");
    verb->add_flag("--json", command->json, "Print JSON");
    verb->callback([command, recipe] { run_eval(*command, recipe->count() > 0); });
}

}  // namespace burl
