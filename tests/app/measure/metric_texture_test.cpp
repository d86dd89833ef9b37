// The textures atlases are judged with, against the recipe's own evaluation and sRGB's formula.
#include "app/measure/metric_texture.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include "procedural/color/srgb.h"
#include "procedural/model/metric_marble.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

/// The sheet, moved and scaled.
Mesh far_sheet() {
    Mesh mesh = made::grid(5, 3);
    for (Vec3d& p : mesh.positions) p = 7.0 * p + Vec3d(100.0, -30.0, 2.0);
    return mesh;
}

TEST(MetricTexture, NormalisedMeshHasHalfDiagonalOne) {
    for (const Mesh& mesh : {far_sheet(), made::grid(5, 3)}) {
        const Box3 box = bounding_box(normalised(mesh));
        EXPECT_NEAR(glm::length(box.centre()), 0.0, 1e-9);
        EXPECT_NEAR(0.5 * glm::length(box.size()), 1.0, 1e-9);
    }
}

TEST(MetricTexture, RecipesKeepTheirPlaceOnTheMesh) {
    const Mesh mesh = far_sheet(), unit = normalised(mesh);
    for (const char* space : {"unit", "object"}) {
        const Recipe recipe = load_recipe("marble", {std::string("solid.space=") + space});
        const MetricTexture texture = recipe_texture(recipe, mesh);
        EXPECT_EQ(texture.name, recipe.name);
        EXPECT_GT(texture.detail, 0.0);
        EXPECT_LE(texture.detail, 0.025);
        const Affine3 to_texture = texture_from_mesh(recipe, mesh);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const Vec3d expected = evaluate_color(
                plain_texture(recipe.texture)->colors,
                evaluate_field(*plain_texture(recipe.texture), to_texture(mesh.positions[i])));
            const Vec3d difference = texture.color(unit.positions[i]) - expected;
            EXPECT_LT(glm::length(difference), 1e-9) << space << " " << i;
        }
    }
}

TEST(MetricTexture, MetricMarbleIsGrey) {
    const Vec3d p(0.5, -0.25, 0.125);
    EXPECT_EQ(metric_marble_texture().color(p), Vec3d(metric_marble(p)));
}

TEST(MetricTexture, EightBitsAreThoseOfSrgb) {
    const StoredValue stored = in_8bit_srgb();
    for (double value = 0.0; value <= 1.0; value += 0.00137) {
        const double code = std::round(255.0 * srgb_encode(value));
        EXPECT_NEAR(255.0 * srgb_encode(stored(value)), code, 1e-9) << value;
        EXPECT_EQ(stored(stored(value)), stored(value));
    }
    EXPECT_EQ(stored(1.0), 1.0);
    EXPECT_EQ(stored(-0.5), 0.0);
}

}  // namespace
}  // namespace burl
