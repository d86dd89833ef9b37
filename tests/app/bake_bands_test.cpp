// Textures that come a band of rows at a time are those that come whole.
#include <gtest/gtest.h>

#include "app/bake_texture.h"
#include "app/convert_image.h"
#include "app/parameters.h"
#include "app/sample_meshes.h"
#include "atlas/block_levels.h"

namespace burl {
namespace {

/// Larger than a band.
Recipe recipe_of(AtlasKind kind, std::uint32_t size) {
    Recipe recipe;
    recipe.atlas.kind = kind;
    recipe.atlas.size = size;
    return recipe;
}

TEST(BakeBands, RowsAreThoseOfTheTexture) {
    Pipeline pipeline(sample_mesh("sample:teapot"));
    pipeline.set_recipe(recipe_of(AtlasKind::patch, 3000));
    ASSERT_TRUE(pipeline.has_bands());
    const Image<RgbF> whole = pipeline.synthesize<RgbF>();
    std::size_t next = 0, bands = 0;
    pipeline.synthesize_in_bands([&](std::size_t first, const Image<RgbF>& rows) {
        EXPECT_EQ(first, next);
        ASSERT_EQ(rows.width(), whole.width());
        EXPECT_TRUE(first + rows.height() == whole.height() || rows.height() % 2 == 0);
        for (std::size_t y = 0; y < rows.height(); ++y)
            ASSERT_TRUE(std::ranges::equal(rows.row(y), whole.row(first + y))) << first + y;
        next = first + rows.height();
        ++bands;
    });
    EXPECT_EQ(next, whole.height());
    EXPECT_GT(bands, 1u);
}

TEST(BakeBands, LevelsAreThoseOfTheWholeTexture) {
    int halved = 0;
    for (const AtlasKind kind : {AtlasKind::patch, AtlasKind::quad})
        for (const auto& [image, size] :
             {std::pair(ImageKind::rgb8, 256u), std::pair(ImageKind::rgb16, 512u),
              std::pair(ImageKind::rgb8, 2048u)}) {
            Pipeline pipeline(sample_mesh("sample:teapot"));
            pipeline.set_recipe(recipe_of(kind, size));
            halved += halves_in_bands(pipeline.mesh_atlas());
            const BakedTexture baked = bake_texture(pipeline, image, {.count = 8});
            const Image<RgbF> whole = pipeline.synthesize<RgbF>();
            EXPECT_EQ(baked.image, convert_to(whole, image));
            EXPECT_EQ(baked.levels, bake_levels(pipeline, whole, {.count = 8}, image));
        }
    EXPECT_GE(halved, 4);  // quad atlases, and patches whose gutters are not odd
}

}  // namespace
}  // namespace burl
