// Node graphs held to MaterialX's own shaders: graphs.mtlx has a material for each graph, and
// graphs.json the values that the shaders of MaterialX's generator draw (docs/lab/materialx.md).
#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "app/measure/evaluate_points.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/json.h"
#include "atlas/read/read_mesh.h"
#include "procedural/graph/masks.h"
#include "tests/app/support/scratch_folder.h"
#include "tests/paths.h"

namespace burl {
namespace {

using Json = nlohmann::ordered_json;

const std::string folder = test::source_folder() + "/tests/app/materialx/";

Json reference() {
    return Json::parse(std::ifstream(folder + "graphs.json"));
}

PointFile points_of(const Json& rows) {
    PointFile file;
    for (const Json& row : rows) file.points.push_back({row[0], row[1], row[2], 0.0});
    return file;
}

/// A square whose texture coordinates are its x and y, v upwards.
Mesh square(const ScratchFolder& scratch) {
    std::ofstream(scratch / "square.obj")
        << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
           "f 1/1/1 2/2/1 3/3/1 4/4/1\n";
    return read_mesh(scratch / "square.obj");
}

/// The largest difference of a graph's values, relative to values above 1.
double error_of(const std::vector<PointResult>& results, const Json& expected) {
    double error = 0.0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const Vec3d color = results[i].float64.color.value_or(Vec3d(results[i].float64.value));
        const std::array<double, 3> got{color.x, color.y, color.z};
        for (std::size_t c = 0; c < std::min<std::size_t>(expected[i].size(), 3); ++c) {
            const double value = expected[i][c];
            error = std::max(error, std::abs(got[c] - value) / std::max(1.0, std::abs(value)));
        }
    }
    return error;
}

TEST(MaterialXReference, GraphsHaveTheValuesOfMaterialXsOwnShaders) {
    const ScratchFolder scratch;
    const Mesh mesh = square(scratch);
    const Json all = reference();
    const PointFile points = points_of(all["points"]), on_square = points_of(all["on_square"]);
    for (const auto& [name, graph] : all["graphs"].items()) {
        const Recipe recipe = load_recipe(folder + "graphs.mtlx#m_" + name);
        const bool flat = graph["on_square"];
        const bool masks = !first_mask_node(recipe.texture, GraphOutput::color).empty();
        const double error =
            error_of(evaluate_points(recipe, flat ? on_square : points, masks ? &mesh : nullptr),
                     graph["values"]);
        EXPECT_LE(error, graph["tolerance"].get<double>()) << name;
    }
    EXPECT_GE(all["graphs"].size(), 100u);
}

}  // namespace
}  // namespace burl
