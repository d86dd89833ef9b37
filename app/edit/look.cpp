#include "app/edit/look.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "app/edit/tree.h"
#include "app/recipe/schema_check.h"
#include "procedural/graph/evaluator.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

constexpr std::size_t points_on_ball = 500;
constexpr double least_contrast = 0.25;  // of a number that is shown as it is

/// Puts a node into copies of the nodes around its place that move the point, so that it is
/// evaluated where it stands.
Json at_its_point(const RecipeTree& tree, Json node, const std::string& place) {
    if (const std::string name = defined_at(place); !name.empty()) {
        const std::vector<std::string> uses = tree.uses(name);
        return uses.empty() ? node : at_its_point(tree, std::move(node), uses.front());
    }
    const std::size_t dot = place.rfind('.');
    const Json* owner = dot == std::string::npos ? nullptr : tree.find(place.substr(0, dot));
    if (!owner || !is_node(*owner)) return node;
    if (type_of(*owner).result == NodeResult::inner) {
        Json around = *owner;
        around["input"] = std::move(node);
        node = std::move(around);
    }
    return at_its_point(tree, std::move(node), place.substr(0, dot));
}

/// The recipe without all that is not asked for, but for its texture.
Recipe bare_recipe(const Recipe& recipe) {
    Recipe bare = recipe;
    bare.paint = mask_strokes(recipe.paint);
    bare.controls.clear();
    bare.animation = {};
    bare.bump = {};
    bare.material = {};
    if (bare.precision.kind == PrecisionKind::fixed) bare.precision = {};
    return bare;
}

/// Points of the solid on a ball in the unit box, spread evenly along a spiral.
std::vector<Vec3d> ball_points(const Recipe& recipe) {
    const Affine3 map = texture_from_solid(recipe);
    std::vector<Vec3d> points;
    const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (std::size_t i = 0; i < points_on_ball; ++i) {
        const double z = 1.0 - (2.0 * double(i) + 1.0) / double(points_on_ball);
        const double r = std::sqrt(1.0 - z * z), angle = turn * double(i);
        points.push_back(map(0.5 * Vec3d(r * std::cos(angle), r * std::sin(angle), z)));
    }
    return points;
}

/// The least and the largest value of a graph that gives a number, on a ball.
std::array<double, 2> range_of(const Recipe& recipe) {
    const GraphEvaluator evaluate(recipe.texture);
    GraphEvaluator::Scratch scratch = evaluate.make_scratch();
    const std::vector<Vec3d> points = ball_points(recipe);
    const std::vector<Footprint> footprints(points.size());
    std::vector<GraphSample> samples(points.size());
    evaluate(points, footprints, scratch, samples);
    const auto value = [](const GraphSample& sample) { return sample.channels[0].value; };
    const auto [low, high] = std::ranges::minmax(samples, {}, value);
    return {value(low), value(high)};
}

bool is_its_own_grey(const std::array<double, 2>& range) {
    constexpr double hair = 1e-3;
    return range[0] >= -hair && range[1] <= 1.0 + hair && range[1] - range[0] > least_contrast;
}

}  // namespace

NodeLook look_at(const Recipe& recipe, const std::string& place) {
    const Recipe bare = bare_recipe(recipe);
    RecipeTree tree(bare);
    const RecipeTree whole(recipe);
    const Json* node = whole.find(place);
    if (!node) refuse_edit("nothing stands at \"" + place + "\"");
    for (const std::string_view channel : enum_names<Channel>)
        if (const std::string at = join_path("material", channel); tree.find(at)) tree.vacate(at);
    const Json shown = without_marks(at_its_point(whole, *node, place));
    tree.put("texture", shown);
    NodeLook look{tree.finish("", place).recipe, {}};
    const TextureGraph& graph = look.recipe.texture;
    if (graph.nodes[graph.result].wire != Wire::number || !graph_masks(graph).empty()) return look;
    const std::array<double, 2> range = range_of(look.recipe);
    if (is_its_own_grey(range) || !(range[1] > range[0])) return look;
    tree.put("texture",
             {{"node", "remap"}, {"in_low", range[0]}, {"in_high", range[1]}, {"input", shown}});
    return {tree.finish("", place).recipe, range};
}

bool reads_masks(const Recipe& recipe) {
    return !first_mask_node(recipe.texture, GraphOutput::color).empty();
}

}  // namespace burl
