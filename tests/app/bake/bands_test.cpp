// Textures that come a band of rows at a time are those that come whole.
#include <gtest/gtest.h>

#include "app/bake/texture.h"
#include "app/base/file_bytes.h"
#include "app/image/convert_image.h"
#include "app/image/image_io.h"
#include "app/paint/texture.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/parameters.h"
#include "app/surface/sample_meshes.h"
#include "atlas/build/block_levels.h"
#include "tests/app/support/export_scene.h"
#include "tests/app/support/scratch_folder.h"

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
            EXPECT_EQ(baked.levels, convert_to(pipeline.levels(whole, 8, {}), image));
        }
    EXPECT_GE(halved, 4);  // quad atlases, and patches whose gutters are not odd
}

/// A stroke that reaches many bands and one that reaches few.
std::vector<PaintStroke> strokes() {
    PaintStroke across, dot;
    across.points = {Vec3d(-0.5, -0.2, 0.1), Vec3d(0.5, 0.2, 0.1)};
    across.radius = 0.2;
    across.opacity = 0.7;
    across.color = {200, 40, 10};
    dot.points = {Vec3d(0.1, 0.1, 0.2)};
    return {across, dot};
}

void expect_bands_are_the_texture(Pipeline& pipeline, std::size_t least) {
    ASSERT_TRUE(pipeline.has_bands());
    const Image<RgbF> whole = pipeline.synthesize<RgbF>();
    const StageRecords records = pipeline.records();
    Image<RgbF> bands(whole.width(), whole.height());
    std::size_t count = 0;
    const auto take = [&](std::size_t first, const Image<RgbF>& rows) {
        std::ranges::copy(rows.pixels(), &bands(0, first));
        ++count;
    };
    pipeline.synthesize_in_bands(take, 1);
    EXPECT_GT(count, least - 1);
    EXPECT_EQ(bands, whole);
    for (const Stage stage : {Stage::synthesis, Stage::paint}) {
        const StageCost &at_once = records[stage].last, &now = pipeline.records()[stage].last;
        EXPECT_EQ(now.work.texels, at_once.work.texels);
        EXPECT_EQ(now.bytes, at_once.bytes);
    }
}

/// A way to work a texture out, and whether it is by forward differences.
struct Way {
    std::string preset;
    std::vector<std::string> edits{};
    bool forward = false;
};

TEST(BakeBands, EveryWayOfTheHostAndPaintComeInBands) {
    const std::vector<Way> ways{{"marble"},
                                {"marble", {}, true},
                                {"marble", {"precision.kind=float64"}},
                                {"marble", {"precision.kind=fixed"}},
                                {"planet", {"filter.kind=trapezoid", "precision.kind=float64"}},
                                {"cloudy-planet"},
                                {"cloudy-planet", {"filter.kind=supersample"}},
                                {"moonlit-clouds", {"precision.kind=float64"}},
                                {"wood-grain", {"filter.kind=exact"}}};
    for (const Way& way : ways)
        for (const bool painted : {false, true}) {
            SCOPED_TRACE(way.preset + (way.edits.empty() ? "" : " " + way.edits[0]));
            Recipe recipe = load_recipe(way.preset, way.edits);
            recipe.atlas.size = 150;
            if (painted) recipe.paint = strokes();
            Pipeline pipeline(sample_mesh("sample:teapot"));
            pipeline.set_recipe(recipe);
            pipeline.set_forward(way.forward);
            expect_bands_are_the_texture(
                pipeline, way.edits.empty() && way.preset == "marble" && !way.forward ? 1 : 4);
        }
}

