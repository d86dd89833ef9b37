// Recipes that share an atlas, against bakes of each recipe over the whole of the same atlas.
#include "app/bake/shared_pictures.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <stop_token>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/bake/job.h"
#include "app/bake/material.h"
#include "app/bake/texture.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/build/block_levels.h"
#include "atlas/solid/texel_owners.h"
#include "tests/app/support/kept_samples.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

constexpr std::uint32_t shared_side = 128;

Recipe recipe_of_side(const std::string& name, AtlasKind kind) {
    Recipe recipe = load_recipe(name, {"atlas.size=128"});
    recipe.atlas.kind = kind;
    return recipe;
}

/// Labels of the triangles by the side of the plane x = 0 on which their first corner lies.
std::vector<std::uint32_t> halves_of(const Mesh& mesh) {
    std::vector<std::uint32_t> labels;
    for (const Triangle& triangle : mesh.triangles)
        labels.push_back(mesh.positions[triangle[0]].x < 0.0 ? 0 : 1);
    return labels;
}

Mesh torus_mesh() {
    return sample_mesh("sample:torus");
}

/// Two recipes on the halves of a torus.
class SharedHalves {
  protected:
    explicit SharedHalves(AtlasKind kind)
        : recipes{recipe_of_side("oak", kind), recipe_of_side("brick-wall", kind)} {
        shared.set_labels(halves_of(shared.mesh()));
        shared.set_recipe(recipes[0]);
    }

    /// The label of each texel; -1 where it shows nothing.
    Image<int> texel_labels() {
        Image<int> labels(shared_side, shared_side, -1);
        const std::vector<CornerOrigin> origins =
            corner_origins(shared.mesh(), shared.mesh_atlas());
        const std::vector<std::uint32_t> of_triangles = halves_of(shared.mesh());
        const SolidAtlas& solid = shared.solid();
        const TexelOwners owners(solid, shared.atlas(), OwnerReach::gutters);
        for (std::uint32_t y = 0; y < shared_side; ++y)
            for (const Span& span : solid.row(y))
                for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                    labels(x, y) = int(of_triangles[origins[3 * owners(x, y, span.map)].a / 3]);
        return labels;
    }

    /// Expects the texels of each label to be those of the image that its recipe fills alone.
    template <class Pixel>
    void expect_shares(const Image<Pixel>& all, const std::vector<Image<Pixel>>& alone) {
        const Image<int> labels = texel_labels();
        std::array<std::size_t, 2> count{};
        for (std::size_t y = 0; y < shared_side; ++y)
            for (std::size_t x = 0; x < shared_side; ++x) {
                if (labels(x, y) < 0) continue;
                const auto label = std::size_t(labels(x, y));
                ++count[label];
                ASSERT_EQ(all(x, y), alone[label](x, y)) << x << ' ' << y;
            }
        EXPECT_GT(count[0], shared_side * shared_side / 8);
        EXPECT_GT(count[1], shared_side * shared_side / 8);
    }

    const std::vector<Recipe> recipes;
    Pipeline shared{torus_mesh()};
};

class FailedShare : public SharedHalves, public testing::Test {
  protected:
    FailedShare() : SharedHalves(AtlasKind::quad) {}

    bool shows_all(const Image<Rgb8>& whole) {
        return std::ranges::equal(shared.synthesize<Rgb8>().pixels(), whole.pixels());
    }
};

TEST_F(FailedShare, LeavesNoLabelToTheNextBakeOfItsBatch) {
    const Image<Rgb8> whole = shared.synthesize<Rgb8>();
    std::stop_source stop;
    stop.request_stop();
    shared.context().stop = stop.get_token();
    const auto wanted = shared_material_pictures(recipes, Packing::gltf, false);
    EXPECT_THROW(shared_pictures<Rgba8>(shared, recipes, wanted, Packing::gltf, false), Error);
    shared.context().stop = {};
    shared.set_recipe(recipes[0]);
    EXPECT_FALSE(shows_all(whole)) << "the failed bake shows its first recipe's texels";
    shared.set_labels(halves_of(shared.mesh()));  // the same as before, as in a batch
    EXPECT_TRUE(shows_all(whole));
}

class SharedPictures : public SharedHalves, public testing::TestWithParam<AtlasKind> {
  protected:
    SharedPictures() : SharedHalves(GetParam()) {}
};

