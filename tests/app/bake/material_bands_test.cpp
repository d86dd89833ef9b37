// A material whose pictures come in bands of rows has the bytes of one whose pictures are whole in
// floats, of which codes, means, masks and the roughness of normals are made here as defined.
#include "app/bake/material_bands.h"

#include <cmath>

#include <gtest/gtest.h>

#include "app/bake/material.h"
#include "app/bake/shared_pictures.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/json.h"
#include "atlas/build/alpha_levels.h"
#include "atlas/build/block_levels.h"
#include "atlas/build/normal_levels.h"
#include "tests/app/support/material_recipes.h"

namespace burl {
namespace {

struct BandsCase {
    AtlasKind kind;
    std::uint32_t size;
    const char* alpha;
    FilterKind filter = FilterKind::none;
};

/// Larger than a band at all sizes of these tests.
Recipe recipe_of(const BandsCase& one) {
    Json json = Json::parse(test::all_channels);
    json["material"]["alpha"] = one.alpha;
    if (std::string(one.alpha) != "opaque") json["material"]["opacity"] = "share";
    Recipe recipe = parse_recipe(json.dump(), "all");
    recipe.filter.kind = one.filter;
    recipe.atlas.kind = one.kind;
    recipe.atlas.size = one.size;
    return recipe;
}

/// The codes of a level by way of four components.
PictureImage codes_of(const Image<RgbaF>& level, bool is_color, std::size_t components) {
    const Image<Rgba8> codes = is_color ? to_rgba8(level, mean_color(level)) : to_linear8(level);
    if (components == 4) return codes;
    if (components == 1) return converted<Grey8>(codes, [](const Rgba8& p) { return p.r; });
    return converted<Rgb8>(codes, [](const Rgba8& p) { return Rgb8{p.r, p.g, p.b}; });
}

void expect_same(const PictureImage& found, const PictureImage& wanted, const std::string& what) {
    EXPECT_TRUE(found == wanted) << what;
}

PictureImage picture_of(const BakedImage& image) {
    if (const auto* clear = std::get_if<Image<Rgba8>>(&image)) return *clear;
    return std::get<Image<Rgb8>>(image);
}

class MaterialBands : public testing::TestWithParam<BandsCase> {};

TEST_P(MaterialBands, HaveTheBytesOfWholePictures) {
    const Recipe recipe = recipe_of(GetParam());
    Pipeline pipeline(sample_mesh("sample:torus"));
    pipeline.set_recipe(recipe);
    const MeshAtlas& atlas = pipeline.mesh_atlas();
    MaterialAsked asked{Packing::separate, 8, 6, true};
    ASSERT_LT(rows_of_bands(recipe.atlas.size, 12), recipe.atlas.size);
    const BakedMaterial baked = bake_material(pipeline, asked);

    const std::span recipes(&recipe, 1);
    const auto wanted = shared_material_pictures(recipes, asked.packing, true);
    const auto whole = shared_pictures<RgbaF>(pipeline, recipes, wanted, asked.packing, true);
    ASSERT_EQ(baked.pictures.size(), wanted.size());
    ASSERT_GE(wanted.size(), 10u);
    const std::size_t clear = is_transparent(recipe) ? 4 : 3;
    expect_same(picture_of(baked.color), codes_of(whole[0], true, clear), "colour");
    const auto colors = recipe.material.alpha == AlphaMode::mask
                            ? masked_levels(atlas, whole[0], 0.5f, 6)
                            : block_levels(atlas, whole[0], 6);
    ASSERT_EQ(baked.color_levels.size(), 6u);
    for (std::size_t l = 0; l < 6; ++l)
        expect_same(picture_of(baked.color_levels[l]), codes_of(colors[l], true, clear), "levels");
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const bool is_color = wanted[i].plan.is_color;
        auto levels = block_levels(atlas, whole[i + 1], 6);
        if (wanted[i].roughness) {
            const auto rough = converted<float>(whole[i + 1], [](const RgbaF& p) { return p.r; });
            const auto normals =
                normal_levels(atlas, pipeline.normal_map<RgbF>(40.0, true), rough, 6);
            ASSERT_EQ(baked.normal_levels.size(), 6u);
            for (std::size_t l = 0; l < 6; ++l) {
                EXPECT_EQ(baked.normal_levels[l], normals[l].normals);
                levels[l] = converted<RgbaF>(normals[l].roughness, [](float r) {
                    return RgbaF{r, r, r, 1.0f};
                });
            }
        }
        expect_same(baked.pictures[i].image, codes_of(whole[i + 1], is_color, wanted[i].components),
                    wanted[i].name);
        ASSERT_EQ(baked.pictures[i].levels.size(), 6u);
        for (std::size_t l = 0; l < 6; ++l)
            expect_same(baked.pictures[i].levels[l],
                        codes_of(levels[l], is_color, wanted[i].components), wanted[i].name);
    }
}

INSTANTIATE_TEST_SUITE_P(Cases, MaterialBands,
                         testing::Values(BandsCase{AtlasKind::chart, 700, "opaque"},
                                         BandsCase{AtlasKind::chart, 701, "blend"},
                                         BandsCase{AtlasKind::patch, 701, "opaque"},  // no halves
                                         BandsCase{AtlasKind::quad, 1024, "mask"},
                                         BandsCase{AtlasKind::patch, 704, "mask"},
                                         BandsCase{AtlasKind::chart, 700, "blend",
                                                   FilterKind::trapezoid}));

}  // namespace
}  // namespace burl
