// Documents that are read, written and read again keep the values that MaterialX's own shaders give
// the first (tests/app/materialx/graphs.json).
#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "app/base/json_text.h"
#include "app/materialx/materialx.h"
#include "app/materialx/write/recipe.h"
#include "app/measure/evaluate_points.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/json.h"
#include "atlas/read/read_mesh.h"
#include "procedural/graph/masks.h"
#include "tests/app/support/scratch_folder.h"
#include "tests/app/support/xml_elements.h"
#include "tests/paths.h"

namespace burl {
namespace {

const std::string samples = test::source_folder() + "/tests/app/materialx/";

/// The recipe of its own document.
Recipe written_and_read(const Recipe& recipe) {
    const std::string text = materialx::recipe_document(recipe, {}).text;
    expect_whole_document(text);
    const std::string path = samples + "written.mtlx";
    return parse_recipe(recipe_of_materialx(text, path).json, path);
}

PointFile points_of(const Json& rows) {
    PointFile file;
    for (const Json& row : rows) file.points.push_back({row[0], row[1], row[2], 0.0});
    return file;
}

double difference(const PointResult& result, const Json& expected) {
    const Vec3d color = result.float64.color.value_or(Vec3d(result.float64.value));
    double most = 0.0;
    for (int c = 0; c < int(std::min<std::size_t>(expected.size(), 3)); ++c) {
        const double value = expected[std::size_t(c)];
        most = std::max(most, std::abs(color[c] - value) / std::max(1.0, std::abs(value)));
    }
    return most;
}

TEST(MaterialXRound, WrittenDocumentsHaveTheValuesOfTheirSource) {
    const ScratchFolder scratch;
    // A square whose texture coordinates are its x and y.
    std::ofstream(scratch / "square.obj")
        << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
           "f 1/1/1 2/2/1 3/3/1 4/4/1\n";
    const Mesh mesh = read_mesh(scratch / "square.obj");
    const Json all = Json::parse(std::ifstream(samples + "graphs.json"));
    for (const auto& [name, graph] : all["graphs"].items()) {
        SCOPED_TRACE(name);
        const Recipe recipe = written_and_read(load_recipe(samples + "graphs.mtlx#m_" + name));
        const bool masks = !first_mask_node(recipe.texture, GraphOutput::color).empty();
        const auto results =
            evaluate_points(recipe, points_of(all[graph["on_square"] ? "on_square" : "points"]),
                            masks ? &mesh : nullptr);
        // The document's numbers are floats.
        const double tolerance = graph["tolerance"].get<double>() + 1e-5;
        for (std::size_t i = 0; i < results.size(); ++i)
            EXPECT_LE(difference(results[i], graph["values"][i]), tolerance) << i;
    }
    EXPECT_GE(all["graphs"].size(), 100u);
}

}  // namespace
}  // namespace burl