TEST_P(SharedPictures, TexelsAreThoseOfTheirRecipeAlone) {
    const auto wanted = shared_material_pictures(recipes, Packing::gltf, false);
    ASSERT_EQ(wanted.size(), 1u);
    const auto all = shared_pictures<Rgba8>(shared, recipes, wanted, Packing::gltf, false);
    ASSERT_EQ(all.size(), 2u);
    std::vector<Image<Rgba8>> colors, others;
    for (const Recipe& recipe : recipes) {
        shared.set_recipe(recipe);
        auto own = shared.pictures<Rgba8>(
            {base_color_plan(recipe), material_pictures(recipe, Packing::gltf)[0].plan});
        colors.push_back(std::move(own[0]));
        others.push_back(std::move(own[1]));
    }
    expect_shares(all[0], colors);
    expect_shares(all[1], others);
}

TEST_P(SharedPictures, NormalsAreThoseOfTheirRecipeAlone) {
    const Image<Rgb8> all = shared_normals<Rgb8>(shared, recipes, 40.0, true);
    std::vector<Image<Rgb8>> alone;
    for (const Recipe& recipe : recipes) {
        shared.set_recipe(recipe);
        alone.push_back(shared.normal_map<Rgb8>(40.0, true));
    }
    expect_shares(all, alone);
}

class SharedPatches : public SharedHalves, public testing::Test {
  protected:
    SharedPatches() : SharedHalves(AtlasKind::patch) {}
};

/// Recipes of different spaces, with paint and a mask of the shape.
std::vector<Recipe> mixed_recipes(AtlasKind kind) {
    std::vector<Recipe> mixed{recipe_of_side("oak", kind), recipe_of_side("brick-wall", kind)};
    const Recipe worn = parse_recipe(
        R"({"texture": {"node": "occlusion"}, "material": {"roughness": {"node": "curvature"}},
            "bump": {"height": 0.01, "input": {"node": "occlusion"}}})",
        "worn");
    mixed[0].texture = worn.texture;
    mixed[0].bump = worn.bump;
    mixed[1].solid.space = SolidSpace::object;
    mixed[1].paint.emplace_back().points = {Vec3d(-0.5, 0.0, 0.1), Vec3d(0.9, 0.1, 0.1)};
    mixed[1].paint.back().radius = 0.3;
    return mixed;
}

TEST_P(SharedPictures, BandsAreRowsOfTheWhole) {
    for (const std::vector<Recipe>& some : {recipes, mixed_recipes(GetParam())}) {
        const auto wanted = shared_material_pictures(some, Packing::gltf, true);
        const auto whole = shared_pictures<RgbaF>(shared, some, wanted, Packing::gltf, true);
        const auto normals = shared_normals<RgbF>(shared, some, 40.0, true);
        std::size_t bands = 0, normal_bands = 0;
        const auto same_rows = [](std::size_t first, const auto& rows, const auto& all) {
            for (std::size_t y = 0; y < rows.height(); ++y)
                ASSERT_TRUE(std::ranges::equal(rows.row(y), all.row(first + y))) << first + y;
        };
        shared_pictures_in_bands<RgbaF>(
            shared, some, wanted, Packing::gltf, true, 48,
            [&](std::size_t first, const std::vector<Image<RgbaF>>& rows) {
                EXPECT_EQ(first, 48 * bands++);
                ASSERT_EQ(rows.size(), whole.size());
                for (std::size_t i = 0; i < rows.size(); ++i) same_rows(first, rows[i], whole[i]);
            });
        shared_normals_in_bands(shared, some, 40.0, true, 48,
                                [&](std::size_t first, const Image<RgbF>& rows) {
                                    EXPECT_EQ(first, 48 * normal_bands++);
                                    same_rows(first, rows, normals);
                                });
        EXPECT_EQ(bands, 3u);
        EXPECT_EQ(normal_bands, 3u);
    }
}

TEST_P(SharedPictures, MixedSpacesPaintAndMasksAreThoseOfTheirRecipeAlone) {
    const std::vector<Recipe> mixed = mixed_recipes(GetParam());
    const auto wanted = shared_material_pictures(mixed, Packing::gltf, false);
    const auto all = shared_pictures<Rgba8>(shared, mixed, wanted, Packing::gltf, false);
    std::vector<Image<Rgba8>> alone;
    for (const Recipe& recipe : mixed) {
        shared.set_recipe(recipe);
        const Image<Rgb8> color = shared.synthesize<Rgb8>();
        alone.push_back(converted<Rgba8>(color, [](const Rgb8& p) {
            return Rgba8{p.r, p.g, p.b, 255};
        }));
    }
    expect_shares(all[0], alone);
}

