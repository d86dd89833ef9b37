// A recipe with a PNG that has alpha, from the file to the texels: leaves on a ground whose hidden
// colour is a bright green.
#include <gtest/gtest.h>

#include "app/bench/meshes.h"
#include "app/image/image_io.h"
#include "app/pipeline/material.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/recipe_json.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

TEST(TransparentImageRecipe, HiddenColoursComeIntoNoTexel) {
    Image<Rgba8> leaves(13, 9, {0, 255, 0, 0});
    for (std::size_t y = 0; y < 9; ++y)
        for (std::size_t x = 0; x < 13; ++x)
            if ((x / 4 + y / 3) % 2 == 0) leaves(x, y) = {200, 0, 40, 255};
    const test::Scratch scratch;
    const std::vector<std::uint8_t> bytes = encode_png(leaves);
    scratch.write("leaves.png", std::string(bytes.begin(), bytes.end()));
    const std::string file = scratch.write("r.json", R"({"texture": {"node": "image",
        "file": "leaves.png"}, "solid": {"scale": 0.5}, "atlas": {"size": 32, "kind": "area"}})");
    for (const char* filter : {"none", "trapezoid", "supersample"}) {
        const Recipe recipe = load_recipe(file, {std::string("filter.kind=") + filter});
        EXPECT_TRUE(is_transparent(recipe));
        Pipeline pipeline(torus(100));
        pipeline.set_recipe(recipe);
        const auto pictures = pipeline.pictures<Rgba8>({base_color_plan(recipe)});
        int seen = 0, hidden = 0;
        for (const Rgba8& texel : pictures[0].pixels()) {
            EXPECT_EQ(texel.g, 0);
            seen += texel.a > 150;
            hidden += texel.a < 100;
        }
        EXPECT_GT(seen, 10) << filter;
        EXPECT_GT(hidden, 10) << filter;
    }
}

}  // namespace
}  // namespace burl