TEST(BakeBands, PaintThatComesInPartsIsThatOfOneLayer) {
    Recipe recipe = load_recipe("stripes", {});
    recipe.atlas.size = 1200;  // two parts
    Pipeline pipeline(sample_mesh("sample:teapot"));
    pipeline.set_recipe(recipe);
    Image<Rgb8> expected = pipeline.synthesize<Rgb8>();
    PaintLayer layer(pipeline.solid(), 1);
    layer.update(strokes());
    const PaintMixer<Rgb8> mixer;
    for (const std::uint32_t tile : layer.painted_tiles())
        mixer.mix(layer, tile, expected, expected);
    const auto columns = layer.tiles().columns();
    EXPECT_GT(layer.painted_tiles().back() / columns, 60u);
    EXPECT_LT(layer.painted_tiles().front() / columns, 20u);
    recipe.paint = strokes();
    pipeline.set_recipe(recipe);
    EXPECT_EQ(pipeline.synthesize<Rgb8>(), expected);
}

TEST(BakeBands, LevelsOfEveryRuleAreThoseOfTheWholeTexture) {
    for (const auto& [rule, size] : {std::pair(LevelRule{}, 3072u),
                                     {LevelRule{.direct = true}, 3072u},
                                     {LevelRule{.sharp = true}, 3072u},
                                     {LevelRule{}, 3071u},
                                     {LevelRule{.direct = true}, 3071u}}) {
        Recipe recipe = load_recipe("stripes", {});
        recipe.atlas.size = size;  // three bands
        recipe.paint = strokes();
        Pipeline pipeline(sample_mesh("sample:teapot"));
        pipeline.set_recipe(recipe);
        ASSERT_TRUE(halves_in_bands(pipeline.mesh_atlas()));
        std::size_t bands = 0;
        const auto levels =
            pipeline.levels_in_bands(4, rule, [&](std::size_t, const Image<RgbF>&) { ++bands; });
        EXPECT_GT(bands, 1u);
        EXPECT_EQ(levels, pipeline.levels(pipeline.synthesize<RgbF>(), 4, rule));
    }
}

TEST(BakeBands, FilesAreThoseOfTheWholeTexture) {
    const ScratchFolder folder;
    Recipe recipe = load_recipe("carved-wood", {});
    recipe.atlas.size = 512;
    Pipeline pipeline(sample_mesh("sample:teapot"));
    pipeline.set_recipe(recipe);
    for (const std::string levels : {"", "all", "sharp", "direct"}) {
        const LevelsAsked asked = levels_asked(levels, "", 512, ImageKind::rgb_float);
        ASSERT_TRUE(comes_in_bands(pipeline, asked));
        BandsWritten written = write_exr_in_bands(pipeline, folder / "bands.exr", asked);
        written.file.commit();
        EXPECT_EQ(written.levels, asked.count);
        ExportOptions options;
        const Image<RgbF> whole = pipeline.synthesize<RgbF>();
        if (asked.count > 0)
            options.levels =
                convert_to(pipeline.levels(whole, asked.count, asked.rule), ImageKind::rgb_float);
        export_scene(folder / "whole.exr", pipeline.atlas_mesh(), pipeline.atlas(), whole, options);
        EXPECT_EQ(read_file_bytes(folder / "bands.exr"), read_file_bytes(folder / "whole.exr"))
            << levels;
    }
}

TEST(BakeBands, LayoutsAreMadeAgainWhereNeighboursWereGivenBack) {
    Pipeline pipeline(sample_mesh("sample:teapot"));
    pipeline.set_recipe(recipe_of(AtlasKind::patch, 128));
    const std::uint64_t edges = pipeline.connectivity().interior_edges;
    pipeline.mesh_atlas();
    pipeline.release_neighbours();
    EXPECT_TRUE(pipeline.connectivity().neighbours.empty());
    EXPECT_EQ(pipeline.connectivity().interior_edges, edges);
    pipeline.set_recipe(recipe_of(AtlasKind::quad, 128));
    Pipeline fresh(sample_mesh("sample:teapot"));
    fresh.set_recipe(recipe_of(AtlasKind::quad, 128));
    EXPECT_EQ(pipeline.atlas().corners, fresh.atlas().corners);
    EXPECT_FALSE(pipeline.connectivity().neighbours.empty());
}

}  // namespace
}  // namespace burl