TEST_F(SharedPatches, LevelsMixNoRecipesWhileTheyArePure) {
    std::vector<Recipe> plain = recipes;
    for (std::size_t i = 0; i < 2; ++i) {
        plain[i] = load_recipe("marble", {"atlas.size=128"});
        plain[i].atlas.kind = AtlasKind::patch;
        plain[i].texture = parse_recipe(i == 0 ? R"({"texture": {"node": "constant", "value": 0}})"
                                               : R"({"texture": {"node": "constant", "value": 1}})",
                                        "r")
                               .texture;
    }
    const std::uint32_t pure = last_pure_level(shared.mesh_atlas());
    ASSERT_GT(pure, 0u);
    const BakedMaterial material = bake_material(shared, {.levels = 3}, plain);
    for (std::uint32_t l = 0; l < std::min(pure, 3u); ++l)
        for (const Rgb8& pixel : std::get<Image<Rgb8>>(material.color_levels[l]).pixels())
            ASSERT_TRUE(pixel.r == 0 || pixel.r == 255) << int(pixel.r) << " in level " << l + 1;
}

TEST_F(SharedPatches, NoChartHasTwoRecipes) {
    const std::vector<CornerOrigin> origins = corner_origins(shared.mesh(), shared.mesh_atlas());
    const std::vector<std::uint32_t> labels = halves_of(shared.mesh());
    std::map<std::uint32_t, std::uint32_t> label_of_chart;
    const Atlas& atlas = shared.atlas();
    for (std::size_t t = 0; t < atlas.charts.size(); ++t) {
        const std::uint32_t label = labels[origins[3 * t].a / 3];
        EXPECT_EQ(label_of_chart.try_emplace(atlas.charts[t], label).first->second, label);
    }
    EXPECT_GT(label_of_chart.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SharedPictures,
                         testing::Values(AtlasKind::patch, AtlasKind::quad, AtlasKind::area),
                         [](const auto& one) { return std::string(to_string(one.param)); });

TEST(SharedLevels, MasksOfDifferentCutoffsAreRefused) {
    Recipe mask = load_recipe("marble", {});
    mask.name = "leaf";
    mask.material.alpha = AlphaMode::mask;
    mask.material.opacity = 0.5;
    Recipe other = mask;
    const std::vector<Recipe> alike{mask, load_recipe("oak", {}), other};
    EXPECT_NO_THROW(check_shared_levels(alike, "a.glb"));
    EXPECT_EQ(mask_cutoff(alike), mask.material.alpha_cutoff);
    other.material.alpha_cutoff = 0.25;
    EXPECT_THROW(check_shared_levels(std::vector{mask, other}, "a.glb"), Error);
    other.material.alpha = AlphaMode::blend;
    EXPECT_THROW(check_shared_levels(std::vector{mask, other}, "a.glb"), Error);
}

/// Whatever needs one recipe per atlas, or one atlas, is refused before the mesh is read, with a
/// way out.
TEST(SharedAtlas, WhatItCannotHaveIsRefusedByName) {
    const ScratchFolder folder;
    const std::string source = folder / "a.gltf";
    std::ofstream(source) << kept_samples().at("two_materials");
    BakeCommand plain;
    plain.mesh = source;
    plain.out = folder / "a.glb";
    plain.assigned = {"Wood*=wood", "Metal=marble"};
    EXPECT_NO_THROW(BakeJob(plain, {}));
    const auto refusal = [&](const auto& change) {
        BakeCommand command = plain;
        change(command);
        try {
            BakeJob(command, {});
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const auto has_a_way_out = testing::HasSubstr("--atlas-per recipe");
    EXPECT_THAT(refusal([](auto& command) { command.synth = "gl"; }), has_a_way_out);
    EXPECT_EQ(refusal([](auto& command) { command.synth = "auto"; }), "");
    const std::string shader = folder / "a.glsl", map = folder / "a.exr";
    for (const std::string per : {"scene", "recipe", "mesh", "material"}) {
        plain.atlas_per = per;
        const auto says_how_many =
            testing::HasSubstr(per == "scene" || per == "mesh" ? "2 recipes" : "2 atlases");
        EXPECT_THAT(refusal([&](auto& command) { command.emitted_glsl = shader; }), says_how_many);
        EXPECT_THAT(refusal([&](auto& command) { command.solid_map = map; }), says_how_many);
        EXPECT_THAT(refusal([](auto& command) { command.channels = {"occlusion"}; }),
                    says_how_many);
    }
    EXPECT_EQ(refusal([&](auto& command) {
                  command.assigned.pop_back();
                  command.meshes.read.choice.materials = {"Wood*"};
                  command.emitted_glsl = shader;
                  command.solid_map = map;
                  command.channels = {"occlusion"};
              }),
              "");
}

}  // namespace
}  // namespace burl
